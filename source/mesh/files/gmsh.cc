#include "mesh/files/file_lines.h"
#include "mesh/files/numbered_groups.h"
#include "mesh/files/readers.h"

#include <algorithm>
#include <cstdlib>

namespace birdstrike
{
  namespace
  {
    using Id = ImportedMesh::Id;

    struct ElementType
    {
      Id           number;
      unsigned int dim, n_nodes;
    };
    constexpr ElementType types[] = {{15, 0, 1}, {1, 1, 2}, {3, 2, 4}, {5, 3, 8}};

    class GmshFile
    {
    public:
      explicit GmshFile(const std::string &path) : lines(path), group(mesh, path)
      {
      }

      ImportedMesh read()
      {
        while (lines.next())
          if (const std::string section(trim(lines.text())); section == "$MeshFormat")
            read_format();
          else if (section == "$PhysicalNames")
            repeat(count(take(1, "$PhysicalNames", 1)[0]), &GmshFile::read_name);
          else if (section == "$Entities")
            read_entities();
          else if (section == "$Nodes")
            read_nodes();
          else if (section == "$Elements")
            read_elements();
        return std::move(mesh);
      }

    private:
      enum class Version
      {
        unknown,
        v2,
        v4_0,
        v4_1
      };
      using Fields = std::vector<std::string_view>;

      FileLines                                              lines;
      ImportedMesh                                           mesh;
      NumberedGroups                                         group;
      Version                                                version = Version::unknown;
      std::map<std::pair<unsigned int, Id>, std::vector<Id>> physical_of; ///< numbers by dimension and tag of entities

      static constexpr std::size_t any = -1;

      /// The fields of the next line, of which there must be so many.
      Fields take(const std::size_t at_least, const std::string &what, const std::size_t at_most = any)
      {
        if (!lines.next())
          lines.refuse("the file ends in " + what, "Save the mesh again.");
        Fields fields = lines.split_at_blanks();
        if (fields.size() < at_least || fields.size() > at_most || fields[0].starts_with('$'))
          lines.refuse("'" + std::string(lines.text()).substr(0, 80) + "' stands where " + what + " must go on",
                       "A line too few or too many, or a wrong number of them? Save the mesh again.");
        return fields;
      }

      Id count(const std::string_view field) const
      {
        const Id n = lines.integer(field);
        if (n < 0)
          lines.refuse("the number " + std::to_string(n) + " of things is negative", "Save the mesh again.");
        return n;
      }

      Id group_number(const std::string_view field) const ///< negative: turned round
      {
        return std::abs(std::max(lines.integer(field), -ImportedMesh::largest_number - 1));
      }

      void repeat(const Id n, void (GmshFile::*read_one)())
      {
        for (Id k = 0; k < n; ++k)
          (this->*read_one)();
      }

      void read_format()
      {
        const Fields fields = take(3, "$MeshFormat");
        version             = fields[0].starts_with("2")               ? Version::v2
                              : fields[0] == "4" || fields[0] == "4.0" ? Version::v4_0
                              : fields[0] == "4.1"                     ? Version::v4_1
                                                                       : Version::unknown;
        if (version == Version::unknown || fields[1] != "0")
          lines.refuse("the format is " + std::string(fields[0]) + (fields[1] != "0" ? ", binary" : ""),
                       "Allowed: formats 2 and 4, text (Gmsh: Mesh.MshFileVersion = 2.2, Mesh.Binary = 0).");
      }

      void read_name()
      {
        const Fields      fields = take(3, "$PhysicalNames");
        const std::size_t quote  = lines.text().find('"');
        const auto        name   = lines.text().substr(std::min(quote, lines.text().size()));
        const Id          dim    = lines.integer(fields[0]);
        if (name.size() < 2 || !name.ends_with('"') || dim < 0 || dim > 3)
          lines.refuse("cannot read a physical name", "Gmsh writes: dimension, number, \"name\".");
        group(static_cast<unsigned int>(dim), lines.integer(fields[1])).name = name.substr(1, name.size() - 2);
      }

      /// Points, curves, surfaces, volumes: tag, box (of points in format 4.1: place), number of groups, groups.
      void read_entities()
      {
        const Fields head = take(4, "$Entities", 4);
        Id           n[4];
        std::transform(head.begin(), head.end(), n, [this](const auto field) { return count(field); });
        for (unsigned int dim = 0; dim < 4; ++dim)
          for (Id k = 0; k < n[dim]; ++k)
            {
              const std::size_t before   = dim == 0 && version == Version::v4_1 ? 4 : 7;
              const Fields      fields   = take(before + 1, "$Entities");
              const Id          n_groups = count(fields[before]);
              if (n_groups > static_cast<Id>(fields.size() - before - 1))
                lines.refuse("an entity has fewer physical groups than its " + std::to_string(n_groups),
                             "Save the mesh again.");
              for (Id g = 0; g < n_groups; ++g)
                physical_of[{dim, lines.integer(fields[0])}].push_back(
                  group_number(fields[before + 1 + static_cast<std::size_t>(g)]));
            }
      }

