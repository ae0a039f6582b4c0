#include "report/study/study_table.h"
#include "report/comparison/case_run.h"
#include "report/comparison/warning_digest.h"
#include "report/comparison/written_table.h"
#include "report/histories/history_hdf5.h"
#include <birdstrike/report/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace birdstrike
{
  namespace
  {
    constexpr double absent = std::numeric_limits<double>::quiet_NaN();

    constexpr std::size_t most_lines = 60; ///< on the screen

    /// Group and quantity, in the words of quantities.cc.
    constexpr std::array<std::pair<const char *, const char *>, 8> headlines{{{"Tip", "peak (mid-chord)"},
                                                                              {"Tip", "permanent deflection"},
                                                                              {"Root", "peak bending moment"},
                                                                              {"Root", "peak normal stress"},
                                                                              {"Plasticity", "plastic work"},
                                                                              {"Plasticity", "peak plastic strain"},
                                                                              {"Contact", "impulse (norm)"},
                                                                              {"Contact", "peak force, filtered"}}};

    bool is_same(const ComparisonRow &a, const ComparisonRow &b)
    {
      return a.group == b.group && a.quantity == b.quantity;
    }

    std::string show(const double value, const std::string &unit)
    {
      return std::isnan(value) ? "-" : format_value(value, unit);
    }

    constexpr auto behind_quantities = "still rising"; ///< heading of the column there

    constexpr auto of_rising = "+: still rising at the end of the run, no peak yet, or still pushed by the bird.\n";
  } // namespace

  std::string align(const std::vector<std::vector<std::string>> &cells)
  {
    std::vector<std::size_t> widths(cells[0].size());
    for (const auto &line : cells)
      for (std::size_t c = 0; c < line.size(); ++c)
        widths[c] = std::max(widths[c], line[c].size());
    std::string text;
    for (const auto &line : cells)
      {
        std::string shown;
        for (std::size_t c = 0; c < line.size(); ++c)
          shown += c + 1 < line.size() ? fmt::format("{:>{}}  ", line[c], widths[c]) : line[c];
        text += shown.substr(0, shown.find_last_not_of(' ') + 1) + '\n';
      }
    return text;
  }

  bool is_response(const ComparisonRow &row)
  {
    static const std::set<std::string> others{"Case", "Balance", "Cost"};
    return row.texts.empty() && !others.contains(row.group) && !row.quantity.starts_with("largest penetration");
  }

  namespace
  {
    std::string heading_of(const VariedEntry &each)
    {
      return each.entry + " [" + each.unit + "]";
    }

    /// Whether the table varies these entries and no other: behind them stand quantities, "Group: name".
    bool is_of(const WrittenTable &table, const StudyPlan &plan)
    {
      const auto &names = table.headings();
      for (std::size_t e = 0; e < plan.entries.size(); ++e)
        if (e + 1 >= names.size() || names[e + 1] != heading_of(plan.entries[e]))
          return false;
      const std::size_t next = plan.entries.size() + 1;
      return next < names.size() && (names[next].find(": ") != std::string::npos || names[next] == behind_quantities);
    }
  } // namespace

  std::vector<std::string> find_lost_points(const std::filesystem::path &csv, const StudyPlan &plan,
                                            const std::vector<PointRun> &runs)
  {
    const WrittenTable                 table(csv);
    std::set<std::vector<std::string>> points;
    for (const PointRun &run : runs)
      {
        std::vector<std::string> values;
        for (std::size_t e = 0; e < plan.entries.size(); ++e)
          values.push_back(plan.entries[e].values[run.point.at[e]]);
        points.insert(values);
      }
    std::vector<std::string> lost;
    for (std::size_t row = 0; row < table.n_rows(); ++row)
      {
        std::vector<std::string> values;
        for (std::size_t e = 0; e < plan.entries.size(); ++e)
          values.push_back(table.field(row, e + 1));
        if (table.field(row, "state") == "done" && !(is_of(table, plan) && points.contains(values)))
          lost.push_back(std::filesystem::path(table.field(row, "folder")).filename().string());
      }
    return lost;
  }

  StudyTable::StudyTable(const StudyPlan &plan, const std::vector<PointRun> &runs)
    : plan(plan), runs(runs), warned(runs.size())
  {
    for (std::size_t k = 0; k < runs.size(); ++k)
      if (runs[k].is_done) // one record at a time: a thousand histories would fill the memory
        {
          const ComparisonTable of_point({{runs[k].point.name, read_record(runs[k].folder)}});
          add(k, of_point.rows());
          warned[k] = of_point.warnings()[0];
        }
  }

  void StudyTable::add(const std::size_t point, const std::vector<ComparisonRow> &rows)
  {
    auto behind = all.begin(); // a row that no point before had comes where it stands among its neighbours
    for (const ComparisonRow &row : rows)
      {
        auto place = std::ranges::find_if(all, [&](const ComparisonRow &each) { return is_same(each, row); });
        if (place == all.end())
          {
            ComparisonRow whole = {row.group, row.quantity, row.unit, {}, {}};
            if (row.values.empty())
              whole.texts.resize(runs.size());
            else
              {
                whole.values.assign(runs.size(), absent);
                whole.rises.assign(runs.size(), false);
              }
            place = all.insert(behind, std::move(whole));
          }
        if (row.values.empty())
          place->texts[point] = row.texts[0];
        else
          {
            place->values[point] = row.values[0];
            place->rises[point]  = row.is_rising(0);
          }
        behind = place + 1;
      }
  }

  const std::vector<ComparisonRow> &StudyTable::rows() const
  {
    return all;
  }

  std::vector<const ComparisonRow *> StudyTable::headline() const
  {
    std::vector<const ComparisonRow *> found;
    for (const auto &[group, quantity] : headlines)
      for (const ComparisonRow &row : all)
        if (row.group == group && row.quantity == quantity)
          found.push_back(&row);
    return found;
  }

  std::string StudyTable::as_text() const
  {
    const auto                            shown = headline();
    std::vector<std::vector<std::string>> cells(1);
    for (std::size_t e = 0; e < plan.entries.size(); ++e)
      cells[0].push_back(plan.short_name(e));
    for (const ComparisonRow *row : shown)
      cells[0].push_back(row->group + ": " + row->quantity);
    cells[0].emplace_back("state");
    bool is_any_rising = false;
    for (std::size_t k = 0; k < std::min(runs.size(), most_lines); ++k)
      {
        std::vector<std::string> line;
        for (std::size_t e = 0; e < plan.entries.size(); ++e)
          line.push_back(plan.entries[e].values[runs[k].point.at[e]]);
        for (const ComparisonRow *row : shown)
          {
            line.push_back(show(row->values[k], row->unit) + (row->is_rising(k) ? "+" : ""));
            is_any_rising = is_any_rising || row->is_rising(k);
          }
        line.push_back(runs[k].state);
        cells.push_back(std::move(line));
      }
    return align(cells) + (is_any_rising ? of_rising : "") +
           (runs.size() > most_lines ? fmt::format("... and {} more in study.csv\n", runs.size() - most_lines) : "") +
           warnings_as_text();
  }

  std::string StudyTable::warnings_as_text() const
  {
    std::vector<WarnedRun> points;
    for (std::size_t k = 0; k < runs.size(); ++k)
      if (runs[k].is_done)
        points.push_back({runs[k].point.name, warned[k]});
    std::string text;
    for (const std::string &line : digest_warnings(points))
      text += line + '\n';
    return text;
  }

  std::string StudyTable::as_csv() const
  {
    std::string text = "point";
    for (const VariedEntry &each : plan.entries)
      text += "," + csv_field(heading_of(each));
    for (const ComparisonRow &row : all)
      text += "," + csv_heading(row);
    text += std::string(",") + behind_quantities + ",warnings,state,folder\n";
    for (std::size_t k = 0; k < runs.size(); ++k)
      {
        text += std::to_string(k + 1);
        for (std::size_t e = 0; e < plan.entries.size(); ++e)
          text += "," + csv_field(plan.entries[e].values[runs[k].point.at[e]]);
        for (const ComparisonRow &row : all)
          text += "," + csv_cell(row, k);
        for (const std::string &last :
             {list_rising(all, k), list_codes(warned[k]), runs[k].state, runs[k].folder.string()})
          text += "," + csv_field(last);
        text += "\n";
      }
    return text;
  }

  void StudyTable::write_hdf5(const std::filesystem::path &file) const
  {
    ResultsFile                    results(file);
    const std::vector<std::size_t> shape = plan.shape();
    for (std::size_t e = 0; e < plan.entries.size(); ++e)
      {
        const VariedEntry  &entry   = plan.entries[e];
        std::string         meaning = "Value of the entry";
        std::vector<double> values;
        for (const PointRun &run : runs)
          values.push_back(entry.numbers.empty() ? static_cast<double>(run.point.at[e])
                                                 : entry.numbers[run.point.at[e]]);
        if (entry.numbers.empty())
          for (std::size_t v = 0; v < entry.values.size(); ++v)
            meaning += (v == 0 ? ", by number: " : "; ") + std::to_string(v) + " " + entry.values[v];
        results.write("varied", entry.entry, {entry.entry, entry.unit, meaning}, shape, values);
      }
    for (const ComparisonRow &row : all)
      if (!row.values.empty())
        results.write("quantities/" + row.group, row.quantity,
                      {row.quantity, row.unit, row.group + ": " + row.quantity}, shape, row.values);
    for (const ComparisonRow &row : all)
      if (row.is_any_rising())
        results.write("still rising/" + row.group, row.quantity,
                      {row.quantity, "-", "1: still rises at the end of the run, no peak yet"}, shape,
                      {row.rises.begin(), row.rises.end()});
    std::vector<double> are_done;
    for (const PointRun &run : runs)
      are_done.push_back(run.is_done ? 1. : 0.);
    results.write("state", "done", {"done", "-", "1: complete; 0: not, study.csv says why"}, shape, are_done);
    results.close();
  }
} // namespace birdstrike
