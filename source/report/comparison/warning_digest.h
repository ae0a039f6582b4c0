#pragma once

#include <birdstrike/core/warning.h>

#include <string>
#include <vector>

namespace birdstrike
{
  /// What one of several runs warns of.
  struct WarnedRun
  {
    std::string name; ///< "350", "'frontal'"
    Warnings    warnings;
  };

  /// Each code once, in their order, with blanks between; empty of none.
  std::string list_codes(const Warnings &warnings);

  /// A line for each code that some of the runs have: the code, these runs, and what the first of them says. `runs` are
  /// all, those without warnings too.
  std::vector<std::string> digest_warnings(const std::vector<WarnedRun> &runs);
} // namespace birdstrike
