#pragma once

#include <birdstrike/structure/parameters.h>

#include <vector>

namespace birdstrike::test
{
  /// Natural frequencies (Hz) of bending and torsion: the tangent stiffness column by column from the blade's own
  /// verbs (exact: elasticity is linear in the increment at this size), the mass as lumped.
  std::vector<double> natural_frequencies(const BladeParameters &parameters);
} // namespace birdstrike::test
