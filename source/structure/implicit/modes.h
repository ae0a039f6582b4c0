#pragma once

#include "structure/implicit/linear_solver.h"
#include <birdstrike/structure/modes.h>

namespace birdstrike
{
  /// The lowest `n` modes about the accepted state, of K - s M: by Krylov and Schur's method on its factors, or by
  /// conjugate gradients with multigrid. The shift s is a little below zero: bodies that nothing holds have modes of
  /// zero frequency, and are no exception. Of an unstable state it lies below the lowest eigenvalue, found by the
  /// factors' inertia: no unstable mode is missed.
  ///
  /// @throws InputError for more modes than unknowns allow, NumericalFailure if the method does not converge.
  VibrationModes compute_modes(Equilibrium &equilibrium, std::size_t n, LinearSolverChoice linear_solver);
} // namespace birdstrike
