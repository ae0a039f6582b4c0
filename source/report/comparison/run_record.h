#pragma once

#include <birdstrike/report/summary.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace birdstrike
{
  /// What a run has left in its folder, read back: summary.json, history.csv, results.h5. SI units, names and keys are
  /// those of source/report/quantities.h. A run that was lost has curves up to its end and no summary.
  ///
  /// What is not there is absent (NaN, empty), never an error: runs differ in their parts. Raises std::runtime_error
  /// for a file that is there and cannot be read. Neither writes nor judges.
  class RunRecord
  {
  public:
    explicit RunRecord(const std::filesystem::path &folder);

    /// Of a run whose files cannot be read: it is not complete, and its state says why.
    static RunRecord unreadable(const std::filesystem::path &folder, const std::string &why);

    const std::filesystem::path &folder() const;

    /// Whether the run came to its end: summary.json is written last.
    bool is_complete() const;

    /// What the folder's marker says: "done", "failed: <first line of the message>", "running"; empty without one.
    const std::string &state() const;

    /// summary.json; without any key where there is none.
    const Summary &summary() const;

    /// A column of history.csv [rows]; empty if it is absent.
    const std::vector<double> &column(const std::string &name) const;

    /// A dataset of results.h5 in row-major order, e.g. "root_normal_stress_at_peak/chord"; empty if it is absent.
    std::vector<double> dataset(const std::string &name) const;

  private:
    RunRecord() = default;

    std::filesystem::path                      directory;
    std::string                                marker;
    bool                                       has_files = true;
    Summary                                    outcome;
    std::map<std::string, std::vector<double>> columns;

    void read_summary();
    void read_history();
  };
} // namespace birdstrike
