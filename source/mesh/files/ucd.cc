#include "mesh/files/file_lines.h"
#include "mesh/files/numbered_groups.h"
#include "mesh/files/readers.h"

namespace birdstrike
{
  namespace
  {
    using Id = ImportedMesh::Id;

    class UcdFile
    {
    public:
      explicit UcdFile(const std::string &path) : lines(path), group(mesh, path)
      {
      }

      /// Comments, one line of numbers of things, nodes, cells; what follows is data.
      ImportedMesh read()
      {
        const Fields head    = take(5, "the numbers of nodes, cells and data");
        const Id     n_nodes = lines.integer(head[0]), n_cells = lines.integer(head[1]);
        if (n_nodes < 0 || n_cells < 0)
          lines.refuse("a number of nodes or cells is negative", "Save the mesh again.");
        for (Id k = 0; k < n_nodes; ++k)
          {
            const Fields fields = take(4, "the nodes", 4);
            mesh.nodes.emplace_back(lines.integer(fields[0]),
                                    Point3(lines.number(fields[1]), lines.number(fields[2]), lines.number(fields[3])));
          }
        for (Id k = 0; k < n_cells; ++k)
          read_cell();
        return std::move(mesh);
      }

    private:
      using Fields = std::vector<std::string_view>;

      FileLines      lines;
      ImportedMesh   mesh;
      NumberedGroups group;

      Fields take(const std::size_t at_least, const std::string &what, const std::size_t at_most = -1)
      {
        Fields fields;
        while (fields.empty() || fields[0].starts_with('#'))
          {
            if (!lines.next())
              lines.refuse("the file ends in " + what, "Save the mesh again.");
            fields = lines.split_at_blanks();
          }
        if (fields.size() < at_least || fields.size() > at_most)
          lines.refuse("'" + std::string(lines.text()).substr(0, 80) + "' stands where " + what + " must go on",
                       "A line too few or too many, or a wrong number of them? Save the mesh again.");
        return fields;
      }

      /// id, number of its material, type, nodes
      void read_cell()
      {
        const Fields       fields = take(4, "the cells");
        const unsigned int dim    = fields[2] == "line" ? 1 : fields[2] == "quad" ? 2 : fields[2] == "hex" ? 3 : 0;
        if (fields[2] == "pt")
          return;
        if (dim == 0)
          return add_not_offered(fields);
        if (fields.size() != 3 + (1u << dim))
          lines.refuse("cell " + std::string(fields[0]) + " of type " + std::string(fields[2]) + " has " +
                         std::to_string(fields.size() - 3) + " nodes",
                       "It must have " + std::to_string(1u << dim) + ".");
        auto &element = mesh.elements[dim].emplace_back(ImportedMesh::Element{lines.integer(fields[0])});
        for (unsigned int k = 0; k < 1u << dim; ++k)
          element.nodes[k] = lines.integer(fields[3 + k]);
        if (const Id number = lines.integer(fields[1]); number != 0)
          group(dim, number).elements[dim].push_back(element.id);
      }

      void add_not_offered(const Fields &fields)
      {
        const unsigned int dim = fields[2] == "tri" ? 2 : 3;
        const Id           id  = lines.integer(fields[0]);
        mesh.elements_not_offered[dim].push_back(mesh.not_offered(
          id, lines.line_number(), "a cell is of the type '" + std::string(fields[2]) + "', not quad, hex or line",
          "Recombine triangles into quadrilaterals; tetrahedra, wedges and pyramids are not offered. "
          "Or name the materials that are the blade in Blade/Mesh/Parts."));
        if (const Id number = lines.integer(fields[1]); number != 0)
          group(dim, number).elements[dim].push_back(id);
      }
    };
  } // namespace

  ImportedMesh read_ucd(const std::string &path)
  {
    return UcdFile(path).read();
  }
} // namespace birdstrike
