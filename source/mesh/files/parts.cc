#include "mesh/files/parts.h"

#include <birdstrike/core/errors.h>

#include <algorithm>
#include <map>
#include <unordered_set>

namespace birdstrike
{
  namespace
  {
    using Id         = ImportedMesh::Id;
    using Group      = ImportedMesh::Group;
    using NotOffered = ImportedMesh::NotOffered;
    using Ids        = std::unordered_set<Id>;

    const std::string entry = "Blade/Mesh/Parts";

    bool has_elements(const Group &group, const unsigned int dim) ///< or such as have no dimension here
    {
      return !group.elements[dim].empty() || !group.elements[0].empty();
    }

    /// Groups by what they hold: those of the same elements have the same number.
    class PartNumbers
    {
    public:
      unsigned int operator[](const Group &group)
      {
        std::array<std::vector<Id>, 4> elements = group.elements;
        elements[1].clear();
        for (auto &ids : elements)
          {
            std::sort(ids.begin(), ids.end());
            ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
          }
        return numbers.emplace(std::move(elements), static_cast<unsigned int>(numbers.size())).first->second;
      }

    private:
      std::map<std::array<std::vector<Id>, 4>, unsigned int> numbers;
    };

    class PartChoice
    {
    public:
      PartChoice(ImportedMesh &mesh, const unsigned int dim, const std::string &path) : mesh(mesh), dim(dim), path(path)
      {
      }

      void keep(const std::string &parts)
      {
        is_all = parts.empty();
        if (!is_all)
          choose(parts);
        refuse_elements();
        if (!is_all)
          for (unsigned int d = dim; d <= 3; ++d)
            std::erase_if(mesh.elements[d], [&](const auto &element) { return chosen[d].count(element.id) == 0; });
        if (!is_all && mesh.elements[dim].empty())
          refuse_empty(parts);
        refuse_what_is_done();
        std::erase_if(mesh.groups, [](const Group &group) { return group.is_part_only; });
        restore_ids();
      }

    private:
      ImportedMesh      &mesh;
      const unsigned int dim;
      const std::string &path;

      bool               is_all = true;
      std::array<Ids, 4> chosen; ///< elements, by dimension

      [[noreturn]] void refuse(const NotOffered &thing) const
      {
        const auto &[what, remedy] = mesh.reasons[thing.reason];
        const std::size_t mark     = std::min(what.find('#'), what.size());
        const Id          id       = mesh.has_lists ? thing.id % ImportedMesh::ids_of_a_list : thing.id;
        const std::string where    = thing.line > 0 ? "', line " + std::to_string(thing.line) : "'";
        throw InputError("Blade/Mesh/File: '" + path + where + ": " + what.substr(0, mark) +
                         (mark < what.size() ? std::to_string(id) + what.substr(mark + 1) : std::string()) + ".\n" +
                         remedy);
      }

      /// Names of groups of the blade's own dimension go before those of others.
      void choose(const std::string &parts)
      {
        NamedIds                                     names(NamedIds::Of::parts);
        PartNumbers                                  numbers;
        std::map<unsigned int, std::vector<Group *>> groups;
        for (const bool is_first : {true, false})
          {
            const NamedIds before = names;
            for (Group &group : mesh.groups)
              {
                const bool is_of_blade = has_elements(group, dim) || !group.not_read.empty();
                if (is_first ? !is_of_blade : is_of_blade || !has_elements(group, 5 - dim))
                  continue;
                auto all = group.all_names();
                if (group.material_number)
                  all.push_back(std::to_string(*group.material_number));
                std::erase_if(all, [&](const std::string &name) { return before.knows(name); });
                if (all.empty())
                  continue;
                const unsigned int number = numbers[group];
                groups[number].push_back(&group);
                names.add({all, {number}, group.not_read});
              }
          }
        for (const unsigned int number : names.parse(parts, entry))
          for (unsigned int d = 0; d <= 3; ++d)
            chosen[d].insert(groups[number][0]->elements[d].begin(), groups[number][0]->elements[d].end());
      }

