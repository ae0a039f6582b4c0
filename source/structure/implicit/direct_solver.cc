#include "structure/implicit/direct_solver.h"
#include "structure/implicit/mpi.h"
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/core/quiet_errors.h>

#include <fmt/format.h> // before Amesos_Mumps.h, which has a compare of its own

#include <deal.II/base/index_set.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <Amesos.h>
#include <Amesos_Mumps.h>
#include <Epetra_LinearProblem.h>

#include <algorithm>

namespace birdstrike
{
  struct DirectSolver::Trilinos
  {
    dealii::TrilinosWrappers::SparseMatrix matrix;
    dealii::TrilinosWrappers::MPI::Vector  right, result;
    Epetra_LinearProblem                   problem;
    std::unique_ptr<Amesos_BaseSolver>     solver;

    explicit Trilinos(const SparseRows &rows)
      : matrix(dealii::complete_index_set(rows.size()), MPI_COMM_SELF, lengths(rows))
    {
      for (std::uint32_t r = 0; r < rows.size(); ++r)
        matrix.set(r, rows.begin[r + 1] - rows.begin[r], &rows.column[rows.begin[r]], &rows.value[rows.begin[r]],
                   false);
      matrix.compress(dealii::VectorOperation::insert);
      right.reinit(dealii::complete_index_set(rows.size()), MPI_COMM_SELF);
      result.reinit(right);
      problem.SetOperator(const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix()));
      problem.SetLHS(&result.trilinos_vector());
      problem.SetRHS(&right.trilinos_vector());
      Amesos factory;
      solver.reset(factory.Create(factory.Query("Amesos_Mumps") ? "Amesos_Mumps" : "Amesos_Klu", problem));
      Teuchos::ParameterList quiet;
      quiet.set("OutputLevel", 0);
      quiet.set("PrintTiming", false);
      quiet.set("PrintStatus", false);
      solver->SetParameters(quiet);
      const QuietErrors quietly; // Amesos prints what MUMPS says of a singular matrix
      const bool        is_analysed = solver->SymbolicFactorization() == 0;
      if (is_analysed)
        require_memory();
      if (!is_analysed || solver->NumericFactorization() != 0)
        throw NumericalFailure("Static solve: the tangent is singular. Is the blade constrained, and is every part of "
                               "the mesh joined to a constrained part?");
    }

    /// MUMPS estimates what its factors and fronts will take.
    void require_memory() const
    {
      auto *mumps = dynamic_cast<Amesos_Mumps *>(solver.get());
      if (mumps == nullptr)
        return;
      constexpr int estimate = 15; // INFOG(16), in millions of bytes
      require_memory_of_factors(1e6 * mumps->GetINFOG()[estimate], right.size());
    }

    static std::vector<unsigned int> lengths(const SparseRows &rows)
    {
      std::vector<unsigned int> n_columns;
      for (std::size_t r = 0; r < rows.size(); ++r)
        n_columns.push_back(rows.begin[r + 1] - rows.begin[r]);
      return n_columns;
    }
  };

  DirectSolver::DirectSolver(const SparseRows &matrix)
  {
    start_mpi();
    trilinos = std::make_unique<Trilinos>(matrix);
  }

  DirectSolver::~DirectSolver() = default;

  void DirectSolver::solve(const std::span<const double> right, double, std::vector<double> &result)
  {
    std::copy(right.begin(), right.end(), trilinos->right.begin());
    if (trilinos->solver->Solve() != 0)
      throw NumericalFailure("Static solve: the factorised tangent could not be solved with.");
    result.assign(trilinos->result.begin(), trilinos->result.end());
  }
} // namespace birdstrike
