#include "mesh/blade_stations.h"
#include "mesh/files/file_lines.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/core/text/number_text.h>
#include <birdstrike/core/text/text_file.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/mesh/nodal_thickness.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
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
             " at " + point_text(&x[0]) + " m";
    }

    /// Words between blanks, commas or semicolons; '#' begins a comment.
    std::vector<std::string> words_of(const std::string_view line)
    {
      std::string text(line.substr(0, line.find('#')));
      std::replace(text.begin(), text.end(), ';', ' ');
      return parse_words(text);
    }

    /// Whether a line has the names that spreadsheets put above rows: in m, as the numbers are.
    bool is_heading(std::vector<std::string> words)
    {
      static const std::set<std::string> metres{"[m]", "(m)"};
      std::erase_if(words, [](const std::string &word) { return metres.contains(word); });
      for (std::string &word : words)
        word = upper(word.substr(0, std::min({word.find("[m]"), word.find("(m)"), word.size()})));
      using Words = std::vector<std::string>;
      return words == Words{"X", "Y", "Z", "THICKNESS"} || words == Words{"NODE", "THICKNESS"};
    }

    /// Whether a first line is none of the table's rows: it names the separator or the columns.
    bool is_above_rows(const std::string_view line)
    {
      return named_separator(line).has_value() || is_heading(words_of(line));
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
      bool                has_rows = false;
      lines.require_text();
      while (lines.next())
        {
          const auto row = words_of(lines.text());
          if (row.empty() || (!has_rows && is_above_rows(lines.text())))
            continue;
          has_rows = true;
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
          if (node && thickness[*node] != 0. && thickness[*node] != t)
            lines.refuse("the " + name_of(mesh, *node) + " has a second thickness, " + row.back() + " m",
                         "Give each node one row.");
          if (node)
            thickness[*node] = t;
        }
      if (const auto left = std::find(thickness.begin(), thickness.end(), 0.); left != thickness.end())
        throw InputError("Blade/Thickness/Table: '" + path + "' has no row for the " +
                         name_of(mesh, static_cast<std::size_t>(left - thickness.begin())) + ", nor for " +
                         std::to_string(std::count(left + 1, thickness.end(), 0.)) +
                         " others.\nGive every node a thickness; a place must be within " + number_text(1e3 * reach) +
                         " mm of its node.");
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
