#pragma once

#include <birdstrike/core/warning.h>
#include <birdstrike/structure/parameters.h>
#include <birdstrike/structure/reports.h>

#include <string>

namespace birdstrike
{
  /// "stable", or "unstable in 2 directions".
  std::string describe_stability(const StaticReport &report);

  /// Of an equilibrium that the blade cannot stay in. `turns`: with its hub, so that Coriolis' forces act.
  void check_equilibrium(const StaticReport &report, bool turns, Warnings &warnings);

  /// Loads that do not know the time are applied by a run at once and for good: warns where their static equilibrium is
  /// unstable. Finds it on a blade of its own, of up to 20 000 nodes; nothing for a blade on a hub that turns, which
  /// starts from its equilibrium.
  void check_constant_loads(const BladeParameters &parameters, std::size_t n_nodes, Warnings &warnings);
} // namespace birdstrike
