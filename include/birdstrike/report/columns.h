#pragma once

#include <birdstrike/report/run_view.h>

#include <string>

namespace birdstrike
{
  /// Every column of history.csv and of the other tables, and every other dataset of results.h5, with unit and meaning:
  /// those of this run, or (nullptr) all that any run may have, names of the user as NAME. Columns that share unit and
  /// meaning, as components of a vector do, share a line.
  std::string describe_columns(const RunView *run);
} // namespace birdstrike
