#pragma once

#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/core/closest_point.h>

#include <algorithm>
#include <cstdint>
#include <numbers>

namespace birdstrike
{
  constexpr double blunt_ridge = std::numbers::pi / 6.; ///< ridges of smaller angles have no chamfer

  constexpr double share_starts_at  = 0.5,
                   share_is_full_at = 0.2; ///< cosines between two touching directions (NarrowPhase)

  inline Point3 node_at(const FacetsView &facets, const std::uint32_t node)
  {
    return Eigen::Map<const Point3>(facets.position + 3 * node);
  }

  /// From 0 in a to 1 in b.
  inline double share_of_segment(const Point3 &p, const Point3 &a, const Point3 &b)
  {
    const Point3 along = b - a;
    return std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-300), 0., 1.);
  }

  inline Point3 closest_on_segment(const Point3 &p, const Point3 &a, const Point3 &b)
  {
    return a + share_of_segment(p, a, b) * (b - a);
  }

  /// Frame of a face at its edge from a to b: the face's normal there and the outward direction in its plane.
  struct EdgeFrame
  {
    Point3 normal, outward;
  };
  inline EdgeFrame edge_frame(const FacetsView &facets, const std::int32_t facet, const Point3 &a, const Point3 &b)
  {
    const auto   x      = facet_nodes(facets, static_cast<std::size_t>(facet));
    const Point3 centre = 0.25 * (x[0] + x[1] + x[2] + x[3]);
    const Point3 normal = (b - a).cross(centre - a).normalized();
    return {normal, (b - a).cross(normal).normalized()};
  }
} // namespace birdstrike
