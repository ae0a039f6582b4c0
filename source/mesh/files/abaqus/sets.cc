#include "mesh/files/abaqus/sets.h"

namespace birdstrike
{
  namespace
  {
    void append(FileLines &lines, std::vector<ImportedMesh::Id> &to,
                const std::vector<ImportedMesh::Id> from) // a copy: it may be the same
    {
      lines.add_listed(from.size());
      to.insert(to.end(), from.begin(), from.end());
    }

    /// Cubit's names of element blocks and side sets: EB3, SS7.
    std::optional<unsigned int> number_after(const std::string &letters, const std::string &name)
    {
      if (!name.starts_with(letters) || name.size() < 3 || name.size() > 10 ||
          name.find_first_not_of("0123456789", 2) != std::string::npos)
        return {};
      return static_cast<unsigned int>(std::stoul(name.substr(2)));
    }
  } // namespace

  std::size_t AbaqusSets::group_of(const Kind kind, const std::size_t scope, const std::string &name)
  {
    const auto [found, is_new] = groups.emplace(Name{kind, scope, upper(name)}, mesh.groups.size());
    if (is_new)
      {
        ImportedMesh::Group &group = mesh.groups.emplace_back();
        group.name                 = name;
        group.boundary_number      = number_after("SS", found->first.name);
        if (kind == Kind::elements)
          group.material_number = number_after("EB", found->first.name);
      }
    return found->second;
  }

  std::optional<std::size_t> AbaqusSets::find(const Kind kind, const std::size_t scope, const std::string &name) const
  {
    const auto found = groups.find({kind, scope, upper(name)});
    return found != groups.end() ? std::optional(found->second) : std::nullopt;
  }

  bool AbaqusSets::add(const ImportedMesh::Element &element, const unsigned int dim)
  {
    auto &list = mesh.elements[dim];
    list.push_back(element);
    const Place place{dim, static_cast<std::uint32_t>(list.size() - 1)};
    const auto [found, is_new] = places.emplace(element.id, place);
    if (is_new || found->second.dim > 0)
      return is_new;
    found->second = place;
    return true;
  }

  void AbaqusSets::add_not_offered(const ImportedMesh::NotOffered &element)
  {
    mesh.elements_not_offered[0].push_back(element);
    places.emplace(element.id, Place{0, 0});
  }

  const ImportedMesh::Element &AbaqusSets::element(const Id id) const
  {
    const Place &found = places.at(id);
    return mesh.elements[found.dim][found.place];
  }

  void AbaqusSets::add_element(const std::size_t group, const Id id)
  {
    if (const auto found = places.find(id); found != places.end())
      mesh.groups[group].elements[found->second.dim].push_back(id);
    else
      awaited[group].push_back(id);
  }

  void AbaqusSets::add_elements(const std::size_t group, const std::size_t of)
  {
    for (unsigned int d = 0; d <= 3; ++d)
      append(lines, mesh.groups[group].elements[d], mesh.groups[of].elements[d]);
    append(lines, awaited[group], awaited[of]);
  }

  void AbaqusSets::add_nodes(const std::size_t group, const std::size_t of)
  {
    append(lines, mesh.groups[group].nodes, mesh.groups[of].nodes);
  }

  void AbaqusSets::add_nodes_of(const Id id, ImportedMesh::Group &group) const
  {
    if (places.at(id).dim == 0)
      return;
    const auto &nodes = element(id).nodes;
    group.nodes.insert(group.nodes.end(), nodes.begin(), nodes.begin() + (1 << places.at(id).dim));
  }

  void AbaqusSets::add_nodes_of_elements(const std::size_t group, const std::size_t of)
  {
    for (unsigned int d = 1; d <= 3; ++d)
      {
        lines.add_listed(mesh.groups[of].elements[d].size());
        for (const Id id : mesh.groups[of].elements[d])
          add_nodes_of(id, mesh.groups[group]);
      }
    append(lines, awaited_for_nodes[group], awaited[of]);
  }

  void AbaqusSets::add_awaited()
  {
    for (const auto &[group, ids] : awaited)
      for (const Id id : ids)
        if (const auto found = places.find(id); found != places.end())
          mesh.groups[group].elements[found->second.dim].push_back(id);
    for (const auto &[group, ids] : awaited_for_nodes)
      for (const Id id : ids)
        if (const auto found = places.find(id); found != places.end())
          add_nodes_of(id, mesh.groups[group]);
  }

  void AbaqusSets::add_sides(const std::size_t group, const std::size_t scope, const std::string &elements,
                             const std::string &label)
  {
    faces.push_back({group, scope, elements, label});
  }

  std::vector<AbaqusSets::Id> AbaqusSets::elements_of(const Face &face) const
  {
    std::vector<Id> ids;
    const auto [scope, word] = scopes.split(face.elements, face.scope);
    auto set                 = find(Kind::elements, face.scope, face.elements);
    if (!set)
      set = find(Kind::elements, scope, std::string(word));
    if (set)
      for (const unsigned int d : {2, 3})
        append(lines, ids, mesh.groups[*set].elements[d]);
    else if (!word.empty() && word.size() < 12 && word.find_first_not_of("0123456789") == std::string::npos)
      if (const Id id = scopes[scope].first_id + std::stoll(std::string(word)); places.count(id) > 0)
        ids = {id};
    return ids;
  }

  void AbaqusSets::add_sides(const Face &face)
  {
    const auto &[group, scope, elements, label] = face;
    const unsigned int number                   = label.empty() ? 0 : static_cast<unsigned int>(label.back() - '0');
    for (const Id id : elements_of(face))
      for (unsigned int s = 0; s < 2 * places.at(id).dim; ++s)
        if (label.empty() || s + 1 == number)
          {
            const auto &nodes = element(id).nodes;
            auto       &side  = mesh.groups[group].sides.emplace_back();
            if (places.at(id).dim == 2)
              side = {nodes[s], nodes[(s + 1) % 4]};
            else
              for (const unsigned int k : ImportedMesh::brick_sides[s])
                side.push_back(nodes[k]);
          }
  }

  /// "Blade-1.root", then "nset.root", "surface.Blade-1.root": what tells sets of one name from one another.
  void AbaqusSets::add_longer_names()
  {
    for (const auto &[name, group] : groups)
      {
        ImportedMesh::Group     &named = mesh.groups[group];
        std::vector<std::string> all;
        for (const std::string &owner : scopes[name.scope].names)
          all.push_back(owner + '.' + named.name);
        const std::string kind = name.kind == Kind::nodes      ? "nset."
                                 : name.kind == Kind::elements ? "elset."
                                                               : "surface.";
        named.other_names      = all;
        named.other_names.push_back(kind + named.name);
        for (const std::string &longer : all)
          named.other_names.push_back(kind + longer);
      }
  }

  void AbaqusSets::finish()
  {
    add_awaited();
    for (const Face &face : faces)
      add_sides(face);
    add_longer_names();
  }
} // namespace birdstrike
