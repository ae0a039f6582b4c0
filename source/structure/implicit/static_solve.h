#pragma once

#include "structure/implicit/equilibrium.h"
#include <birdstrike/structure/choices.h>
#include <birdstrike/structure/reports.h>

namespace birdstrike
{
  /// Brings the blade to static equilibrium with its loads of t = 0 and the spin of its hub: load steps, in each
  /// Newton's method with the consistent tangent and a line search on the norm of the forces. A load step that does not
  /// converge is halved.
  ///
  /// @throws NumericalFailure, with the load factor reached, where no step converges: the blade buckles, flows
  /// unbounded or fails.
  StaticReport solve_static(Equilibrium &equilibrium, unsigned int n_load_steps, LinearSolverChoice linear_solver);
} // namespace birdstrike
