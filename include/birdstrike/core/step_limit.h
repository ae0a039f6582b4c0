#pragma once

#include <limits>
#include <string>

namespace birdstrike
{
  /// A part's vote on the time step: the largest stable step (s), why, and which entity says so.
  struct StepLimit
  {
    double      value = std::numeric_limits<double>::infinity();
    std::string reason; ///< e.g. "shell element, membrane wave"
    std::string where;  ///< e.g. "element 17 at (0.01, 0.02, 0)"
  };
} // namespace birdstrike
