#pragma once

#include "structure/implicit/linear_solver.h"

namespace birdstrike
{
  /// L D L^T of a sparse symmetric matrix, by MUMPS (Amestoy et al. 2001), which Amesos asks for unsymmetric factors
  /// only. Of entries above the diagonal those below are taken.
  class SymmetricSolver final : public LinearSolver
  {
  public:
    /// @throws NumericalFailure for a singular matrix, InputError where the factors do not fit into memory.
    explicit SymmetricSolver(const SparseRows &matrix);
    ~SymmetricSolver() override;

    /// Negative pivots: as many as the matrix has negative eigenvalues (Sylvester's law of inertia).
    std::size_t n_negative() const;

    void solve(std::span<const double> right, double tolerance, std::vector<double> &result) override;

  private:
    struct Mumps;
    std::unique_ptr<Mumps> mumps;
  };
} // namespace birdstrike
