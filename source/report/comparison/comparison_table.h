#pragma once

#include "report/comparison/run_record.h"

#include <functional>
#include <string>
#include <vector>

namespace birdstrike
{
  /// One of the runs that are compared.
  struct ComparedRun
  {
    std::string name;   ///< "frontal", "frontal solid"
    RunRecord   record; ///< complete, or of a run that was lost
  };

  /// One quantity of a comparison. Quantities have `values`, in SI units, NaN where a run has none; properties have
  /// `texts`.
  struct ComparisonRow
  {
    std::string              group;    ///< "Blade", "Cost"
    std::string              quantity; ///< "tip peak (mid-chord)"
    std::string              unit;     ///< "m", "-", "count", "B", "share"; empty for texts
    std::vector<double>      values;   ///< per run
    std::vector<std::string> texts;    ///< per run
    std::vector<bool> rises = {};      ///< per run: a peak (or its time) that may be none: at the end, or pushed still

    bool is_rising(std::size_t run) const;
    bool is_any_rising() const;

    /// (value - value of the first run) / |value of the first run|; NaN where one is absent or the first is zero.
    double difference(std::size_t run) const;
  };

  /// What runs came to, side by side: a line a run, and how much it differs from the first. Peaks are those of
  /// summary.json, taken at every step of the run and not at the rows of its history. Quantities that no
  /// run has are left out; of no runs all rows are there, without values. Writes no files.
  class ComparisonTable
  {
  public:
    explicit ComparisonTable(const std::vector<ComparedRun> &runs);

    const std::vector<ComparisonRow> &rows() const
    {
      return all;
    }

    /// What the rows cannot say: how a permanent deflection was taken, which runs were lost and why.
    const std::vector<std::string> &notes() const
    {
      return remarks;
    }

    /// Of each run, as its summary has them; none of a run that was lost.
    const std::vector<Warnings> &warnings() const
    {
      return warned;
    }

    std::string as_text() const;     ///< a table a group, aligned for a terminal, values with SI prefixes
    std::string as_markdown() const; ///< the same as tables of Markdown
    std::string
    as_csv() const; ///< one row a run, all digits, SI units; behind: differences in percent, codes of warnings

  private:
    std::vector<std::string>   names;
    std::vector<ComparisonRow> all;
    std::vector<std::string>   remarks;
    std::vector<Warnings>      warned;

    /// Quantities of summary.json, in the words and units of quantities.h.
    void add(const std::string &group, std::initializer_list<const char *> keys, const std::vector<ComparedRun> &runs);
    void add_texts(const std::string &group, const std::string &key, const std::vector<ComparedRun> &runs,
                   const std::string &of_lost = "");
    void add_computed(const std::string &group, const std::string &text, const std::string &unit,
                      const std::vector<ComparedRun> &runs, const std::function<double(const RunRecord &)> &value);
    void add_unreached_peaks(const std::vector<ComparedRun> &runs);
    void say_what_root_stress_is(const std::vector<ComparedRun> &runs);
    void say_what_filters_are(const std::vector<ComparedRun> &runs);
    void add_permanent_deflection(const std::vector<ComparedRun> &runs);
    void add_warnings(const std::vector<ComparedRun> &runs);
    void add_row(ComparisonRow row);
  };

  /// A field of a CSV file: quoted where it holds a comma, a quote or a line's end.
  std::string csv_field(const std::string &text);

  /// "Tip: peak [m]" and the value of a run, with all digits; empty where there is none.
  std::string csv_heading(const ComparisonRow &row);
  std::string csv_cell(const ComparisonRow &row, std::size_t run);

  /// "Tip: peak; Root: peak bending moment": what of a run still rises at its end and is no peak yet.
  std::string list_rising(const std::vector<ComparisonRow> &rows, std::size_t run);
} // namespace birdstrike
