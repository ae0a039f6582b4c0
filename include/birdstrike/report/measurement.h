#pragma once

#include <string>
#include <vector>

namespace birdstrike
{
  /// What the command line says about a measurement that runs are held against.
  struct MeasurementRequest
  {
    std::vector<std::string> runs;        ///< folders of runs that are there
    std::vector<std::string> of_file;     ///< the measurement's table, then pairs "column: quantity"
    std::string              time_column; ///< empty: the one called time or t, else the first
    std::string              time_offset; ///< "0.35 ms", added to the measurement's times; empty: none
    std::string              output = "runs/measured";
  };

  /// The last parts of these paths, of each so many that no two are alike.
  std::vector<std::string> shortest_names(const std::vector<std::string> &folders);

  /// Rates what runs have left against a measurement, quantity by quantity: ratio and times of the peaks, Sprague's and
  /// Geers' figures, the rating of ISO/TS 18571 (source/report/measurement/curve_metrics.h), on the screen and in
  /// ratings.csv; measurement.csv has the curves, drawn one upon the other in measurement.svg. Curves are compared
  /// where both have values, at a thousand equal steps, linear between rows.
  ///
  /// A quantity is a column of history.csv, of another table of the run ("gauges/root.strain",
  /// "filtered/contact_force"), the name that columns with endings _x, _y, _z share, which is their norm, or a word:
  /// tip, root moment, root stress, impulse, force (filtered, norm); or a profile, whose table has places instead of
  /// times: root profile, rear root profile, mid-chord profile. A minus before it turns its sign. Throws InputError for
  /// what the user must change.
  void compare_with_measurement(const MeasurementRequest &request);
} // namespace birdstrike
