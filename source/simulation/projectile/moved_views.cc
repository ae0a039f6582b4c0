#include "simulation/projectile/moved_views.h"
#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/core/box.h>
#include <birdstrike/core/closest_point.h>
#include <birdstrike/core/errors.h>

#include <fmt/format.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    Box extent_of(const FacetsView &facets)
    {
      Box box;
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        for (const std::uint32_t n : facets.nodes[f])
          box.add(facets.position + 3 * n);
      return box;
    }

    std::string text_of(const std::array<double, 3> &x)
    {
      return fmt::format("({:.4g}, {:.4g}, {:.4g})", x[0], x[1], x[2]);
    }
  } // namespace

  Point3 find_velocity_at_aim(const Point3 &aim, const FacetsView &facets)
  {
    Point3 velocity = Point3::Zero();
    double smallest = INFINITY;
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      if (const auto closest = compute_closest_point(aim, facet_nodes(facets, f)); closest.distance_squared < smallest)
        {
          smallest      = closest.distance_squared;
          const auto at = [&](const unsigned int k) {
            return Point3(facets.velocity + facets.velocity_stride * facets.nodes[f][k]);
          };
          velocity = at(0);
          for (unsigned int k = 1; k < 4; ++k)
            velocity += closest.weights[k] * (at(k) - at(0)); // exact where all are the same
        }
    return velocity;
  }

  void refuse_overlap(const Overlap &overlap, const BirdParameters &parameters)
  {
    throw InputError(fmt::format(
      "The bird starts inside the blade: {:.3g} m deep at ({:.4g}, {:.4g}, {:.4g}).\n{}", overlap.depth,
      overlap.position[0], overlap.position[1], overlap.position[2],
      !parameters.position.empty() ? "Move " + parameters.section + "/Position, where it is at time 0."
      : parameters.stand_off > 0.  ? "Enlarge " + parameters.section + "/Stand-off, or set it to 0 to have it chosen."
                                   : "Move " + parameters.section + "/Aim point, about which it starts."));
  }

  void refuse_miss(const FacetsView &facets, const BirdParameters &parameters)
  {
    const Box blade = extent_of(facets);
    throw InputError(fmt::format("The bird misses the blade: no particle meets it along {0}/Velocity.\n"
                                 "The blade lies between {1} and {2} m.\n"
                                 "Change {3} or {0}/Velocity, or Blade/Mesh/File "
                                 "scale of a mesh in another unit than m.",
                                 parameters.section, text_of(blade.low), text_of(blade.high),
                                 parameters.position.empty()
                                   ? parameters.section + "/Aim point or Aim span fraction, " + parameters.section +
                                       "/Chordwise offset"
                                   : parameters.section + "/Position"));
  }
} // namespace birdstrike
