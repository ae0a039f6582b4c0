#include "structure/implicit/krylov_schur.h"
#include "structure/implicit/mpi.h"
#include <birdstrike/core/numerical_failure.h>

#include <AnasaziBasicEigenproblem.hpp>
#include <AnasaziBlockKrylovSchurSolMgr.hpp>
#include <AnasaziEpetraAdapter.hpp>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <Epetra_MultiVector.h>
#include <Epetra_Operator.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double tolerance = 1e-10; // of the inverse's eigenvalues

    /// M^1/2 (K - s M)^-1 M^1/2.
    class ShiftedInverse : public Epetra_Operator
    {
    public:
      ShiftedInverse(LinearSolver &shifted, std::vector<double> roots_of_masses, const Epetra_Map &map)
        : solver(shifted), root(std::move(roots_of_masses)), map(map)
      {
      }

      int Apply(const Epetra_MultiVector &x, Epetra_MultiVector &y) const override
      {
        std::vector<double> right(root.size()), result;
        for (int column = 0; column < x.NumVectors(); ++column)
          {
            for (std::size_t i = 0; i < root.size(); ++i)
              right[i] = root[i] * x[column][i];
            solver.solve(right, 0., result);
            for (std::size_t i = 0; i < root.size(); ++i)
              y[column][i] = root[i] * result[i];
          }
        return 0;
      }
      int ApplyInverse(const Epetra_MultiVector &, Epetra_MultiVector &) const override
      {
        return -1;
      }
      int SetUseTranspose(const bool is_transposed) override
      {
        return is_transposed ? -1 : 0;
      }
      double NormInf() const override
      {
        return -1.;
      }
      const char *Label() const override
      {
        return "shifted inverse";
      }
      bool UseTranspose() const override
      {
        return false;
      }
      bool HasNormInf() const override
      {
        return false;
      }
      const Epetra_Comm &Comm() const override
      {
        return map.Comm();
      }
      const Epetra_Map &OperatorDomainMap() const override
      {
        return map;
      }
      const Epetra_Map &OperatorRangeMap() const override
      {
        return map;
      }

    private:
      LinearSolver       &solver;
      std::vector<double> root;
      const Epetra_Map   &map;
    };
  } // namespace

  Eigenpairs find_by_krylov_schur(LinearSolver &shifted, const std::vector<double> &masses, const std::size_t n)
  {
    start_mpi();
    using Vectors            = Epetra_MultiVector;
    const std::size_t   size = masses.size();
    std::vector<double> root;
    for (const double m : masses)
      root.push_back(std::sqrt(m));
    const Epetra_MpiComm comm(MPI_COMM_SELF);
    const Epetra_Map     map(static_cast<int>(size), 0, comm);
    const auto           inverse = Teuchos::rcp(new ShiftedInverse(shifted, root, map));
    const auto           start   = Teuchos::rcp(new Vectors(map, 1));
    for (std::size_t i = 0; i < size; ++i) // no mode is square to it, and it is the same in every run
      (*start)[0][i] = 1. + 0.5 * std::sin(1. + 1.7 * static_cast<double>(i));
    const auto problem = Teuchos::rcp(new Anasazi::BasicEigenproblem<double, Vectors, Epetra_Operator>(inverse, start));
    problem->setHermitian(true);
    problem->setNEV(static_cast<int>(n));
    problem->setProblem();
    Teuchos::ParameterList choices;
    choices.set("Which", "LM");
    choices.set("Block Size", 1);
    choices.set("Num Blocks", static_cast<int>(std::min(size - 1, 3 * n + 10)));
    choices.set("Maximum Restarts", 100);
    choices.set("Convergence Tolerance", tolerance);
    choices.set("Verbosity", 0);
    Anasazi::BlockKrylovSchurSolMgr<double, Vectors, Epetra_Operator> manager(problem, choices);
    if (manager.solve() != Anasazi::Converged)
      throw NumericalFailure("Modes: the Krylov-Schur method has not converged. Ask for another number of modes.");

    Eigenpairs  pairs;
    const auto &solution = problem->getSolution();
    for (int k = 0; k < solution.numVecs; ++k)
      {
        pairs.values.push_back(1. / solution.Evals[k].realpart);
        pairs.vectors.emplace_back();
        for (std::size_t i = 0; i < size; ++i)
          pairs.vectors.back().push_back((*solution.Evecs)[k][i] / root[i]);
      }
    return pairs;
  }
} // namespace birdstrike
