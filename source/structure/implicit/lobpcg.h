#pragma once

#include "structure/implicit/eigenpairs.h"
#include "structure/implicit/multigrid.h"

namespace birdstrike
{
  /// By Knyazev's locally optimal block preconditioned conjugate gradients (2001, SIAM J. Sci. Comput. 23, 517), the
  /// bases made orthonormal as in Hetmaniuk & Lehoucq 2006, J. Comput. Phys. 218, 324; some vectors more than are asked
  /// for, so that the last does not wait for its neighbour. `shifted`: K - s M with multigrid; masses: M, [n].
  ///
  /// What is left is measured by r^T P r/lambda, P the preconditioner: the error of the eigenvalue up to what P is off
  /// the inverse, whatever the mesh and the units.
  ///
  /// It ends with the first Rayleigh quotient that is not positive (Eigenpairs::is_positive): multigrid is for stable
  /// states.
  ///
  /// @throws NumericalFailure if it does not converge.
  Eigenpairs find_by_lobpcg(const Multigrid &shifted, const std::vector<double> &masses, std::size_t n,
                            double tolerance = 1e-9);
} // namespace birdstrike
