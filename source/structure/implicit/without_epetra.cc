#include "structure/implicit/direct_solver.h"
#include "structure/implicit/krylov_schur.h"
#include "structure/implicit/multigrid.h"
#include <birdstrike/core/errors.h>

/// Compiled where Trilinos has no Epetra, Amesos, ML or Anasazi, in place of what is made of them.
namespace birdstrike
{
  namespace
  {
    [[noreturn]] void refuse()
    {
      throw InputError(
        "This program was built without Trilinos' Epetra, Amesos, ML and Anasazi: static equilibrium and "
        "modes are not there.\nBuild it with Trilinos 13 to 16, or set Blade/Spin/Prestress = false to "
        "run a strike without static equilibrium.");
    }
  } // namespace

  struct DirectSolver::Trilinos
  {
  };

  DirectSolver::DirectSolver(const SparseRows &)
  {
    refuse();
  }

  DirectSolver::~DirectSolver() = default;

  void DirectSolver::solve(std::span<const double>, double, std::vector<double> &)
  {
    refuse();
  }

  struct Multigrid::Trilinos
  {
  };

  Multigrid::Multigrid(SparseRows &&, const FreeUnknowns &, const std::vector<std::vector<double>> &)
  {
    refuse();
  }

  Multigrid::Multigrid(Multigrid &&) noexcept = default;
  Multigrid::~Multigrid()                     = default;

  void Multigrid::multiply(const double *, double *) const
  {
    refuse();
  }

  void Multigrid::precondition(const double *, double *) const
  {
    refuse();
  }

  Eigenpairs find_by_krylov_schur(LinearSolver &, const std::vector<double> &, std::size_t)
  {
    refuse();
  }
} // namespace birdstrike
