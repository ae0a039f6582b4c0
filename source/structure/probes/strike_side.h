#pragma once

#include "structure/probes/sections.h"
#include <birdstrike/core/energy_report.h>
#include <birdstrike/mesh/orientation.h>
#include <birdstrike/structure/parameters.h>

namespace birdstrike
{
  /// Velocity (m/s) of the bird relative to the blade's centre of mass at the start; zero without a bird. `momentum`
  /// and `mass` (kg) are the blade's.
  inline Point3 compute_strike(const BladeParameters &parameters, const MomentumReport &momentum, const double mass)
  {
    if (!parameters.bird_velocity)
      return Point3::Zero();
    return Point3(parameters.bird_velocity->data()) - Point3(momentum.momentum.data()) / mass;
  }

  /// Turns root and tip so that their normals point away from the struck side (orientation.h). Both look to one side of
  /// the blade: the tip decides, the root of a blade without one. A twist beyond a right angle between them is taken
  /// from the mesh where its cells run through (`is_one_surface`), else it cannot be seen.
  template <class Root>
  void turn_from_strike(const Point3 &strike, const bool is_one_surface, Root &root, TipRow &tip)
  {
    const bool has_root = !root.section().nodes.empty(), has_tip = tip.is_present();
    if (!has_root && !has_tip)
      return;
    if (!is_one_surface && has_root && has_tip && root.section().normal.dot(tip.surface_normal()) < 0.)
      root.turn();
    if (looks_at_strike(has_tip ? tip.surface_normal() : root.section().normal, strike))
      {
        root.turn();
        tip.turn();
      }
  }
} // namespace birdstrike
