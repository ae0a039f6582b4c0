#pragma once

#include "blade_case.h"

namespace birdstrike::test
{
  /// The plate of benchmark A4 in bricks, scaled as far as the plane allows.
  BladeParameters scaled_plate(unsigned int n_span, unsigned int n_chord, unsigned int n_layers);
  BladeParameters without_viscosity(BladeParameters p);
} // namespace birdstrike::test
