#include "report/comparison/comparison_table.h"
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
      return std::isnan(value) ? nothing : format_value(value, row.unit);
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

    /// Every cell as text: a line of headings, then one line a row.
    std::vector<std::vector<std::string>> make_cells(const std::vector<std::string>   &names,
                                                     const std::vector<ComparisonRow> &rows)
    {
      std::vector<std::vector<std::string>> cells{{""}};
      for (std::size_t run = 0; run < names.size(); ++run)
        {
          cells[0].push_back(names[run]);
          if (run > 0)
            cells[0].push_back("difference");
        }
      for (const ComparisonRow &row : rows)
        {
          std::vector<std::string> line{row.group + ": " + row.quantity};
          for (std::size_t run = 0; run < names.size(); ++run)
            {
              line.push_back(show(row, run));
              if (run > 0)
                line.push_back(show_difference(row, run));
            }
          cells.push_back(std::move(line));
        }
      return cells;
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

  std::string ComparisonTable::as_text() const
  {
    const auto               cells = make_cells(names, all);
    std::vector<std::size_t> widths(cells[0].size());
    for (const auto &line : cells)
      for (std::size_t c = 0; c < line.size(); ++c)
        widths[c] = std::max(widths[c], line[c].size());
    std::string text;
    for (const auto &line : cells)
      {
        text += fmt::format("{:<{}}", line[0], widths[0]);
        for (std::size_t c = 1; c < line.size(); ++c)
          text += fmt::format("  {:>{}}", line[c], widths[c]);
        text += '\n';
      }
    for (const std::string &note : remarks)
      text += note + '\n';
    return text;
  }

  std::string ComparisonTable::as_markdown() const
  {
    const auto  cells = make_cells(names, all);
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
    add_line(cells[0]);
    text += "|---|";
    for (std::size_t c = 1; c < cells[0].size(); ++c)
      text += "---:|";
    text += '\n';
    for (std::size_t k = 1; k < cells.size(); ++k)
      add_line(cells[k]);
    for (const std::string &note : remarks)
      text += "\n" + note + "\n";
    return text;
  }

  std::string ComparisonTable::as_csv() const
  {
    std::string text = "group,quantity,unit";
    for (const std::string &name : names)
      text += "," + csv_field(name);
    for (std::size_t run = 1; run < names.size(); ++run)
      text += "," + csv_field("difference of " + names[run] + " [%]");
    text += '\n';
    for (const ComparisonRow &row : all)
      {
        // counts and shares are pure numbers; their own units only say how a reader wants them
        const bool is_pure = row.unit == "count" || row.unit == "share";
        text += csv_field(row.group) + "," + csv_field(row.quantity) + "," + (is_pure ? "-" : row.unit);
        for (std::size_t run = 0; run < names.size(); ++run)
          text += "," + (row.values.empty() ? csv_field(row.texts[run]) : csv_number(row.values[run]));
        for (std::size_t run = 1; run < names.size(); ++run)
          text += "," + (row.values.empty() ? "" : csv_number(100. * row.difference(run)));
        text += '\n';
      }
    return text;
  }
} // namespace birdstrike
