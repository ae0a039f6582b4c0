#include "structure/implicit/modes.h"
#include "structure/implicit/direct_solver.h"
#include "structure/implicit/mpi.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/numerical_failure.h>

#include <AnasaziBasicEigenproblem.hpp>
#include <AnasaziBlockKrylovSchurSolMgr.hpp>
#include <AnasaziEpetraAdapter.hpp>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <Epetra_MultiVector.h>
#include <Epetra_Operator.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace birdstrike
{
  namespace
  {
    constexpr double relative_shift = 1e-9;  // of the mean of K_ii/M_ii: below all modes that are not of a free body
    constexpr double tolerance      = 1e-10; // of the inverse's eigenvalues

    /// M^1/2 (K - s M)^-1 M^1/2.
    class ShiftedInverse : public Epetra_Operator
    {
    public:
      ShiftedInverse(const SparseRows &shifted, std::vector<double> roots_of_masses, const Epetra_Map &map)
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
            solver.solve(right, result);
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
      mutable DirectSolver solver;
      std::vector<double>  root;
      const Epetra_Map    &map;
    };

    /// Takes the symmetric part; returns |K - K^T| over |K|.
    double make_symmetric(SparseRows &k)
    {
      double difference = 0., norm = 0.;
      for (std::size_t row = 0; row < k.size(); ++row)
        for (std::size_t e = k.begin[row]; e < k.begin[row + 1]; ++e)
          {
            norm += k.value[e] * k.value[e];
            // patterns are not symmetric where displacements reach farther than rotations
            const std::uint32_t column = k.column[e];
            const auto   first = k.column.begin() + k.begin[column], last = k.column.begin() + k.begin[column + 1];
            const auto   found    = std::lower_bound(first, last, row);
            const bool   is_there = found != last && *found == row;
            double      *mirrored = is_there ? &k.value[found - k.column.begin()] : nullptr;
            const double other    = is_there ? *mirrored : 0.;
            if (is_there && column < row)
              continue; // done
            difference += (is_there && column != row ? 2. : 1.) * (k.value[e] - other) * (k.value[e] - other);
            k.value[e] = 0.5 * (k.value[e] + other);
            if (is_there)
              *mirrored = k.value[e];
          }
      return std::sqrt(difference / norm);
    }

    VibrationModes::Mode make_mode(const Equilibrium &equilibrium, const std::vector<double> &masses,
                                   const double value, std::vector<double> shape)
    {
      VibrationModes::Mode  mode;
      std::array<double, 3> moving{}, all{};
      double                modal = 0.;
      mode.frequency              = std::copysign(std::sqrt(std::abs(value)), value) / (2. * std::numbers::pi);
      for (std::size_t k = 0; k < shape.size(); ++k)
        {
          const FreeUnknown &unknown = equilibrium.unknowns()[k];
          modal += masses[k] * shape[k] * shape[k];
          for (unsigned int d = 0; d < 3 && !unknown.is_rotation; ++d)
            {
              moving[d] += masses[k] * shape[k] * unknown.axis[d];
              all[d] += masses[k] * unknown.axis[d] * unknown.axis[d];
            }
        }
      for (unsigned int d = 0; d < 3; ++d)
        mode.effective_mass[d] = all[d] > 0. ? moving[d] * moving[d] / (modal * all[d]) : 0.;
      mode.shape     = equilibrium.nodal_displacements(shape);
      double largest = 0., sign = 1.;
      for (std::size_t n = 0; n < mode.shape.size(); n += 3)
        if (const Point3 u(&mode.shape[n]); u.norm() > largest * (1. + 1e-6))
          {
            largest = u.norm();
            Eigen::Index k;
            u.cwiseAbs().maxCoeff(&k);
            sign = u[k] < 0. ? -1. : 1.;
          }
      for (double &u : mode.shape)
        u *= largest > 0. ? sign / largest : 0.;
      return mode;
    }
  } // namespace

  double modal_assurance(const std::vector<double> &a, const std::vector<double> &b)
  {
    const auto dot = [](const auto &u, const auto &v) { return std::inner_product(u.begin(), u.end(), v.begin(), 0.); };
    const double shared = dot(a, b), squares = dot(a, a) * dot(b, b);
    return squares > 0. ? shared * shared / squares : 0.;
  }

  VibrationModes compute_modes(Equilibrium &equilibrium, const std::size_t n)
  {
    using Vectors          = Epetra_MultiVector;
    const std::size_t size = equilibrium.unknowns().size();
    if (3 * n + 1 > size)
      throw InputError("Modes: " + std::to_string(n) + " modes of " + std::to_string(size) +
                       " unknowns were asked for.\nAllowed: up to a third of the unknowns; ask for fewer or refine the "
                       "mesh.");
    start_mpi();
    const std::vector<double> masses    = equilibrium.masses();
    SparseRows                stiffness = equilibrium.compute_tangent(std::vector<double>(size, 0.));
    VibrationModes            result;
    result.n_unknowns        = size;
    result.asymmetry         = make_symmetric(stiffness);
    double              mean = 0.;
    std::vector<double> root;
    for (std::uint32_t k = 0; k < size; ++k)
      {
        mean += stiffness.at(k, k) / (masses[k] * static_cast<double>(size));
        root.push_back(std::sqrt(masses[k]));
      }
    const double shift = -relative_shift * mean;
    for (std::uint32_t k = 0; k < size; ++k)
      stiffness.at(k, k) -= shift * masses[k];

    const Epetra_MpiComm comm(MPI_COMM_SELF);
    const Epetra_Map     map(static_cast<int>(size), 0, comm);
    const auto           inverse = Teuchos::rcp(new ShiftedInverse(stiffness, root, map));
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

    const auto &solution = problem->getSolution();
    for (int k = 0; k < solution.numVecs; ++k)
      {
        std::vector<double> shape(size);
        for (std::size_t i = 0; i < size; ++i)
          shape[i] = (*solution.Evecs)[k][i] / root[i];
        result.modes.push_back(
          make_mode(equilibrium, masses, 1. / solution.Evals[k].realpart + shift, std::move(shape)));
      }
    std::sort(result.modes.begin(), result.modes.end(),
              [](const auto &a, const auto &b) { return a.frequency < b.frequency; });
    if (result.modes.size() > n) // where the cut falls into a pair of equal ones, both come
      result.modes.resize(n);
    return result;
  }
} // namespace birdstrike