      void add_node(const Id id, const Fields &fields, const std::size_t first)
      {
        mesh.nodes.emplace_back(
          id, Point3(lines.number(fields[first]), lines.number(fields[first + 1]), lines.number(fields[first + 2])));
      }

      void read_node()
      {
        const Fields fields = take(4, "$Nodes");
        add_node(lines.integer(fields[0]), fields, 1);
      }

      void read_nodes()
      {
        const Fields head = take(version == Version::v2 ? 1 : version == Version::v4_0 ? 2 : 4, "$Nodes");
        if (version == Version::v2)
          repeat(count(head[0]), &GmshFile::read_node);
        else
          repeat(count(head[0]), &GmshFile::read_node_block);
        end("$EndNodes");
      }

      void read_node_block()
      {
        const Id n = count(take(4, "$Nodes", 4)[3]);
        if (version == Version::v4_0)
          return repeat(n, &GmshFile::read_node);
        std::vector<Id> ids;
        for (Id k = 0; k < n; ++k)
          ids.push_back(lines.integer(take(1, "$Nodes", 1)[0]));
        for (const Id id : ids)
          add_node(id, take(3, "$Nodes"), 0);
      }

      void read_elements()
      {
        const Fields head = take(version == Version::v2 ? 1 : version == Version::v4_0 ? 2 : 4, "$Elements");
        repeat(count(head[0]), version == Version::v2 ? &GmshFile::read_element : &GmshFile::read_element_block);
        end("$EndElements");
      }

      /// Format 2: id, type, number of tags, tags, of which the first is the group, nodes.
      void read_element()
      {
        const Fields fields = take(4, "$Elements");
        const Id     n_tags = count(fields[2]);
        if (n_tags >= static_cast<Id>(fields.size()) - 3)
          lines.refuse("an element has " + std::to_string(n_tags) + " tags and no nodes", "Save the mesh again.");
        const Id number = n_tags > 0 ? group_number(fields[3]) : 0;
        add_element(type_of(fields[1]), fields, static_cast<std::size_t>(3 + n_tags),
                    number > 0 ? std::vector<Id>{number} : std::vector<Id>{});
      }

      void read_element_block()
      {
        const Fields       head       = take(4, "$Elements", 4);
        const bool         is_4_0     = version == Version::v4_0;
        const Id           entity_dim = lines.integer(head[is_4_0 ? 1 : 0]), tag = lines.integer(head[is_4_0 ? 0 : 1]);
        const ElementType &type = type_of(head[2]);
        const Id           n    = count(head[3]);
        const auto         of   = physical_of.find({static_cast<unsigned int>(entity_dim), tag});
        for (Id k = 0; k < n; ++k)
          add_element(type, take(2, "$Elements"), 1, of != physical_of.end() ? of->second : std::vector<Id>{});
      }

      const ElementType &type_of(const std::string_view field) const
      {
        const Id    number = lines.integer(field);
        const auto *found  = std::find_if(std::begin(types), std::end(types),
                                          [number](const ElementType &type) { return type.number == number; });
        if (found == std::end(types))
          lines.refuse("an element is of Gmsh's type " + std::to_string(number) +
                         ", not hexahedra, quadrilaterals or lines of the first order",
                       "Recombine the triangles (Gmsh: Mesh.RecombineAll = 1); mesh bodies by sweeping or transfinite "
                       "volumes: tetrahedra and wedges are not offered.");
        return *found;
      }

      void add_element(const ElementType &type, const Fields &fields, const std::size_t first,
                       const std::vector<Id> &groups)
      {
        if (fields.size() != first + type.n_nodes)
          lines.refuse("element " + std::string(fields[0]) + " of Gmsh's type " + std::to_string(type.number) +
                         " has " + std::to_string(fields.size() - std::min(fields.size(), first)) + " nodes",
                       "It must have " + std::to_string(type.n_nodes) + ". A line too few or too many?");
        if (type.dim == 0)
          return;
        auto &element = mesh.elements[type.dim].emplace_back(ImportedMesh::Element{lines.integer(fields[0])});
        for (unsigned int k = 0; k < type.n_nodes; ++k)
          element.nodes[k] = lines.integer(fields[first + k]);
        lines.add_listed(groups.size() > 1 ? groups.size() : 0);
        for (const Id number : groups)
          group(type.dim, number).elements[type.dim].push_back(element.id);
      }

      void end(const std::string &section)
      {
        if (!lines.next() || trim(lines.text()) != section)
          lines.refuse("'" + section + "' is missing behind the number of things announced", "Save the mesh again.");
      }
    };
  } // namespace

  ImportedMesh read_gmsh(const std::string &path)
  {
    return GmshFile(path).read();
  }
} // namespace birdstrike
