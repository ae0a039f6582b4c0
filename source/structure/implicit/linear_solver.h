#pragma once

#include "structure/implicit/equilibrium.h"
#include <birdstrike/structure/choices.h>

#include <memory>
#include <span>
#include <vector>

namespace birdstrike
{
  /// Solves equations with one sparse matrix.
  class LinearSolver
  {
  public:
    virtual ~LinearSolver() = default;

    /// `tolerance` is what may be left of the right-hand side, in the norm of the scaled equations; factors leave
    /// round-off.
    ///
    /// @throws NumericalFailure where that is not reached.
    virtual void solve(std::span<const double> right, double tolerance, std::vector<double> &result) = 0;

    /// Of Krylov's methods, all solves together; none of factors.
    std::size_t n_iterations = 0;
  };

  /// Automatic is multigrid beyond the size (most_direct_unknowns) to which factors are as quick.
  bool takes_multigrid(LinearSolverChoice choice, std::size_t n_unknowns);
  /// Throws InputError where factors (bytes, by an estimate) are more than the memory that is left: a process that
  /// takes more is killed without a word.
  void require_memory_of_factors(double bytes, std::size_t n_unknowns);
  /// For a tangent of this equilibrium, at the position of its last forces.
  ///
  /// @throws NumericalFailure for a singular matrix.
  std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverChoice choice, SparseRows &&tangent,
                                                   const Equilibrium &equilibrium);
} // namespace birdstrike
