#include "report/measurement/measured_curve.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/io/units.h>
#include <birdstrike/report/text.h>

#include <fmt/format.h>
#include <spdlog/logger.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <set>
#include <vector>

namespace birdstrike
{
  namespace
  {
    /// A measured column without a unit is taken for SI; strains and counts of a run are numbers.
    bool is_of_one_dimension(const std::string &measured, const std::string &of_run)
    {
      const auto of_column = parse_column_unit(measured);
      return measured.empty() || !of_column || of_column->dimension == parse_unit(of_run).value_or(Unit{}).dimension;
    }

    double read_offset(const std::string &text)
    {
      if (text.empty())
        return 0.;
      char        *end   = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      const auto   unit  = parse_unit(*end == '\0' ? "s" : std::string(end));
      if (end == text.c_str() || !unit || unit->dimension != parse_unit("s")->dimension)
        throw InputError("--time-offset '" + text +
                         "' is no time: give a number of seconds, or one with its unit, '0.35 ms'.");
      return unit->to_si(value);
    }

    const TableColumn &find_abscissa(const DataTable &table, const std::string &given)
    {
      static const std::set<std::string> times{"time", "t"};
      if (!given.empty())
        return table.column(given);
      for (const std::string &each : table.names())
        {
          std::string name = each;
          std::ranges::transform(name, name.begin(), [](const unsigned char c) { return std::tolower(c); });
          if (times.contains(name))
            return table.column(each);
        }
      return table.column(table.names().front());
    }

    /// Of the rows in which both have a number; `rows`: their places in the table.
    Curve join(const DataTable &table, const TableColumn &x, const TableColumn &y, std::vector<std::size_t> &rows)
    {
      Curve curve;
      for (std::size_t k = 0; k < x.values.size(); ++k)
        if (!std::isnan(x.values[k]) && !std::isnan(y.values[k]))
          {
            curve.x.push_back(x.values[k]);
            curve.y.push_back(y.values[k]);
            rows.push_back(k);
          }
      if (const std::size_t n_empty = x.values.size() - curve.x.size(); n_empty > 0)
        log().info("{}: {} of {} rows have no '{}' or no '{}' and are passed over.", table.file().string(), n_empty,
                   x.values.size(), x.name, y.name);
      return curve;
    }

    void require_rising(const DataTable &table, const TableColumn &x, const Curve &curve,
                        const std::vector<std::size_t> &rows, const bool is_profile)
    {
      const auto found = std::ranges::adjacent_find(curve.x, std::greater_equal<>());
      if (found == curve.x.end())
        return;
      const auto        k    = static_cast<std::size_t>(found - curve.x.begin());
      const std::string unit = is_profile ? "m" : "s";
      throw InputError(fmt::format(
        "{}, line {}: '{}' does not rise: {} follows {} of line {}.\n{}", table.file().string(),
        table.line_of_row(rows[k + 1]), x.name, format_quantity(x.values[rows[k + 1]], unit),
        format_quantity(x.values[rows[k]], unit), table.line_of_row(rows[k]),
        x.values[rows[k + 1]] == x.values[rows[k]]
          ? "Keep one row of each " + std::string(is_profile ? "place" : "time") + ", or write it with more digits."
          : "It is no " + std::string(is_profile ? "place" : "time") + ": --time-column names another column."));
    }

    /// A bracket that is part of the name may have been meant as a unit.
    void warn_of_bracket(const TableColumn &column)
    {
      if (column.unit.empty() && column.name.ends_with(')'))
        log().warn("Column '{}' has no unit that is known: its values are taken as SI. Write it '[unit]'.",
                   column.name);
    }
  } // namespace

  Curve read_measured(const DataTable &table, const MeasurementRequest &request, const std::string &column,
                      const RunCurve &of_run)
  {
    const TableColumn &x = find_abscissa(table, request.time_column), &y = table.column(column);
    if (!is_of_one_dimension(x.unit, of_run.is_profile ? "m" : "s"))
      throw InputError("Column '" + x.name + "' of " + table.file().string() + " is in " + x.unit + ": " +
                       of_run.quantity + " is over " + (of_run.is_profile ? "places, m." : "times, s.") +
                       "\n--time-column names another column.");
    if (!is_of_one_dimension(y.unit, of_run.unit))
      throw InputError("Column '" + y.name + "' of " + table.file().string() + " is in " + y.unit + ", " +
                       of_run.quantity + " in " + of_run.unit + ": they cannot be compared.");
    warn_of_bracket(x);
    warn_of_bracket(y);
    std::vector<std::size_t> rows;
    Curve                    curve  = join(table, x, y, rows);
    const double             offset = of_run.is_profile ? 0. : read_offset(request.time_offset);
    for (double &t : curve.x)
      t += offset;
    if (curve.x.empty())
      throw InputError("Column '" + y.name + "' of " + table.file().string() + " holds no number.");
    require_rising(table, x, curve, rows, of_run.is_profile);
    return curve;
  }
} // namespace birdstrike
