#pragma once

#include "structure/implicit/linear_solver.h"

namespace birdstrike
{
  /// A factorised sparse matrix, by Trilinos: Amesos' MUMPS (Amestoy et al. 2001), or its KLU where that is not there.
  class DirectSolver final : public LinearSolver
  {
  public:
    /// @throws NumericalFailure for a singular matrix.
    explicit DirectSolver(const SparseRows &matrix);
    ~DirectSolver() override;

    void solve(std::span<const double> right, double tolerance, std::vector<double> &result) override;

  private:
    struct Trilinos;
    std::unique_ptr<Trilinos> trilinos;
  };
} // namespace birdstrike
