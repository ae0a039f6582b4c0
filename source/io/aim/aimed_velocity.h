#pragma once

#include <birdstrike/bird/parameters.h>
#include <birdstrike/core/number.h>
#include <birdstrike/structure/parameters.h>

namespace birdstrike
{
  /// Velocity of the bird, m/s: Bird/Velocity if `is_given`, else Speed along Angle to surface or Flight direction,
  /// else the default. Throws InputError where two of them contradict each other, and for half of an alternative.
  Point3 find_velocity(const BirdParameters &bird, const BladeParameters &blade, bool is_given);
} // namespace birdstrike
