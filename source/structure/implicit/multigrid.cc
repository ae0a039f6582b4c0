#include "structure/implicit/multigrid.h"
#include "structure/implicit/mpi.h"
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/core/quiet_errors.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <Epetra_Vector.h>
#include <ml_MultiLevelPreconditioner.h>
#include <ml_utils.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr int n_rigid_motions = 6;
    constexpr int seed            = 1; // of the vectors from which ML estimates largest eigenvalues

    /// Where the unknowns stand when every node that has some has as many.
    struct Places
    {
      std::vector<int> of; ///< [n]
      int              n_of_node = 3, n = 0;

      explicit Places(const FreeUnknowns &unknowns)
      {
        for (std::size_t k = 0; k < unknowns.size() && n_of_node == 3; ++k)
          n_of_node = unknowns[k].is_rotation ? 5 : 3;
        for (std::uint32_t node = 0; node < unknowns.n_nodes(); ++node)
          {
            const auto [first, end_of_displacements] = unknowns.of(node, false);
            const std::size_t end                    = unknowns.of(node, true).second;
            for (std::size_t k = first; k < end; ++k)
              of.push_back(n + static_cast<int>(k < end_of_displacements ? k - first : 3 + k - end_of_displacements));
            n += end > first ? n_of_node : 0;
          }
      }
    };

    std::vector<double> find_scaling(const SparseRows &matrix)
    {
      std::vector<double> result;
      for (std::uint32_t k = 0; k < matrix.size(); ++k)
        {
          const double stiffness = std::abs(matrix.find(k, k));
          if (!(stiffness > 0. && std::isfinite(stiffness)))
            throw NumericalFailure("Static solve: the tangent is singular, a node has no stiffness. Is every part of "
                                   "the mesh joined to a constrained part?");
          result.push_back(1. / std::sqrt(stiffness));
        }
      return result;
    }

    Teuchos::ParameterList find_choices(const int n_of_node, double *rigid_motions)
    {
      Teuchos::ParameterList choices;
      ML_Epetra::SetDefaults("SA", choices);
      choices.set("ML output", 0);
      choices.set("PDE equations", n_of_node);
      choices.set("prec type", "MGW");
      choices.set("smoother: type", "Chebyshev");
      choices.set("smoother: sweeps", 3); // the degree: 2 to 4 cost the same
      choices.set("null space: type", "pre-computed");
      choices.set("null space: dimension", n_rigid_motions);
      choices.set("null space: vectors", rigid_motions);
      choices.set("null space: add default vectors", false);
      return choices;
    }
  } // namespace

  struct Multigrid::Trilinos
  {
    Epetra_MpiComm                                       comm{MPI_COMM_SELF};
    Places                                               places;
    Epetra_Map                                           map;
    std::unique_ptr<Epetra_CrsMatrix>                    matrix;
    std::vector<double>                                  rigid_motions; // ML keeps a pointer
    std::unique_ptr<ML_Epetra::MultiLevelPreconditioner> cycle;
    mutable std::vector<double>                          in, out; // [places.n]

    explicit Trilinos(const FreeUnknowns &unknowns)
      : places(unknowns), map(places.n, 0, comm), in(places.n, 0.), out(in)
    {
    }

    void fill(const SparseRows &rows, const std::vector<double> &scaling)
    {
      std::vector<int> lengths(places.n, 1);
      for (std::size_t r = 0; r < rows.size(); ++r)
        lengths[places.of[r]] = static_cast<int>(rows.n_not_zero(r));
      matrix = std::make_unique<Epetra_CrsMatrix>(Copy, map, map, lengths.data(), true);
      std::vector<double> values;
      std::vector<int>    columns;
      std::vector<bool>   is_there(places.n, false);
      for (std::size_t r = 0; r < rows.size(); ++r)
        {
          values.clear();
          columns.clear();
          for (std::size_t e = rows.begin[r]; e < rows.begin[r + 1]; ++e)
            if (rows.value[e] != 0.)
              {
                values.push_back(rows.value[e] * scaling[r] * scaling[rows.column[e]]);
                columns.push_back(places.of[rows.column[e]]);
              }
          is_there[places.of[r]] = true;
          matrix->InsertGlobalValues(places.of[r], static_cast<int>(values.size()), values.data(), columns.data());
        }
      constexpr double one = 1.;
      for (int k = 0; k < places.n; ++k)
        if (!is_there[k])
          matrix->InsertGlobalValues(k, 1, &one, &k);
      matrix->FillComplete();
      matrix->OptimizeStorage();
    }

    void build(const std::vector<std::vector<double>> &motions, const std::vector<double> &scaling)
    {
      rigid_motions.assign(static_cast<std::size_t>(n_rigid_motions) * places.n, 0.);
      for (std::size_t m = 0; m < motions.size(); ++m)
        for (std::size_t k = 0; k < scaling.size(); ++k)
          rigid_motions[m * places.n + places.of[k]] = motions[m][k] / scaling[k];
      ML_set_random_seed(seed);
      const QuietErrors quietly;
      cycle = std::make_unique<ML_Epetra::MultiLevelPreconditioner>(
        *matrix, find_choices(places.n_of_node, rigid_motions.data()), true);
      if (!cycle->IsPreconditionerComputed())
        throw NumericalFailure("Static solve: ML could not build its levels. Set Blade/Spin/Linear solver to direct.");
    }

    template <class Operation>
    void apply(const double *x, double *result, const Operation &operation) const
    {
      for (std::size_t k = 0; k < places.of.size(); ++k)
        in[places.of[k]] = x[k];
      const Epetra_Vector from(View, map, in.data());
      Epetra_Vector       to(View, map, out.data());
      operation(from, to);
      for (std::size_t k = 0; k < places.of.size(); ++k)
        result[k] = out[places.of[k]];
    }
  };

  Multigrid::Multigrid(SparseRows &&matrix, const FreeUnknowns &unknowns,
                       const std::vector<std::vector<double>> &rigid_motions)
    : scaling(find_scaling(matrix))
  {
    start_mpi();
    trilinos = std::make_unique<Trilinos>(unknowns);
    trilinos->fill(matrix, scaling);
    matrix = {}; // as large as the copy
    trilinos->build(rigid_motions, scaling);
  }

  Multigrid::Multigrid(Multigrid &&) noexcept = default;
  Multigrid::~Multigrid()                     = default;

  void Multigrid::multiply(const double *x, double *result) const
  {
    trilinos->apply(x, result, [&](const auto &from, auto &to) { trilinos->matrix->Multiply(false, from, to); });
  }

  void Multigrid::precondition(const double *right, double *result) const
  {
    trilinos->apply(right, result, [&](const auto &from, auto &to) { trilinos->cycle->ApplyInverse(from, to); });
  }
} // namespace birdstrike
