#include <birdstrike/blade/loads.h>
#include <birdstrike/blade/text_lists.h>
#include <birdstrike/core/errors.h>

#include <algorithm>

namespace birdstrike
{
  Loads::Loads(const BladeParameters::Loads &parameters, const SurfaceMesh &mesh)
  {
    if (is_present(parameters.pressure))
      {
        pressure.emplace_back(parameters.pressure, 1, "Loads/Pressure");
        cells = mesh.cells;
        for (std::size_t cell = 0; cell < cells.size(); ++cell)
          {
            const Point3 c = mesh.centroid(cell);
            centroids.push_back({{c[0], c[1], c[2]}});
          }
      }
    double reach = 0.;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      reach = std::max(reach, mesh.smallest_edge(cell));
    for (const auto &[where, what] : parse_pairs(parameters.point_loads, "Loads/Point loads", '|'))
      {
        const auto          x    = parse_numbers(where, 3, "Loads/Point loads");
        const Point3        p    = Point3(x[0], x[1], x[2]);
        const std::uint32_t node = mesh.nearest_node(p);
        if ((mesh.node(node) - p).norm() > reach)
          throw InputError("Blade/Loads/Point loads: no node near (" + where +
                           ") m.\nLoads act on the nearest node, at "
                           "most one element away.");
        const bool has_moments = std::count(what.begin(), what.end(), ';') == 5;
        point_loads.push_back({node, Expression(has_moments ? what : what + "; 0; 0; 0", 6, "Loads/Point loads")});
      }
  }

  bool Loads::is_active() const
  {
    return !pressure.empty() || !point_loads.empty();
  }

  void Loads::add_forces(const double time, const double *position, double *force) const
  {
    const auto node = [position](const std::uint32_t n) {
      return Point3(position[3 * n], position[3 * n + 1], position[3 * n + 2]);
    };
    for (const auto &p : pressure)
      for (std::size_t cell = 0; cell < cells.size(); ++cell)
        {
          const auto  &c     = cells[cell];
          const Point3 area  = 0.5 * (node(c[2]) - node(c[0])).cross(node(c[3]) - node(c[1]));
          const Point3 share = 0.25 * p.value(centroids[cell].data(), time) * area;
          for (const std::uint32_t n : c)
            for (unsigned int d = 0; d < 3; ++d)
              force[6 * n + d] += share[d];
        }
    const double origin[3] = {0., 0., 0.};
    for (const auto &load : point_loads)
      for (unsigned int c = 0; c < 6; ++c)
        force[6 * load.node + c] += load.components.value(origin, time, c);
  }
} // namespace birdstrike
