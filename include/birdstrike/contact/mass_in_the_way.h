#pragma once

#include <birdstrike/core/contact_views.h>

namespace birdstrike
{
  /// Share of the points' mass whose straight path, along the mean velocity of all points relative to the mean of the
  /// nodes, meets the outline of the blade as it is now: the skin of a solid, or the middle surface of a shell with its
  /// thickness, square at free edges. Points have no size here. 0 if there is no relative velocity.
  double compute_share_in_the_way(const PointsView &points, const FacetsView &facets);
} // namespace birdstrike
