#pragma once

#include <string>

namespace birdstrike
{
  struct RunView;
  struct Summary;

  /// What a run came to, as a table for the terminal.
  std::string closing_report(const RunView &run, const Summary &summary);
} // namespace birdstrike
