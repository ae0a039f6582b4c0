#pragma once

#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/contact_views.h>

namespace birdstrike
{
  /// Area over mass of each node (m^2/kg): what a light surface yields to pressure. Zero where the node is held. The
  /// area is a quarter of those of its facets, and at least that of a point, L^2 with L in m: one point alone may stand
  /// on a node; of one on a plane of symmetry, which has half of its facets and its mass, half of that.
  AlignedVector<double> compute_areal_flexibility(const FacetsView &facets, double point_size);
} // namespace birdstrike
