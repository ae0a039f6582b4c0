#pragma once

#include "structure/implicit/stencil.h"

#include <memory>
#include <span>
#include <vector>

namespace birdstrike
{
  /// A factorised sparse matrix, by Trilinos: Amesos' MUMPS (Amestoy et al. 2001), or its KLU where that is not there.
  class DirectSolver
  {
  public:
    /// @throws NumericalFailure for a singular matrix.
    explicit DirectSolver(const SparseRows &matrix);
    ~DirectSolver();

    void solve(std::span<const double> right, std::vector<double> &result);

  private:
    struct Trilinos;
    std::unique_ptr<Trilinos> trilinos;
  };
} // namespace birdstrike
