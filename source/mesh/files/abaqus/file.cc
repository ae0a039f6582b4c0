#include "mesh/files/abaqus/elements.h"
#include "mesh/files/abaqus/keywords.h"
#include "mesh/files/readers.h"

#include <algorithm>
#include <cctype>

namespace birdstrike
{
  namespace
  {
    using Id     = ImportedMesh::Id;
    using Fields = std::vector<std::string_view>;
    using Kind   = AbaqusSets::Kind;

    class AbaqusFile
    {
    public:
      explicit AbaqusFile(const std::string &path) : lines(path)
      {
      }

      ImportedMesh read()
      {
        while (lines.next())
          if (const std::string_view text = trim(lines.text()); text.empty() || text.starts_with("**"))
            continue;
          else if (text[0] == '*')
            begin(parse_abaqus_keyword(lines));
          else if (const Fields fields = lines.split_at_commas(); read_line != nullptr && !fields.empty())
            (this->*read_line)(fields);
        elements.finish();
        sets.finish();
        parts.finish();
        mesh.notes.always = noted.sentences();
        return std::move(mesh);
      }

    private:
      FileLines      lines;
      ImportedMesh   mesh;
      AbaqusScopes   scopes;
      AbaqusSets     sets{mesh, lines, scopes};
      AbaqusParts    parts{mesh, lines, scopes};
      AbaqusElements elements{mesh, lines, scopes, sets, parts};
      NotedKeywords  noted;

      // the present keyword
      void (AbaqusFile::*read_line)(const Fields &) = nullptr;
      Kind                       kind               = Kind::nodes; ///< of a set
      std::optional<std::size_t> group;
      std::size_t                of           = 0; ///< scope of ids: that of the instance that is named
      bool                       is_generated = false;

      void begin(const AbaqusKeyword &k)
      {
        elements.finish();
        read_line    = nullptr;
        group        = {};
        of           = parts.present();
        is_generated = k.has("GENERATE");
        if (parts.begin(k))
          read_line = k.name == "INSTANCE" ? &AbaqusFile::read_placement : nullptr;
        else if (k.name == "NODE" || k.name == "ELEMENT" || k.name == "NSET" || k.name == "ELSET")
          begin_mesh(k);
        else if (k.name == "SURFACE")
          begin_surface(k);
        else
          pass_over(k);
      }

      void pass_over(const AbaqusKeyword &k)
      {
        const KeywordUse use = abaqus_keyword(k);
        if (use == KeywordUse::noted)
          noted.add(k.name, lines.line_number());
        if (use == KeywordUse::refused)
          lines.refuse("the keyword *" + k.name + " is not offered",
                       k.name == "INCLUDE"
                         ? "Put the text of the included file here."
                         : "It may move, join, thicken or make nodes or elements. Write the whole mesh as *NODE and "
                           "*ELEMENT into one file, in one system of coordinates, and remove the keyword.");
      }

      void begin_mesh(const AbaqusKeyword &k)
      {
        for (const char *refused : {"INPUT", "FILE"})
          if (k.has(refused))
            lines.refuse("*" + k.name + " with " + refused + " is not offered", "Write its data into this file.");
        if (k.has("INSTANCE"))
          of = parts.instance(k.value("INSTANCE"));
        if (k.name == "NODE")
          begin_nodes(k);
        else if (k.name == "ELEMENT")
          begin_elements(k);
        else
          begin_set(k);
      }

      void read_placement(const Fields &fields)
      {
        if (std::any_of(fields.begin(), fields.end(), [this](const auto field) { return lines.number(field) != 0.; }))
          parts.move_present();
      }

      Id id_of(const std::string_view field, const std::size_t scope) const
      {
        return elements.id_of(field, scope);
      }

      void begin_nodes(const AbaqusKeyword &k)
      {
        if (!scopes[of].has_mesh)
          return; // points of the assembly
        if (!k.value("SYSTEM").empty() && upper(k.value("SYSTEM")) != "R")
          lines.refuse("*NODE with SYSTEM=" + k.value("SYSTEM") + " is not offered",
                       "Allowed: rectangular coordinates x, y, z.");
        if (k.has("NSET"))
          group = sets.group_of(Kind::nodes, parts.present(), k.value("NSET"));
        read_line = &AbaqusFile::read_node;
      }

      void read_node(const Fields &fields)
      {
        const auto x = [&](const std::size_t k) { return k < fields.size() ? lines.number(fields[k]) : 0.; };
        mesh.nodes.emplace_back(id_of(fields[0], of), Point3(x(1), x(2), x(3)));
        if (group)
          mesh.groups[*group].nodes.push_back(mesh.nodes.back().first);
      }

