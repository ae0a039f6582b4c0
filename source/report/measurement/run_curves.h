#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike
{
  /// A curve that a run has left, in SI units.
  struct RunCurve
  {
    std::string         quantity; ///< as a reader shall see it
    std::string         unit;     ///< SI
    std::vector<double> x, y;
    bool                is_profile = false; ///< x is a place, m, and not a time, s
  };

  /// The curve of a quantity, in the words of report/measurement.h. Throws InputError for a folder that is no run's and
  /// for a quantity that this run has not.
  RunCurve read_run_curve(const std::filesystem::path &run, const std::string &quantity);
} // namespace birdstrike
