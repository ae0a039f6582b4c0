#include "structure/implicit/stability.h"
#include "structure/implicit/lobpcg.h"
#include "structure/implicit/symmetric_solver.h"
#include <birdstrike/core/numerical_failure.h>

namespace birdstrike
{
  std::optional<std::size_t> count_unstable(Equilibrium &equilibrium, const std::span<const double> step,
                                            const LinearSolverChoice linear_solver)
  {
    constexpr double tolerance = 1e-3; // of the lowest eigenvalue, whose sign alone matters
    const auto       decide    = [&](const std::size_t n) -> std::optional<std::size_t> {
      if (n > 0 && equilibrium.has_following_loads())
        return {};
      return n;
    };
    try
      {
        SparseRows tangent = equilibrium.compute_tangent(step);
        tangent.make_symmetric();
        if (!takes_multigrid(linear_solver, tangent.size()))
          return decide(SymmetricSolver(tangent).n_negative());
        const Multigrid multigrid(std::move(tangent), equilibrium.unknowns(), equilibrium.rigid_motions());
        return decide(find_by_lobpcg(multigrid, equilibrium.masses(), 1, tolerance).is_positive() ? 0 : 1);
      }
    catch (const NumericalFailure &)
      {
        return {}; // neutral, on the point of turning an element inside out, or the iteration has not converged
      }
  }
} // namespace birdstrike
