#include "contact_workload.h"

#include <birdstrike/core/closest_point.h>

namespace birdstrike::benchmarks
{
  double ContactWorkload::count_pairs() const
  {
    const double reach = half_thickness + 1.5 * spacing;
    double       pairs = 0.;
    for (const std::size_t p : {side / 2 * (side + 1), side * side + side / 2 * (side + 1)})
      for (const auto &nodes : facet)
        {
          std::array<Point3, 4> x;
          for (unsigned int k = 0; k < 4; ++k)
            x[k] = Point3(&node_position[3 * nodes[k]]);
          const Point3 here(position[0][p], position[1][p], position[2][p]);
          pairs += compute_closest_point(here, x).distance_squared <= reach * reach;
        }
    return 0.5 * pairs;
  }

  void ContactWorkload::add_points(const std::size_t n_layers)
  {
    const double touching = half_thickness + 0.45 * spacing; // 5 % of a spacing deep
    for (std::size_t layer = 0; layer < n_layers; ++layer)
      for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i)
          {
            position[0].push_back(spacing * (static_cast<double>(i) + 0.3));
            position[1].push_back(spacing * (static_cast<double>(j) + 0.4));
            position[2].push_back(-touching - spacing * static_cast<double>(layer));
            id.push_back(static_cast<std::uint32_t>(id.size()));
          }
    velocity[0].assign(id.size(), 100.);
    velocity[1].assign(id.size(), 0.);
    velocity[2].assign(id.size(), 10.);
    for (auto &component : point_force)
      component.assign(id.size(), 0.);
    density.assign(id.size(), 1000.);
    mass.assign(id.size(), 1000. * spacing * spacing * spacing);
    sound_speed.assign(id.size(), 1100.);
  }

  /// A square plate of n by n facets that reaches 30 mm beyond the points, below and above.
  void ContactWorkload::add_plate(const std::size_t n)
  {
    for (std::size_t j = 0; j <= n; ++j)
      for (std::size_t i = 0; i <= n; ++i)
        node_position.insert(node_position.end(),
                             {edge * (static_cast<double>(i) - 6.), edge * (static_cast<double>(j) - 6.), 0.});
    const auto row = static_cast<std::int32_t>(n);
    for (std::int32_t j = 0; j < row; ++j)
      for (std::int32_t i = 0; i < row; ++i)
        {
          const auto a = static_cast<std::uint32_t>(i + (row + 1) * j), up = static_cast<std::uint32_t>(row + 1);
          const std::int32_t f = i + row * j;
          facet.push_back({a, a + 1, a + up + 1, a + up});
          neighbor.push_back(
            {j > 0 ? f - row : -1, i + 1 < row ? f + 1 : -1, j + 1 < row ? f + row : -1, i > 0 ? f - 1 : -1});
        }
    half_thicknesses.assign(facet.size(), half_thickness);
    node_velocity.assign(6 * (n + 1) * (n + 1), 0.);
    node_force   = node_velocity;
    inverse_mass = std::vector<double>((n + 1) * (n + 1), 1. / (4430. * 2. * half_thickness * edge * edge));
  }

  PointsView ContactWorkload::points() const
  {
    PointsView view;
    view.n = id.size();
    for (unsigned int d = 0; d < 3; ++d)
      {
        view.position[d] = position[d].data();
        view.velocity[d] = velocity[d].data();
      }
    view.mass                   = mass.data();
    view.density                = density.data();
    view.sound_speed            = sound_speed.data();
    view.id                     = id.data();
    view.n_ids                  = id.size();
    view.spacing                = spacing;
    view.hugoniot_slope         = 2.;
    view.undeformed_density     = density.front();
    view.undeformed_sound_speed = sound_speed.front();
    view.revision               = revision;
    return view;
  }

  FacetsView ContactWorkload::facets() const
  {
    FacetsView view;
    view.n_nodes         = inverse_mass.size();
    view.position        = node_position.data();
    view.velocity        = node_velocity.data();
    view.inverse_mass    = inverse_mass.data();
    view.velocity_stride = 6; // as a shell has it: translations first
    view.n_facets        = facet.size();
    view.nodes           = facet.data();
    view.neighbor        = neighbor.data();
    view.half_thickness  = half_thicknesses.data();
    return view;
  }
} // namespace birdstrike::benchmarks
