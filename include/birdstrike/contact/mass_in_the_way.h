#pragma once

#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/number.h>

namespace birdstrike
{
  /// Share of the points' mass whose straight path, along their `velocity` relative to the blade (m/s), meets the
  /// outline of the blade as it is now: the skin of a solid, or the middle surface of a shell with its thickness,
  /// square at free edges. Points have no size here. 0 if there is no relative velocity.
  double compute_share_in_the_way(const PointsView &points, const FacetsView &facets, const Point3 &velocity);
} // namespace birdstrike
