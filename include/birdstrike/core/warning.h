#pragma once

#include <string>
#include <vector>

namespace birdstrike
{
  /// What a user should know before trusting a figure: the run goes on, or has gone, as asked. All warnings of a run
  /// stand on the screen, at its end once more, and in summary.json.
  struct Warning
  {
    std::string code; ///< stable, for scripts: "unit/bird_density"
    std::string text; ///< one sentence or two, with the value and the entry
  };

  using Warnings = std::vector<Warning>;
} // namespace birdstrike
