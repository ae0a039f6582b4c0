#include "mesh/files/gmsh/elements.h"
#include "mesh/files/gmsh/entities.h"
#include "mesh/files/readers.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    using Id = ImportedMesh::Id;

    class GmshFile
    {
    public:
      explicit GmshFile(const std::string &path)
        : lines(path), group(mesh, path), entities(lines), elements(mesh, group, lines)
      {
      }

      ImportedMesh read()
      {
        while (lines.next())
          if (const std::string section(trim(lines.text())); section == "$MeshFormat")
            read_format();
          else if (section == "$PhysicalNames")
            repeat(lines.count(lines.take(1, "$PhysicalNames", 1)[0]), &GmshFile::read_name);
          else if (section == "$Entities")
            entities.read(version == Version::v4_1);
          else if (section == "$PartitionedEntities")
            entities.read_partitioned(version == Version::v4_1);
          else if (section == "$Nodes" || section == "$ParametricNodes")
            read_nodes(section);
          else if (section == "$Elements")
            read_elements();
        elements.finish(entities.n_partitions());
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
      using Fields = GmshLines::Fields;

      GmshLines      lines;
      ImportedMesh   mesh;
      NumberedGroups group;
      GmshEntities   entities;
      GmshElements   elements;
      Version        version = Version::unknown;

      void repeat(const Id n, void (GmshFile::*read_one)())
      {
        for (Id k = 0; k < n; ++k)
          (this->*read_one)();
      }

      void read_format()
      {
        const Fields fields = lines.take(3, "$MeshFormat");
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
        const Fields      fields = lines.take(3, "$PhysicalNames");
        const std::size_t quote  = lines.text().find('"');
        const auto        name   = lines.text().substr(std::min(quote, lines.text().size()));
        const Id          dim    = lines.integer(fields[0]);
        if (name.size() < 2 || !name.ends_with('"') || dim < 0 || dim > 3)
          lines.refuse("cannot read a physical name", "Gmsh writes: dimension, number, \"name\".");
        group(static_cast<unsigned int>(dim), lines.group_number(fields[1])).name = name.substr(1, name.size() - 2);
      }

      void add_node(const Id id, const Fields &fields, const std::size_t first)
      {
        mesh.nodes.emplace_back(
          id, Point3(lines.number(fields[first]), lines.number(fields[first + 1]), lines.number(fields[first + 2])));
      }

      /// What stands behind the place are parameters on its entity.
      void read_node()
      {
        const Fields fields = lines.take(4, "$Nodes");
        add_node(lines.integer(fields[0]), fields, 1);
      }

      /// The number of nodes, elements or blocks of them, first.
      Fields take_head(const std::string &section)
      {
        if (version == Version::unknown)
          lines.refuse("'$MeshFormat' is missing above " + section, "Save the mesh again.");
        return lines.take(version == Version::v2 ? 1 : version == Version::v4_0 ? 2 : 4, section);
      }

      void read_nodes(const std::string &section)
      {
        const Fields head = take_head(section);
        if (version == Version::v2)
          repeat(lines.count(head[0]), &GmshFile::read_node);
        else
          repeat(lines.count(head[0]), &GmshFile::read_node_block);
        end("$End" + section.substr(1));
      }

      void read_node_block()
      {
        const Id n = lines.count(lines.take(4, "$Nodes", 4)[3]);
        if (version == Version::v4_0)
          return repeat(n, &GmshFile::read_node);
        std::vector<Id> ids;
        for (Id k = 0; k < n; ++k)
          ids.push_back(lines.integer(lines.take(1, "$Nodes", 1)[0]));
        for (const Id id : ids)
          add_node(id, lines.take(3, "$Nodes"), 0);
      }

      void read_elements()
      {
        const Fields head = take_head("$Elements");
        repeat(lines.count(head[0]), version == Version::v2 ? &GmshFile::read_element : &GmshFile::read_element_block);
        end("$EndElements");
      }

      void read_element()
      {
        elements.add_of_format_2(lines.take(4, "$Elements"));
      }

      void read_element_block()
      {
        const Fields head   = lines.take(4, "$Elements", 4);
        const bool   is_4_0 = version == Version::v4_0;
        const auto   dim    = static_cast<unsigned int>(lines.integer(head[is_4_0 ? 1 : 0]));
        const auto   entity = entities.find(dim, lines.integer(head[is_4_0 ? 0 : 1]));
        const auto  &type   = elements.type_of(head[2]);
        const auto   owner  = elements.owner_of(type.dim, entity);
        for (Id n = lines.count(head[3]); n > 0; --n)
          elements.add_of_entity(type, lines.take(2, "$Elements"), owner);
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
