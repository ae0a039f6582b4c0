#pragma once

#include <birdstrike/core/contact_views.h>

namespace birdstrike
{
  /// Largest impulse (N s) that points in free flight could still give to a moving surface within `horizon` (s): the
  /// sum of m |v - v_b| over points whose straight path meets a block b of facets. A block is the box of 16 facets in
  /// the order of the mesh, every side moving with the extreme velocity of its nodes: blocks follow a bent blade, where
  /// one box would hold the whole space that it has swept.
  double compute_reachable_impulse(const PointsView &points, const FacetsView &facets, double horizon);
} // namespace birdstrike
