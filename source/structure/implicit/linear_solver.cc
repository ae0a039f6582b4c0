#include "structure/implicit/linear_solver.h"
#include "structure/implicit/direct_solver.h"
#include "structure/implicit/multigrid_solver.h"

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t most_direct_unknowns = 50000; // measured: prm/README.md, "A blade that turns"
  }

  bool takes_multigrid(const LinearSolverChoice choice, const std::size_t n_unknowns)
  {
    return choice == LinearSolverChoice::multigrid ||
           (choice == LinearSolverChoice::automatic && n_unknowns > most_direct_unknowns);
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
