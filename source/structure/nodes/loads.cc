#include "structure/nodes/loads.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace birdstrike
{
  template <int dim>
  Loads::Loads(const BladeParameters::Loads &parameters, const BladeMesh<dim> &mesh,
               std::vector<Quadrilateral> quadrilaterals)
    : n_unknowns(mesh.n_unknowns), damping_rate(parameters.damping)
  {
    if (is_present(parameters.pressure))
      {
        pressure.emplace_back(parameters.pressure, 1, "Loads/Pressure");
        pressed = std::move(quadrilaterals);
        for (const auto &q : pressed)
          {
            const Point3 c = 0.25 * (mesh.node(q[0]) + mesh.node(q[1]) + mesh.node(q[2]) + mesh.node(q[3]));
            centroids.push_back({{c[0], c[1], c[2]}});
          }
      }
    add_point_loads(parameters, mesh);
  }

  template <int dim>
  void Loads::add_point_loads(const BladeParameters::Loads &parameters, const BladeMesh<dim> &mesh)
  {
    const SurfaceMesh &surface = mesh.surface();
    double             reach   = 0.;
    for (std::size_t facet = 0; facet < surface.cells.size(); ++facet)
      reach = std::max(reach, surface.smallest_edge(facet));
    for (const auto &[where, what] : parse_pairs(parameters.point_loads, "Blade/Loads/Point loads", '|'))
      {
        const auto x    = parse_numbers(where, 3, "Blade/Loads/Point loads");
        const auto p    = Point3(x[0], x[1], x[2]);
        const auto node = mesh.nearest_node(p, dim == 3);
        if (!node)
          continue;
        std::vector<NodeShare> nodes{{*node, 1.}};
        if constexpr (dim == 3)
          nodes = share_force(mesh, *node, p);
        Point3 taken_at = Point3::Zero();
        for (const NodeShare &share : nodes)
          taken_at += share.weight * mesh.node(share.node);
        if ((taken_at - p).norm() > reach)
          throw InputError("Blade/Loads/Point loads: no node near (" + where +
                           ") m.\nLoads act on the nearest node, at "
                           "most one element away.");
        const bool has_moments = std::count(what.begin(), what.end(), ';') == 5;
        if (has_moments && n_unknowns < 6)
          throw InputError("Blade/Loads/Point loads: '" + what +
                           "' has moments, which the nodes of a solid cannot take.\n"
                           "Allowed for a solid: three forces, 'fx; fy; fz'.");
        const auto formulas = dealii::Utilities::split_string_list(what, ';');
        if (formulas.size() != 3 && !has_moments)
          throw InputError("Blade/Loads/Point loads: '" + what + "' has " + std::to_string(formulas.size()) +
                           " formulas.\nAllowed: three forces, 'fx; fy; fz', of shells three moments after them.");
        PointLoad load{std::move(nodes), {}};
        for (const std::string &formula : formulas)
          load.components.emplace_back(formula, "Loads/Point loads");
        point_loads.push_back(std::move(load));
      }
  }

  bool Loads::is_active() const
  {
    return !pressure.empty() || !point_loads.empty();
  }

  double Loads::damping() const
  {
    return damping_rate;
  }

  void Loads::stop_pressing(const std::size_t quadrilateral)
  {
    if (!pressed.empty())
      pressed[quadrilateral].fill(pressed[quadrilateral][0]); // no area
  }

  void Loads::add_forces(const double time, const double *position, double *force) const
  {
    const auto node = [position](const std::uint32_t n) {
      return Point3(position[3 * n], position[3 * n + 1], position[3 * n + 2]);
    };
    for (const auto &p : pressure)
      for (std::size_t k = 0; k < pressed.size(); ++k)
        {
          const auto  &c     = pressed[k];
          const Point3 area  = 0.5 * (node(c[2]) - node(c[0])).cross(node(c[3]) - node(c[1]));
          const Point3 share = 0.25 * p.value(centroids[k].data(), time) * area;
          for (const std::uint32_t n : c)
            for (unsigned int d = 0; d < 3; ++d)
              force[n_unknowns * n + d] += share[d];
        }
    for (const auto &load : point_loads)
      for (std::size_t c = 0; c < load.components.size(); ++c)
        {
          const double value = load.components[c](time);
          for (const NodeShare &share : load.nodes)
            force[n_unknowns * share.node + c] += share.weight * value;
        }
  }

  template Loads::Loads(const BladeParameters::Loads &, const BladeMesh<2> &, std::vector<Quadrilateral>);
  template Loads::Loads(const BladeParameters::Loads &, const BladeMesh<3> &, std::vector<Quadrilateral>);
} // namespace birdstrike
