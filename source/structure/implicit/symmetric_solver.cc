#include "structure/implicit/symmetric_solver.h"
#include "structure/implicit/mpi.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/numerical_failure.h>

#include <fmt/format.h>

#include <dmumps_c.h>
#include <mpi.h>

namespace birdstrike
{
  struct SymmetricSolver::Mumps
  {
    enum Job
    {
      begin     = -1,
      end       = -2,
      analyse   = 1,
      factorise = 2,
      solve     = 3
    };

    DMUMPS_STRUC_C         state{};
    std::vector<MUMPS_INT> row, column; ///< from 1, at and below the diagonal
    std::vector<double>    value;

    explicit Mumps(const SparseRows &matrix)
    {
      state.par          = 1; // this process works, too
      state.sym          = 2; // symmetric, of any sign
      state.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(MPI_COMM_SELF));
      run(begin);
      for (const int channel : {1, 2, 3, 4}) // it says nothing
        set(channel, channel == 4 ? 0 : -1);
      set(13, 1); // no ScaLAPACK at the root, whose negative pivots would not be counted
      fill(matrix);
    }
    ~Mumps()
    {
      run(end);
    }
    Mumps(const Mumps &)            = delete;
    Mumps &operator=(const Mumps &) = delete;

    /// The n-th control of the manual, which counts from 1; and what MUMPS answers.
    void set(const int n, const int to)
    {
      state.icntl[n - 1] = to;
    }
    int answer(const int n) const
    {
      return state.infog[n - 1];
    }
    void run(const Job job)
    {
      state.job = job;
      dmumps_c(&state);
    }

    /// Pivots off the diagonal fill in more than the analysis has seen: the room for it, in per cent, is doubled.
    void factorise_with_room()
    {
      constexpr int too_small_integers = -8, too_small_reals = -9, most = 640;
      run(factorise);
      for (int percent = 40; percent <= most && (answer(1) == too_small_integers || answer(1) == too_small_reals);
           percent *= 2)
        {
          set(14, percent);
          run(factorise);
        }
    }

    void fill(const SparseRows &matrix)
    {
      for (std::size_t r = 0; r < matrix.size(); ++r)
        for (std::size_t e = matrix.begin[r]; e < matrix.begin[r + 1] && matrix.column[e] <= r; ++e)
          {
            row.push_back(static_cast<MUMPS_INT>(r + 1));
            column.push_back(static_cast<MUMPS_INT>(matrix.column[e] + 1));
            value.push_back(matrix.value[e]);
          }
      state.n   = static_cast<MUMPS_INT>(matrix.size());
      state.nnz = static_cast<MUMPS_INT8>(value.size());
      state.irn = row.data();
      state.jcn = column.data();
      state.a   = value.data();
    }
  };

  SymmetricSolver::SymmetricSolver(const SparseRows &matrix)
  {
    start_mpi();
    mumps = std::make_unique<Mumps>(matrix);
    mumps->run(Mumps::analyse);
    if (mumps->answer(1) >= 0)
      {
        require_memory_of_factors(1e6 * mumps->answer(16), matrix.size());
        mumps->factorise_with_room();
      }
    if (mumps->answer(1) < 0)
      throw NumericalFailure(fmt::format("Static solve: the stiffness of the loaded blade is singular (MUMPS: {}, {}). "
                                         "Is every part of the mesh joined to a constrained part?",
                                         mumps->answer(1), mumps->answer(2)));
  }

  SymmetricSolver::~SymmetricSolver() = default;

  std::size_t SymmetricSolver::n_negative() const
  {
    return mumps->answer(12);
  }

  void SymmetricSolver::solve(const std::span<const double> right, double, std::vector<double> &result)
  {
    result.assign(right.begin(), right.end());
    mumps->state.rhs = result.data();
    mumps->run(Mumps::solve);
    if (mumps->answer(1) < 0)
      throw NumericalFailure("Static solve: the factorised stiffness could not be solved with.");
  }
} // namespace birdstrike
