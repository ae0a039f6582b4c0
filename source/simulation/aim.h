#pragma once

#include <birdstrike/report/run_view.h>

namespace birdstrike
{
  struct Scene;

  /// Of a scene that has just been built. Pressures of a normal shock p_H = rho U_s v_n and of steady flow rho v^2/2
  /// (Wilbeck 1978), of what the bird does relative to the surface.
  StrikeAim compute_aim(const CaseParameters &parameters, const Scene &scene);
} // namespace birdstrike
