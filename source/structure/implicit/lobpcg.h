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
  /// @throws NumericalFailure if it does not converge, or finds a negative eigenvalue: multigrid is for stable states.
  Eigenpairs find_by_lobpcg(const Multigrid &shifted, const std::vector<double> &masses, std::size_t n);
} // namespace birdstrike
