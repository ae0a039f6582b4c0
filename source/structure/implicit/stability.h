#pragma once

#include "structure/implicit/equilibrium.h"
#include <birdstrike/structure/choices.h>

#include <optional>

namespace birdstrike
{
  /// In how many directions an equilibrium is unstable: negative eigenvalues of the symmetric part of its tangent. By
  /// the inertia of its factors (Sylvester), or, where multigrid is taken, by its lowest mode: then 1 stands for one
  /// or more. Nothing where that was not found, or where loads follow the surface: a tangent that is not symmetric may
  /// be stable though its symmetric part is not positive (Bolotin 1963).
  ///
  /// `step` leads to it from the accepted state: a metal that yields on the way has the tangent of its flow (Shanley
  /// 1947, J. Aeronaut. Sci. 14, 261).
  std::optional<std::size_t> count_unstable(Equilibrium &equilibrium, std::span<const double> step,
                                            LinearSolverChoice linear_solver);
} // namespace birdstrike
