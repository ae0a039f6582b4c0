#include <birdstrike/contact/moving_patches.h>
#include <birdstrike/core/closest_point.h>
#include <birdstrike/core/errors.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

namespace birdstrike
{
  namespace
  {
    std::array<Point3, 4> corners(const FacetsView &facets, const std::array<std::uint32_t, 4> &nodes)
    {
      std::array<Point3, 4> x;
      for (unsigned int k = 0; k < 4; ++k)
        x[k] = Point3(facets.position + 3 * nodes[k]);
      return x;
    }

    /// Columns: along a diagonal, the normal, and across both.
    std::array<Point3, 3> axes(const std::array<Point3, 4> &x)
    {
      const Point3 along = (x[2] - x[0]).normalized(), normal = compute_area_vector(x).normalized();
      return {along, normal, normal.cross(along)};
    }
  } // namespace

  MovingPatches::MovingPatches(std::vector<PressurePatch> patches) : first(std::move(patches)), moved(first)
  {
  }

  void MovingPatches::hold(const FacetsView &facets)
  {
    anchors.assign(first.size(), {});
    for (std::size_t p = 0; p < first.size(); ++p)
      {
        const PressurePatch &patch = first[p];
        Anchor              &held  = anchors[p];
        Point3               arm   = Point3::Zero();
        double               least = std::numeric_limits<double>::infinity();
        for (std::size_t f = 0; f < facets.n_facets; ++f)
          if (const auto near = compute_closest_point(patch.centre, corners(facets, facets.nodes[f]));
              near.distance_squared < least)
            {
              least        = near.distance_squared;
              arm          = near.offset;
              held.nodes   = facets.nodes[f];
              held.weights = near.weights;
            }
        if (!(least <= patch.radius * patch.radius))
          throw InputError(fmt::format("Contact/Pressure patches: '{}' at ({:.6g}, {:.6g}, {:.6g}) m with a radius of "
                                       "{:.4g} m holds nothing of the blade, which is {:.4g} m away.\nGive a place on "
                                       "its surface.",
                                       patch.name, patch.centre[0], patch.centre[1], patch.centre[2], patch.radius,
                                       std::sqrt(least)));
        const auto of_facet = axes(corners(facets, held.nodes));
        for (unsigned int d = 0; d < 3; ++d)
          held.own[d] = of_facet[d].dot(arm);
        held.start = held.place(facets);
      }
  }

  Point3 MovingPatches::Anchor::place(const FacetsView &facets) const
  {
    const auto x = corners(facets, nodes);
    const auto r = axes(x);
    Point3     g = own[0] * r[0] + own[1] * r[1] + own[2] * r[2];
    for (unsigned int k = 0; k < 4; ++k)
      g += weights[k] * x[k];
    return g;
  }

  const std::vector<PressurePatch> &MovingPatches::move(const FacetsView &facets)
  {
    for (std::size_t p = 0; p < anchors.size(); ++p)
      {
        moved[p].centre = first[p].centre + (anchors[p].place(facets) - anchors[p].start);
        if (facets.plane.exists() && first[p].centre[1] == 0.)
          moved[p].centre[1] = 0.;
      }
    return moved;
  }
} // namespace birdstrike
