#pragma once

#include "structure/elements/shell/batch.h"
#include "structure/elements/shell/belytschko_tsay.h"

namespace birdstrike
{
  // What the loops over one-point elements share, whatever the section's law.

  template <bool physical>
  [[gnu::always_inline]] inline ShellVector<Lanes>
  compute_strain_increments(const ShellGeometry<Lanes> &midpoint, const Lanes &thickness,
                            const double hourglass_coefficient, const ShellModes<Lanes> &u, const BatchNodes &nodes)
  {
    if constexpr (physical)
      return physical_shell::compute_strains(midpoint, u, turn_directors(midpoint, nodes));
    else
      return BelytschkoTsay<Lanes>(midpoint, thickness, hourglass_coefficient)
        .compute_strains(nodes.increment, nodes.rotation, nodes.midpoint_normal);
  }

  template <bool physical>
  [[gnu::always_inline]] inline void
  compute_corner_forces(const ShellGeometry<Lanes> &end, const ShellStress<Lanes> &stress, const Lanes &contraction,
                        const double hourglass_coefficient, const Corners &normal, Corners (&force)[2])
  {
    const ShellVector<Lanes> resultants = compute_resultants(stress, contraction);
    if constexpr (physical)
      {
        ShellModes<Lanes> f, fd;
        physical_shell::compute_mode_forces(end, resultants, f, fd);
        sum_corner_forces(end, f, fd, force);
      }
    else
      BelytschkoTsay<Lanes>(end, stress.thickness, hourglass_coefficient)
        .compute_corner_forces(resultants, normal, force[0], force[1]);
  }
} // namespace birdstrike
