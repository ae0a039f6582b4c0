#include "structure/implicit/linear_solver.h"
#include "structure/implicit/direct_solver.h"
#include "structure/implicit/multigrid_solver.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/machine.h>

#include <fmt/format.h>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t most_direct_unknowns =
      50000; // measured: tests/studies/README.md, "Direct solver and multigrid"
  }

  bool takes_multigrid(const LinearSolverChoice choice, const std::size_t n_unknowns)
  {
    return choice == LinearSolverChoice::multigrid ||
           (choice == LinearSolverChoice::automatic && n_unknowns > most_direct_unknowns);
  }

  void require_memory_of_factors(const double bytes, const std::size_t n_unknowns)
  {
    if (const auto there = static_cast<double>(available_memory()); bytes > there)
      throw InputError(fmt::format("Blade/Spin/Linear solver: factors of {} unknowns take {:.3g} GB, and {:.3g} GB "
                                   "of memory are there.\nSet it to "
                                   "multigrid or automatic, or take a coarser mesh.",
                                   n_unknowns, 1e-9 * bytes, 1e-9 * there));
  }

  std::unique_ptr<LinearSolver> make_linear_solver(const LinearSolverChoice choice, SparseRows &&tangent,
                                                   const Equilibrium &equilibrium)
  {
    if (!takes_multigrid(choice, tangent.size()))
      return std::make_unique<DirectSolver>(tangent);
    return std::make_unique<MultigridSolver>(
      Multigrid(std::move(tangent), equilibrium.unknowns(), equilibrium.rigid_motions()));
  }
} // namespace birdstrike
