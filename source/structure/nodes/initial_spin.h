#pragma once

#include <birdstrike/core/number.h>
#include <birdstrike/structure/parameters.h>

namespace birdstrike
{
  /// rad/s, about the origin; zero where the loads have none.
  Point3 read_initial_spin(const BladeParameters::Loads &loads);

  /// Throws InputError where a spin gives a held unknown of a node at `x` (m) a velocity (m/s or rad/s).
  void require_no_spin(const Point3 &spin, double velocity, const Point3 &x);
} // namespace birdstrike
