#include "mesh/blade_stations.h"
#include "mesh/files/file_lines.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/mesh/nodal_thickness.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace birdstrike
{
  namespace
  {
    /// Nodes by their place: sorted along x.
    class NearestNode
    {
    public:
      NearestNode(const SurfaceMesh &mesh, const double reach) : mesh(mesh), reach(reach)
      {
        for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n)
          order.emplace_back(mesh.nodes[n][0], n);
        std::sort(order.begin(), order.end());
      }

      std::optional<std::uint32_t> find(const Point3 &x) const
      {
        std::optional<std::uint32_t> nearest;
        double                       smallest = reach;
        for (auto node = std::lower_bound(order.begin(), order.end(), std::pair(x[0] - reach, std::uint32_t(0)));
             node != order.end() && node->first <= x[0] + reach; ++node)
          if (const double d = (mesh.node(node->second) - x).norm(); d <= smallest)
            {
              smallest = d;
              nearest  = node->second;
            }
        return nearest;
      }

    private:
      const SurfaceMesh                            &mesh;
      double                                        reach;
      std::vector<std::pair<double, std::uint32_t>> order;
    };

    std::string name_of(const SurfaceMesh &mesh, const std::size_t n)
    {
      const auto &x = mesh.nodes[n];
      return (mesh.file_node_ids.empty() ? std::string("node") : "node " + std::to_string(mesh.file_node_ids[n])) +
             " at (" + std::to_string(x[0]) + ", " + std::to_string(x[1]) + ", " + std::to_string(x[2]) + ") m";
    }

    std::vector<double> read_table(const std::string &path, const SurfaceMesh &mesh)
    {
      double reach = std::numeric_limits<double>::infinity();
      for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        reach = std::min(reach, 0.01 * mesh.smallest_edge(cell));
      const NearestNode                               nearest(mesh, reach);
      std::unordered_map<std::int64_t, std::uint32_t> by_id;
      for (std::uint32_t n = 0; n < mesh.file_node_ids.size(); ++n)
        by_id[mesh.file_node_ids[n]] = n;

      std::vector<double> thickness(mesh.nodes.size(), 0.);
      FileLines           lines(path, "Blade/Thickness/Table");
      while (lines.next())
        {
          const auto row = parse_words(std::string(lines.text().substr(0, lines.text().find('#'))));
          if (row.empty())
            continue;
          if (row.size() != 4 && row.size() != 2)
            lines.refuse("there are " + std::to_string(row.size()) + " numbers",
                         "Allowed: 'x y z thickness' in m, or 'node thickness' with the node's id in the mesh file.");
          if (row.size() == 2 && by_id.empty())
            lines.refuse("a node is given by its id, but this mesh has none",
                         "Ids are known of Abaqus, LS-DYNA and VTK files; give 'x y z thickness' in m.");
          const double t = lines.number(row.back());
          if (!(t > 0.))
            lines.refuse("the thickness is " + row.back() + " m", "Allowed: positive.");
          std::optional<std::uint32_t> node;
          if (row.size() == 4)
            node = nearest.find(Point3(lines.number(row[0]), lines.number(row[1]), lines.number(row[2])));
          else if (const auto found = by_id.find(lines.integer(row[0])); found != by_id.end())
            node = found->second;
          if (node)
            thickness[*node] = t;
        }
      if (const auto left = std::find(thickness.begin(), thickness.end(), 0.); left != thickness.end())
        throw InputError("Blade/Thickness/Table: '" + path + "' has no row for the " +
                         name_of(mesh, static_cast<std::size_t>(left - thickness.begin())) + ", nor for " +
                         std::to_string(std::count(left + 1, thickness.end(), 0.)) +
                         " others.\nGive every node a thickness; a place must be within " +
                         std::to_string(1e3 * reach) + " mm of its node.");
      return thickness;
    }
  } // namespace

  NodalThickness find_nodal_thickness(const GeometryParameters &parameters, const ShellMesh &mesh,
                                      const std::vector<unsigned int> &root_ids,
                                      const std::vector<unsigned int> &tip_ids)
  {
    NodalThickness nodal;
    if (!parameters.thickness.table.empty())
      nodal.given = read_table(parameters.thickness.table, mesh);
    if (!parameters.thickness.maximum.empty() && parameters.mesh.generator == MeshGenerator::file)
      nodal.station = find_stations(mesh, root_ids, tip_ids);
    return nodal;
  }
} // namespace birdstrike
