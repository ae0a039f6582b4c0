#pragma once

#include <birdstrike/report/run_view.h>

namespace birdstrike
{
  class Blade;
  class Projectile;

  /// Of a bird at its first touch with the blade as it lies at the start, of one that turns at the arrival time.
  /// Pressures of a normal shock p_H = rho U_s v_n and of steady flow rho v^2/2 (Wilbeck 1978), of what the bird does
  /// relative to the surface.
  StrikeAim compute_aim(const Projectile &projectile, const Blade &blade);
} // namespace birdstrike
