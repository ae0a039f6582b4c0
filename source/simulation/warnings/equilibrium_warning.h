#pragma once

#include <birdstrike/core/warning.h>
#include <birdstrike/structure/reports.h>

#include <string>

namespace birdstrike
{
  /// "stable", or "unstable in 2 directions".
  std::string describe_stability(const StaticReport &report);

  /// Of an equilibrium that the blade cannot stay in. `turns`: with its hub, so that Coriolis' forces act.
  void check_equilibrium(const StaticReport &report, bool turns, Warnings &warnings);
} // namespace birdstrike
