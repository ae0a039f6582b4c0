#pragma once

#include <string>
#include <vector>

namespace birdstrike
{
  /// Entries that say how often and where a run tells, not what it computes or leaves: two cases that differ in them
  /// alone are one, and a run that goes on may change them. And `more`.
  std::vector<std::string> output_entries_and(const std::vector<std::string> &more);
} // namespace birdstrike
