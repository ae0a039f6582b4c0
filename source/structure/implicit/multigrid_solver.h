#pragma once

#include "structure/implicit/linear_solver.h"
#include "structure/implicit/multigrid.h"

namespace birdstrike
{
  /// GMRES (Saad & Schultz 1986), preconditioned from the right by multigrid: following loads, flow and steps that are
  /// not yet in equilibrium make tangents neither symmetric nor positive.
  class MultigridSolver final : public LinearSolver
  {
  public:
    explicit MultigridSolver(Multigrid &&multigrid) : multigrid(std::move(multigrid))
    {
    }

    void solve(std::span<const double> right, double tolerance, std::vector<double> &result) override;

  private:
    Multigrid multigrid;
  };
} // namespace birdstrike
