#pragma once

#include "structure/deformable_blade.h"

#include <vector>

namespace birdstrike::test
{
  /// Lowest natural frequencies (Hz) of a blade, shell or solid, without bulk viscosity, by subspace iteration on its
  /// tangent stiffness and lumped mass.
  template <class AnyBlade>
  std::vector<double> natural_frequencies(AnyBlade &blade, unsigned int n_modes);

  /// The same of a plate of equal bricks with scaled masses, M_s.
  std::vector<double> scaled_frequencies(SolidBlade &blade, unsigned int n_modes);
} // namespace birdstrike::test
