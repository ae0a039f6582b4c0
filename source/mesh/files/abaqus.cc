#include "mesh/files/abaqus_sets.h"
#include "mesh/files/file_lines.h"
#include "mesh/files/readers.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace birdstrike
{
  namespace
  {
    using Id     = ImportedMesh::Id;
    using Fields = std::vector<std::string_view>;

    struct Keyword
    {
      std::string                        name;    ///< upper case, single blanks
      std::map<std::string, std::string> options; ///< names in upper case, values as given without quotes

      bool has(const std::string &option) const
      {
        return options.count(option) > 0;
      }
      std::string value(const std::string &option) const
      {
        const auto found = options.find(option);
        return found != options.end() ? found->second : "";
      }
    };

    struct ElementType
    {
      const char  *name; ///< its beginning: letters may follow, digits not
      unsigned int dim, n_nodes;
    };
    constexpr ElementType types[] = {{"S4", 2, 4},     {"M3D4", 2, 4}, {"CPS4", 2, 4}, {"CPE4", 2, 4}, {"R3D4", 2, 4},
                                     {"SFM3D4", 2, 4}, {"C3D8", 3, 8}, {"SC8", 3, 8},  {"T2D2", 1, 2}, {"T3D2", 1, 2},
                                     {"B21", 1, 2},    {"B23", 1, 2},  {"B31", 1, 2},  {"B33", 1, 2},  {"R2D2", 1, 2},
                                     {"RB2D2", 1, 2},  {"RB3D2", 1, 2}};

    std::string_view without_instance(const std::string_view member) ///< "Part-1-1.27" -> "27"
    {
      return member.substr(member.rfind('.') + 1);
    }

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
            begin(parse(text));
          else if (const Fields fields = lines.split_at_commas(); read_line != nullptr && !fields.empty())
            (this->*read_line)(fields);
        finish_element();
        sets.add_awaited();
        for (const Face &face : faces)
          sets.add_sides(face.group, face.elements, face.label);
        return std::move(mesh);
      }

    private:
      struct Face ///< of a surface
      {
        std::size_t group;
        std::string elements; ///< a set, or an id
        std::string label;    ///< empty: all
      };

      FileLines         lines;
      ImportedMesh      mesh;
      AbaqusSets        sets{mesh, lines};
      std::vector<Face> faces;
      unsigned int      n_parts = 0, n_instances = 0;
      bool              is_in_assembly = false; ///< and in no instance: ids are not those of the mesh

      // the present keyword
      void (AbaqusFile::*read_line)(const Fields &) = nullptr;
      std::size_t        group                      = no_group;
      const ElementType *type                       = nullptr;
      bool               is_generated = false, is_of_instance = true;
      std::vector<Id>    pending; ///< of an element that goes on in the next line

      static constexpr std::size_t no_group = -1;

      Keyword parse(std::string_view first)
      {
        std::string text(first);
        while (text.ends_with(',') && lines.next())
          text += trim(lines.text());
        Keyword keyword;
        for (std::string_view rest = std::string_view(text).substr(1); !rest.empty();)
          {
            const std::size_t      comma  = std::min(rest.find(','), rest.size());
            const std::string_view piece  = rest.substr(0, comma);
            const std::size_t      equals = std::min(piece.find('='), piece.size());
            const std::string      key    = upper(trim(piece.substr(0, equals)));
            std::string_view       value  = trim(piece.substr(std::min(equals + 1, piece.size())));
            if (value.size() > 1 && value.front() == '"' && value.back() == '"')
              value = value.substr(1, value.size() - 2);
            if (keyword.name.empty())
              keyword.name = key;
            else
              keyword.options[key] = value;
            rest.remove_prefix(std::min(comma + 1, rest.size()));
          }
        return keyword;
      }

      void begin(const Keyword &k)
      {
        finish_element();
        read_line = nullptr;
        group     = no_group;
        for (const char *refused :
             {"INCLUDE", "SYSTEM", "NGEN", "NCOPY", "NFILL", "NMAP", "ELGEN", "ELCOPY", "UFILL", "SUBSTRUCTURE PATH"})
          if (k.name == refused)
            lines.refuse("the keyword *" + k.name + " is not offered",
                         "Write the whole mesh as *NODE and *ELEMENT into one file, in one system of coordinates.");
        if (k.name == "NODE" || k.name == "ELEMENT" || k.name == "NSET" || k.name == "ELSET" || k.name == "SURFACE")
          for (const char *refused : {"INPUT", "FILE", "COMBINE"})
            if (k.has(refused))
              lines.refuse("*" + k.name + " with " + refused + " is not offered", "Write its data into this file.");
        is_generated   = k.has("GENERATE");
        is_of_instance = !is_in_assembly || k.has("INSTANCE");
        if (k.name == "PART" || k.name == "INSTANCE" || k.name == "ASSEMBLY" || k.name == "END INSTANCE" ||
            k.name == "END ASSEMBLY")
          begin_structure(k);
        else if (k.name == "NODE" && !is_in_assembly)
          begin_nodes(k);
        else if (k.name == "ELEMENT" && !is_in_assembly)
          begin_elements(k);
        else if (k.name == "NSET" || k.name == "ELSET")
          begin_set(k);
        else if (k.name == "SURFACE")
          begin_surface(k);
      }

      /// One part, and one instance of it that stands where the part does.
      void begin_structure(const Keyword &k)
      {
        is_in_assembly = k.name == "ASSEMBLY" || k.name == "END INSTANCE";
        if (k.name == "INSTANCE")
          read_line = &AbaqusFile::read_placement;
        if ((k.name == "PART" && ++n_parts > 1) || (k.name == "INSTANCE" && ++n_instances > 1))
          lines.refuse("a second *" + k.name + " begins here",
                       "Save the blade alone, one part and one instance of it.");
      }

      void read_placement(const Fields &fields)
      {
        if (std::any_of(fields.begin(), fields.end(), [this](const auto field) { return lines.number(field) != 0.; }))
          lines.refuse("the *INSTANCE is moved or turned", "Save the blade where it stands (a flat input file).");
      }

      void begin_nodes(const Keyword &k)
      {
        if (!k.value("SYSTEM").empty() && upper(k.value("SYSTEM")) != "R")
          lines.refuse("*NODE with SYSTEM=" + k.value("SYSTEM") + " is not offered",
                       "Allowed: rectangular coordinates x, y, z.");
        if (k.has("NSET"))
          group = sets.group_of(k.value("NSET"));
        read_line = &AbaqusFile::read_node;
      }

      void read_node(const Fields &fields)
      {
        const auto x = [&](const std::size_t k) { return k < fields.size() ? lines.number(fields[k]) : 0.; };
        mesh.nodes.emplace_back(lines.integer(fields[0]), Point3(x(1), x(2), x(3)));
        if (group != no_group)
          mesh.groups[group].nodes.push_back(mesh.nodes.back().first);
      }

      void begin_elements(const Keyword &k)
      {
        const std::string name = upper(k.value("TYPE"));
        type                   = std::find_if(std::begin(types), std::end(types), [&name](const ElementType &t) {
          const std::string beginning = t.name;
          return name.starts_with(beginning) &&
                 (name.size() == beginning.size() || !std::isdigit(static_cast<unsigned char>(name[beginning.size()])));
        });
        if (type == std::end(types))
          lines.refuse("elements of the type " + name + " are not offered",
                       "Allowed: shells S4, S4R, S4RS, M3D4, R3D4, CPS4; bricks C3D8, C3D8R, C3D8I, SC8R; lines T3D2, "
                       "B31. Mesh with quadrilaterals or hexahedra of the first order, and remove all others.");
        if (k.has("ELSET"))
          group = sets.group_of(k.value("ELSET"));
        read_line = &AbaqusFile::read_element;
      }

      void read_element(const Fields &fields)
      {
        for (const auto field : fields)
          pending.push_back(lines.integer(field));
        if (pending.size() > type->n_nodes)
          finish_element();
      }

      void finish_element()
      {
        if (pending.empty())
          return;
        if (pending.size() < type->n_nodes + 1 || (type->dim > 1 && pending.size() > type->n_nodes + 1))
          lines.refuse("element " + std::to_string(pending[0]) + " of type " + type->name + " has " +
                         std::to_string(pending.size() - 1) + " nodes",
                       "It must have " + std::to_string(type->n_nodes) + ".");
        ImportedMesh::Element element{pending[0]};
        std::copy_n(pending.begin() + 1, type->n_nodes, element.nodes.begin());
        if (!sets.add(element, type->dim))
          lines.refuse("the element " + std::to_string(element.id) + " is given twice", "Give each id once.");
        if (group != no_group)
          sets.add_element(group, element.id);
        pending.clear();
      }

      void begin_set(const Keyword &k)
      {
        group     = sets.group_of(k.value(k.name));
        read_line = k.name == "NSET" ? &AbaqusFile::read_node_set : &AbaqusFile::read_element_set;
        if (k.name == "NSET" && k.has("ELSET"))
          sets.add_nodes_of_elements(group, sets.group_of(k.value("ELSET")));
      }

      void read_node_set(const Fields &fields)
      {
        for_each_member(
          fields, [this](const Id id) { mesh.groups[group].nodes.push_back(id); },
          [this](const std::size_t other) { sets.add_nodes(group, other); });
      }

      void read_element_set(const Fields &fields)
      {
        for_each_member(
          fields, [this](const Id id) { sets.add_element(group, id); },
          [this](const std::size_t other) { sets.add_elements(group, other); });
      }

      /// Ids and other sets; of an assembly only what is said to be of the instance ("Part-1-1.27").
      template <class AddId, class AddGroup>
      void for_each_member(const Fields &fields, const AddId &add, const AddGroup &add_group)
      {
        if (is_generated)
          {
            if (fields.size() < 2)
              lines.refuse("GENERATE wants 'first, last, increment'", "Give at least first and last.");
            const Id first = lines.integer(fields[0]), last = lines.integer(fields[1]);
            const Id step = fields.size() > 2 ? lines.integer(fields[2]) : 1;
            if (first < 0 || last < first || step < 1)
              lines.refuse("GENERATE from " + std::to_string(first) + " to " + std::to_string(last) + " by " +
                             std::to_string(step) + " is no list of ids",
                           "Allowed: first at most last, increment from 1.");
            const Id n_steps = (last - first) / step;
            lines.add_listed(static_cast<std::size_t>(n_steps) + 1);
            for (Id k = 0; is_of_instance && k <= n_steps; ++k)
              add(first + k * step);
            return;
          }
        for (const auto field : fields)
          if (const auto member = without_instance(field);
              member.empty() || std::isdigit(static_cast<unsigned char>(member[0])))
            {
              if (is_of_instance || member.size() < field.size())
                add(lines.integer(member));
            }
          else if (const auto found = sets.find(std::string(member)))
            add_group(*found);
          else if (is_of_instance)
            lines.refuse("the set '" + std::string(member) + "' has not been defined before", "Define it further up.");
      }

      void begin_surface(const Keyword &k)
      {
        const std::string kind = upper(k.value("TYPE"));
        if (!kind.empty() && kind != "ELEMENT" && kind != "NODE")
          return;
        group     = sets.group_of(k.value("NAME"));
        read_line = kind == "NODE" ? &AbaqusFile::read_node_set : &AbaqusFile::read_surface;
      }

      void read_surface(const Fields &fields)
      {
        faces.push_back({group, std::string(without_instance(fields[0])),
                         fields.size() > 1 ? std::string(fields[1]) : std::string()});
      }
    };
  } // namespace

  ImportedMesh read_abaqus(const std::string &path)
  {
    return AbaqusFile(path).read();
  }
} // namespace birdstrike
