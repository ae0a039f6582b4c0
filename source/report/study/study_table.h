#pragma once

#include "report/comparison/comparison_table.h"
#include "report/study/study_runs.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike
{
  /// What the points of a study came to: the values that were varied, every quantity that `compare` reports, the state.
  /// A row's values are by point, NaN where a point has none.
  class StudyTable
  {
  public:
    /// Reads the run folders of the points that are done, one after the other.
    StudyTable(const StudyPlan &plan, const std::vector<PointRun> &runs);

    const std::vector<ComparisonRow> &rows() const;

    /// The rows that a reader of many runs asks for first, of those that there are: peak and permanent deflection of
    /// the tip, moment and stress of the root, plastic work and strain, impulse, filtered force.
    std::vector<const ComparisonRow *> headline() const;

    std::string as_text() const; ///< the headline, a line a point, at most 60; below it what runs warn of
    std::string as_csv() const;  ///< one row a point, all digits, SI units

    /// A line for each code of warnings, with the points that have it and the sentence of the first.
    std::string warnings_as_text() const;

    /// varied/<entry>, quantities/<group>/<quantity>, still rising/<group>/<quantity> (1 where the value is no peak
    /// yet; of quantities where one is not), state/done, each [points along the first entry][along the second]
    /// ..., of pairs [points]. Throws std::runtime_error if the disk refuses.
    void write_hdf5(const std::filesystem::path &file) const;

  private:
    const StudyPlan             &plan;
    const std::vector<PointRun> &runs;
    std::vector<ComparisonRow>   all;
    std::vector<Warnings>        warned; ///< by point

    void add(std::size_t point, const std::vector<ComparisonRow> &rows);
  };

  /// Points with values in the table of an earlier study (its CSV) that a new one of these points lacks, by their
  /// folders. Values are compared as texts, as the names of the folders are.
  std::vector<std::string> find_lost_points(const std::filesystem::path &csv, const StudyPlan &plan,
                                            const std::vector<PointRun> &runs);

  /// Whether a row is an answer of the scene, and not its size, its cost or a measure of the computation's own errors.
  bool is_response(const ComparisonRow &row);

  /// Lines of cells, each column as wide as its widest cell, the last one ragged.
  std::string align(const std::vector<std::vector<std::string>> &cells);
} // namespace birdstrike
