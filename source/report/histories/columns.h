#pragma once

#include <birdstrike/report/history.h>
#include <birdstrike/report/run_view.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace birdstrike
{
  struct HistoryColumn
  {
    Column                                 what;
    std::function<double(const RunView &)> value;
  };

  /// What history.csv holds of this run, in its order; nullptr: all that any run may have, names of the user as NAME.
  std::vector<HistoryColumn> history_columns(const RunView *run);

  /// What filtered.csv holds: the time and three components.
  const std::vector<Column> &filtered_columns();

  /// What results.h5 holds besides curves, by the name of the group. Throws std::logic_error if there is none.
  const Column &profile(const std::string &name);

  /// The axes of such groups by name.
  const Column &axis(const std::string &name);

  /// A user's name as part of a column's: what separates columns becomes an underscore.
  std::string column_name(std::string name);

  inline constexpr std::array<const char *, 3> axis_names{{"x", "y", "z"}};
} // namespace birdstrike
