#include "report/comparison/comparison_table.h"
#include "report/comparison/warning_digest.h"
#include <birdstrike/report/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

/// The three ways to write a comparison down.
namespace birdstrike
{
  namespace
  {
    constexpr const char *nothing = "-";

    std::string show(const ComparisonRow &row, const std::size_t run)
    {
      if (row.values.empty())
        return row.texts[run].empty() ? nothing : row.texts[run];
      const double value = row.values[run];
      return std::isnan(value) ? nothing : format_value(value, row.unit) + (row.is_rising(run) ? "+" : "");
    }

    std::string show_difference(const ComparisonRow &row, const std::size_t run)
    {
      const double share = row.values.empty() ? NAN : row.difference(run);
      if (std::isnan(share))
        return nothing;
      if (share == 0.)
        return "0 %";
      return std::abs(share) < 10. ? fmt::format("{:+.3g} %", 100. * share) : fmt::format("{:+.0f} %", 100. * share);
    }

    /// A table of cells: one line of headings, then one line a run.
    using Cells = std::vector<std::vector<std::string>>;

    /// One table a group: a run a line, a quantity a column, its difference to the first run behind it.
    std::vector<Cells> make_groups(const std::vector<std::string> &names, const std::vector<ComparisonRow> &rows)
    {
      std::vector<Cells> groups;
      for (const ComparisonRow &row : rows)
        {
          if (groups.empty() || groups.back()[0][0] != row.group)
            {
              groups.push_back({{row.group}});
              for (const std::string &name : names)
                groups.back().push_back({name});
            }
          Cells     &cells           = groups.back();
          const bool has_differences = !row.values.empty() && names.size() > 1;
          cells[0].push_back(row.quantity);
          if (has_differences)
            cells[0].emplace_back("");
          for (std::size_t run = 0; run < names.size(); ++run)
            {
              cells[run + 1].push_back(show(row, run));
              if (has_differences)
                cells[run + 1].push_back(run == 0 ? "" : show_difference(row, run));
            }
        }
      return groups;
    }

    std::string csv_number(const double value)
    {
      return std::isnan(value) ? "" : fmt::format("{}", value);
    }
  } // namespace

  std::string csv_field(const std::string &text)
  {
    if (text.find_first_of(",\"\n") == std::string::npos)
      return text;
    std::string quoted = "\"";
    for (const char letter : text)
      quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + "\"";
  }

  std::string csv_heading(const ComparisonRow &row)
  {
    // counts and shares are pure numbers; their own units only say how a reader wants them
    const bool        is_pure = row.unit == "count" || row.unit == "share";
    const std::string unit    = row.unit.empty() ? "" : " [" + (is_pure ? "-" : row.unit) + "]";
    return csv_field(row.group + ": " + row.quantity + unit);
  }

  std::string list_rising(const std::vector<ComparisonRow> &rows, const std::size_t run)
  {
    std::string names;
    for (const ComparisonRow &row : rows)
      if (row.is_rising(run))
        names += (names.empty() ? "" : "; ") + row.group + ": " + row.quantity;
    return names;
  }

  std::string csv_cell(const ComparisonRow &row, const std::size_t run)
  {
    return row.values.empty() ? csv_field(row.texts[run]) : csv_number(row.values[run]);
  }

  std::string ComparisonTable::as_text() const
  {
    const std::vector<Cells> groups = make_groups(names, all);
    std::size_t              first  = 0; // width of the runs' names
    for (const Cells &cells : groups)
      for (const auto &line : cells)
        first = std::max(first, line[0].size());
    std::string text;
    for (const Cells &cells : groups)
      {
        std::vector<std::size_t> widths(cells[0].size());
        for (const auto &line : cells)
          for (std::size_t c = 1; c < line.size(); ++c)
            widths[c] = std::max(widths[c], line[c].size());
        for (const auto &line : cells)
          {
            std::string shown = fmt::format("{:<{}}", line[0], first);
            for (std::size_t c = 1; c < line.size(); ++c)
              shown += fmt::format("  {:>{}}", line[c], widths[c]);
            text += shown.substr(0, shown.find_last_not_of(' ') + 1) + '\n';
          }
        text += '\n';
      }
    for (const std::string &note : remarks)
      text += note + '\n';
    return text;
  }

  std::string ComparisonTable::as_markdown() const
  {
    std::string text;
    const auto  add_line = [&](const std::vector<std::string> &line) {
      for (std::string cell : line)
        {
          for (std::size_t at = 0; (at = cell.find('|', at)) != std::string::npos; at += 2)
            cell.insert(at, "\\");
          text += "| " + cell + " ";
        }
      text += "|\n";
    };
    for (const Cells &cells : make_groups(names, all))
      {
        add_line(cells[0]);
        text += "|---|";
        for (std::size_t c = 1; c < cells[0].size(); ++c)
          text += "---:|";
        text += '\n';
        for (std::size_t k = 1; k < cells.size(); ++k)
          add_line(cells[k]);
        text += '\n';
      }
    if (std::ranges::any_of(warned, [](const Warnings &each) { return !each.empty(); }))
      {
        text += "| | warnings |\n|---|---|\n";
        for (std::size_t run = 0; run < names.size(); ++run)
          add_line({names[run], warned[run].empty() ? nothing : list_codes(warned[run])});
        text += '\n';
      }
    for (const std::string &note : remarks)
      text += note + "\n\n";
    return text;
  }

  std::string ComparisonTable::as_csv() const
  {
    std::string text = "case";
    for (const ComparisonRow &row : all)
      text += "," + csv_heading(row);
    for (const ComparisonRow &row : all)
      if (!row.values.empty())
        text += "," + csv_field("difference of " + row.group + ": " + row.quantity + " [%]");
    text += ",still rising,warnings\n";
    for (std::size_t run = 0; run < names.size(); ++run)
      {
        text += csv_field(names[run]);
        for (const ComparisonRow &row : all)
          text += "," + csv_cell(row, run);
        for (const ComparisonRow &row : all)
          if (!row.values.empty())
            text += "," + csv_number(100. * row.difference(run));
        text += "," + csv_field(list_rising(all, run)) + "," + csv_field(list_codes(warned[run])) + '\n';
      }
    return text;
  }
} // namespace birdstrike
