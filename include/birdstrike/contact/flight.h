#pragma once

#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/number.h>

#include <cstdint>

namespace birdstrike
{
  /// Where points come closest to touching before the first step.
  struct Overlap
  {
    double        depth = 0.; ///< m, largest penetration of the offset surface; 0 if nothing overlaps
    std::uint32_t id    = 0;
    Point3        position{0., 0., 0.}; ///< m
  };

  /// Time at which the first point touches the offset surface (law and offset as in NarrowPhase), while all points fly
  /// on with their velocities and the facets rest; infinity if none ever does, 0 if one touches now.
  ///
  /// The distance from a moving point to a convex facet is a convex function of time, so Newton's method on distance -
  /// g starts and stays before the root: on a face it is exact at the first step, and a point whose distance no longer
  /// falls misses. Where that surface without edges is touched, the search for the one with edges (EdgeTouch) starts.
  double time_to_first_touch(const PointsView &points, const FacetsView &facets);

  /// Deepest penetration now, for refusing points that start inside the surface.
  Overlap initial_overlap(const PointsView &points, const FacetsView &facets);
} // namespace birdstrike
