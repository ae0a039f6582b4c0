#include <birdstrike/contact/moving_patches.h>
#include <birdstrike/core/closest_point.h>
#include <birdstrike/core/errors.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
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
    /// Of the disc in the plane of the first and last of `axes`, by places spread evenly over it (a sunflower's). Of
    /// half a scene what lies beyond the plane is its mirror image.
    double compute_covered_share(const FacetsView &facets, const PressurePatch &disc, const std::array<Point3, 3> &axes)
    {
      constexpr unsigned int n        = 4096;
      const auto             in_plane = [&](const Point3 &x) -> std::array<double, 2> {
        return {(x - disc.centre).dot(axes[0]), (x - disc.centre).dot(axes[2])};
      };
      std::vector<std::array<std::array<double, 2>, 4>> near;
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        if (const auto x = corners(facets, facets.nodes[f]);
            compute_closest_point(disc.centre, x).distance_squared <= 2. * disc.radius * disc.radius)
          near.push_back({in_plane(x[0]), in_plane(x[1]), in_plane(x[2]), in_plane(x[3])});
      const auto side = [](const auto &a, const auto &b, const auto &p) { // of the line from a to b
        return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
      };
      const auto is_in = [&](const auto &a, const auto &b, const auto &c, const auto &p) {
        const double one = side(a, b, p), two = side(b, c, p), three = side(c, a, p);
        return (one >= 0. && two >= 0. && three >= 0.) || (one <= 0. && two <= 0. && three <= 0.);
      };
      unsigned int n_covered = 0;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double r = disc.radius * std::sqrt((i + 0.5) / n), angle = i * std::numbers::pi * (3. - std::sqrt(5.));
          Point3       x = disc.centre + r * (std::cos(angle) * axes[0] + std::sin(angle) * axes[2]);
          if (facets.plane.exists())
            x[1] = std::abs(x[1]);
          const auto p = in_plane(x);
          n_covered += std::any_of(near.begin(), near.end(), [&](const auto &q) {
            return is_in(q[0], q[1], q[2], p) || is_in(q[0], q[2], q[3], p);
          });
        }
      return n_covered / double(n);
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
        const auto   of_facet = axes(corners(facets, held.nodes));
        const double covered =
          least <= patch.radius * patch.radius ? compute_covered_share(facets, patch, of_facet) : 0.;
        if (covered == 0.)
          throw InputError(fmt::format("Contact/Pressure patches: '{}' at ({:.6g}, {:.6g}, {:.6g}) m with a radius of "
                                       "{:.4g} m holds nothing of the blade, {}.\nGive a place on its surface, and a "
                                       "radius in m.",
                                       patch.name, patch.centre[0], patch.centre[1], patch.centre[2], patch.radius,
                                       least <= patch.radius * patch.radius
                                         ? "which covers none of its places: the disc is far too large"
                                         : fmt::format("which is {:.4g} m away", std::sqrt(least))));
        moved[p].area   = covered * patch.area;
        moved[p].normal = of_facet[1];
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
        moved[p].normal = axes(corners(facets, anchors[p].nodes))[1];
        if (facets.plane.exists() && first[p].centre[1] == 0.)
          moved[p].centre[1] = 0.;
      }
    return moved;
  }
} // namespace birdstrike
