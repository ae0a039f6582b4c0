#pragma once

#include "structure/implicit/eigenpairs.h"
#include "structure/implicit/linear_solver.h"

#include <cstddef>

namespace birdstrike
{
  /// By Krylov and Schur's method of Anasazi (Baker, Hetmaniuk, Lehoucq & Thornquist 2009) on the inverse
  /// M^1/2 (K - s M)^-1 M^1/2 by its factors: the nearest to s. masses: M, [n]. Equal ones come together, in any order
  /// and one more than asked for where the cut would part them.
  ///
  /// @throws NumericalFailure if it does not converge.
  Eigenpairs find_by_krylov_schur(LinearSolver &shifted, const std::vector<double> &masses, std::size_t n);
} // namespace birdstrike
