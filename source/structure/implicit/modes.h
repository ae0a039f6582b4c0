#pragma once

#include "structure/implicit/equilibrium.h"
#include <birdstrike/structure/modes.h>

namespace birdstrike
{
  /// The lowest `n` modes about the accepted state, by Krylov and Schur's method of Anasazi (Baker, Hetmaniuk, Lehoucq
  /// & Thornquist 2009) on the shifted inverse M^1/2 (K - s M)^-1 M^1/2, factorised once. The shift s is a little below
  /// zero: bodies that nothing holds have modes of zero frequency, and are no exception.
  ///
  /// @throws InputError for more modes than unknowns allow, NumericalFailure if the method does not converge.
  VibrationModes compute_modes(Equilibrium &equilibrium, std::size_t n);
} // namespace birdstrike
