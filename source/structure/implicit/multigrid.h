#pragma once

#include "structure/implicit/stencil.h"

#include <memory>
#include <vector>

namespace birdstrike
{
  /// A sparse matrix K with an approximate inverse: one W-cycle of algebraic multigrid by smoothed aggregation (Vanek,
  /// Mandel & Brezina 1996, Computing 56, 179), by Trilinos' ML. Aggregates are of nodes; what a coarse level must
  /// carry without error are the six rigid motions, of shells with their rotations. Chebyshev's polynomials smooth.
  ///
  /// All is in scaled unknowns, K' = D K D with a diagonal of ones, x = D x': displacements and rotations are of one
  /// size there. Missing unknowns of partly held nodes are filled up inside, since ML wants as many of each node.
  ///
  /// The same matrix gives the same bits, whatever was made before.
  class Multigrid
  {
  public:
    /// `rigid_motions`: [6][n], see Equilibrium. Throws NumericalFailure for an unknown without stiffness.
    Multigrid(SparseRows &&matrix, const FreeUnknowns &unknowns, const std::vector<std::vector<double>> &rigid_motions);
    Multigrid(Multigrid &&) noexcept;
    ~Multigrid();

    /// D, [n]
    const std::vector<double> &scale() const
    {
      return scaling;
    }
    /// K' x', [n]
    void multiply(const double *x, double *result) const;
    /// Nearly x' of K' x' = right, [n]: symmetric and positive if K is.
    void precondition(const double *right, double *result) const;

  private:
    struct Trilinos;
    std::vector<double>       scaling;
    std::unique_ptr<Trilinos> trilinos;
  };
} // namespace birdstrike