      void begin_elements(const AbaqusKeyword &k)
      {
        elements.begin(k);
        read_line = &AbaqusFile::read_element;
        if (!scopes[of].has_mesh && !elements.is_mass())
          noted.add("ELEMENT, TYPE=" + k.value("TYPE"), lines.line_number());
      }

      void read_element(const Fields &fields)
      {
        elements.read_line(fields);
      }

      void begin_set(const AbaqusKeyword &k)
      {
        kind      = k.name == "NSET" ? Kind::nodes : Kind::elements;
        group     = sets.group_of(kind, parts.present(), k.value(k.name));
        read_line = &AbaqusFile::read_set;
        if (k.name == "NSET" && k.has("ELSET"))
          {
            const auto [scope, name] = scopes.split(k.options.at("ELSET"), of);
            const auto of_present    = sets.find(Kind::elements, parts.present(), k.value("ELSET"));
            sets.add_nodes_of_elements(*group, of_present ? *of_present
                                                          : sets.group_of(Kind::elements, scope, std::string(name)));
          }
      }

      /// Ids and other sets; of an assembly only what is said to be of an instance ("Part-1-1.27").
      void read_set(const Fields &fields)
      {
        if (is_generated)
          return read_range(fields);
        for (const auto field : fields)
          {
            const auto [scope, member] = scopes.split(field, of);
            const auto set             = find_set(field, scope, std::string(member));
            const bool is_id           = member.empty() || std::isdigit(static_cast<unsigned char>(member[0]));
            if (set)
              add_set(*set);
            else if (is_id && scopes[scope].has_mesh)
              add_member(id_of(member, scope));
            else if (!is_id && scopes[of].has_mesh)
              lines.refuse("the set '" + std::string(field) + "' has not been defined before", "Define it further up.");
          }
      }

      std::optional<std::size_t> find_set(const std::string_view whole, const std::size_t scope,
                                          const std::string &member) const
      {
        const Kind wanted = kind == Kind::surface ? Kind::nodes : kind; // a surface of nodes
        const auto found  = sets.find(wanted, parts.present(), std::string(whole));
        return found ? found : sets.find(wanted, scope, member);
      }

      void read_range(const Fields &fields)
      {
        if (fields.size() < 2)
          lines.refuse("GENERATE wants 'first, last, increment'", "Give at least first and last.");
        const Id first = id_of(fields[0], of), last = id_of(fields[1], of);
        const Id step = fields.size() > 2 ? lines.integer(fields[2]) : 1;
        if (last < first || step < 1)
          lines.refuse("GENERATE from " + std::string(fields[0]) + " to " + std::string(fields[1]) + " by " +
                         std::to_string(step) + " is no list of ids",
                       "Allowed: first at most last, increment from 1.");
        const Id n_steps = (last - first) / step;
        lines.add_listed(static_cast<std::size_t>(n_steps) + 1);
        for (Id k = 0; scopes[of].has_mesh && k <= n_steps; ++k)
          add_member(first + k * step);
      }

      void add_member(const Id id)
      {
        if (kind == Kind::elements)
          sets.add_element(*group, id);
        else
          mesh.groups[*group].nodes.push_back(id);
      }

      void add_set(const std::size_t other)
      {
        if (kind == Kind::elements)
          sets.add_elements(*group, other);
        else
          sets.add_nodes(*group, other);
      }

      void begin_surface(const AbaqusKeyword &k)
      {
        const std::string type = upper(k.value("TYPE"));
        kind                   = Kind::surface;
        group                  = sets.group_of(kind, parts.present(), k.value("NAME"));
        if (k.has("INSTANCE"))
          of = parts.instance(k.value("INSTANCE"));
        const bool is_read = (type.empty() || type == "ELEMENT" || type == "NODE") && !k.has("COMBINE") &&
                             !k.has("INPUT") && !k.has("CROP");
        if (!is_read)
          mesh.groups[*group].not_read = "Line " + std::to_string(lines.line_number()) +
                                         ": this kind of *SURFACE is not offered.\nWrite it as faces of elements, or "
                                         "give a node set.";
        else
          read_line = type == "NODE" ? &AbaqusFile::read_set : &AbaqusFile::read_surface;
      }

      void read_surface(const Fields &fields)
      {
        sets.add_sides(*group, of, std::string(fields[0]), fields.size() > 1 ? std::string(fields[1]) : std::string());
      }
    };
  } // namespace

  ImportedMesh read_abaqus(const std::string &path)
  {
    return AbaqusFile(path).read();
  }
} // namespace birdstrike