      void refuse_elements() const
      {
        const NotOffered *first = nullptr;
        for (unsigned int d = 0; d <= 3; ++d)
          for (const NotOffered &element : mesh.elements_not_offered[d])
            if ((is_all || chosen[d].count(element.id) > 0) && (first == nullptr || element.line < first->line))
              first = &element;
        if (first != nullptr)
          refuse(*first);
      }

      [[noreturn]] void refuse_empty(const std::string &parts) const
      {
        const auto cells = [](const unsigned int d) { return d == 2 ? "quadrilaterals" : "hexahedra"; };
        throw InputError(entry + ": '" + parts + "' holds no " + cells(dim) + ", only " + cells(5 - dim) +
                         ".\nChoose the parts that are the blade, or set Blade/Kind to " +
                         (dim == 2 ? "solid." : "shell."));
      }

      Ids nodes_of_blade() const
      {
        Ids nodes;
        for (const auto &element : mesh.elements[dim])
          nodes.insert(element.nodes.begin(), element.nodes.begin() + (1 << dim));
        return nodes;
      }

      /// Nodes of a group and of its elements.
      bool touches(const Group &group, const Ids &nodes) const
      {
        const auto is_of_blade = [&nodes](const Id node) { return nodes.count(node) > 0; };
        if (std::any_of(group.nodes.begin(), group.nodes.end(), is_of_blade))
          return true;
        for (unsigned int d = 1; d <= 3; ++d)
          {
            const Ids own(group.elements[d].begin(), group.elements[d].end());
            for (const auto &element : mesh.elements[d])
              if (own.count(element.id) > 0 &&
                  std::any_of(element.nodes.begin(), element.nodes.begin() + (1 << d), is_of_blade))
                return true;
          }
        return false;
      }

      /// To nodes of the blade, one by one or by groups.
      void refuse_what_is_done() const
      {
        const bool is_done_to_groups =
          std::any_of(mesh.groups.begin(), mesh.groups.end(), [](const Group &g) { return g.not_offered.has_value(); });
        if (mesh.nodes_not_offered.empty() && !is_done_to_groups)
          return;
        const Ids nodes = nodes_of_blade();
        for (const NotOffered &node : mesh.nodes_not_offered)
          if (nodes.count(node.id) > 0)
            refuse(node);
        for (const Group &group : mesh.groups)
          if (group.not_offered && touches(group, nodes))
            refuse(*group.not_offered);
      }

      static Id list_of(const Id id)
      {
        return id / ImportedMesh::ids_of_a_list;
      }

      void restore(std::vector<Id> &ids, const Id list) const
      {
        std::erase_if(ids, [list](const Id id) { return list_of(id) != list; });
        for (Id &id : ids)
          id %= ImportedMesh::ids_of_a_list;
      }

      void restore_ids()
      {
        if (!mesh.has_lists || mesh.elements[dim].empty())
          return;
        const Id list = list_of(mesh.elements[dim][0].id);
        for (const auto &element : mesh.elements[dim])
          if (list_of(element.id) != list)
            throw InputError(entry + ": the elements lie in several parts of the file, each with nodes of its own.\n" +
                             "Choose one part or instance, or merge them in the preprocessor.");
        std::erase_if(mesh.nodes, [list](const auto &node) { return list_of(node.first) != list; });
        for (auto &node : mesh.nodes)
          node.first %= ImportedMesh::ids_of_a_list;
        for (unsigned int d = 1; d <= 3; ++d)
          {
            std::erase_if(mesh.elements[d], [list](const auto &element) { return list_of(element.id) != list; });
            for (auto &element : mesh.elements[d])
              {
                element.id %= ImportedMesh::ids_of_a_list;
                for (Id &node : element.nodes)
                  node %= ImportedMesh::ids_of_a_list;
              }
          }
        for (Group &group : mesh.groups)
          {
            for (auto &ids : group.elements)
              restore(ids, list);
            restore(group.nodes, list);
            std::erase_if(group.sides, [list](const auto &side) { return !side.empty() && list_of(side[0]) != list; });
            for (auto &side : group.sides)
              restore(side, list);
          }
      }
    };
  } // namespace

  void keep_parts(ImportedMesh &mesh, const unsigned int dim, const std::string &parts, const std::string &path)
  {
    PartChoice(mesh, dim, path).keep(parts);
  }
} // namespace birdstrike
