#pragma once

#include <birdstrike/core/warning.h>

namespace birdstrike
{
  struct BladeParameters;
  class Blade;
  class Projectile;

  /// How fast a target gives way at the aim point, as a share of the bird's normal speed v_n.
  ///
  /// A steady jet of the mass flow q pushes with q v_n. A wide plate, bending stiffness D, mass per area m, answers a
  /// force at a point with the speed F/(8 sqrt(D m)) (Cremer, Heckl & Ungar 1988, section 5.3.2), so the share is
  ///   q/(8 sqrt(D m)),   D = E t^3/(12 (1 - nu^2)),
  /// of a rigid surface of the mass M, which a bird of the mass m_b pushes before it, m_b/(m_b + M); of a fixed one 0.
  /// The thickness is that of the nearest facet of a shell, of a solid the mean one; material that of the blade itself.
  double compute_yielding(const BladeParameters &parameters, const Blade &blade, const Projectile &projectile);

  /// Warns (bird/stiff_target) of a bird with few particles on a target that hardly gives way.
  void check_stiff_target(const BladeParameters &parameters, const Blade &blade, const Projectile &projectile,
                          double n_particles_across, Warnings &warnings);
} // namespace birdstrike
