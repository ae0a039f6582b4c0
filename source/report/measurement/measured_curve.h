#pragma once

#include "report/measurement/data_table.h"
#include "report/measurement/run_curves.h"
#include <birdstrike/report/measurement.h>

#include <string>
#include <vector>

namespace birdstrike
{
  struct Curve
  {
    std::vector<double> x, y; ///< x rises
  };

  /// A column over times, or over places where the run's curve is a profile, in SI units and moved by the time offset.
  /// Rows in which either has an empty cell are passed over, and their number is said. Throws InputError for units that
  /// cannot be compared with the run's and for times that do not rise.
  Curve read_measured(const DataTable &table, const MeasurementRequest &request, const std::string &column,
                      const RunCurve &of_run);
} // namespace birdstrike
