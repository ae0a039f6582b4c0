#pragma once

#include <birdstrike/structure/modes.h>

#include <string>
#include <vector>

namespace birdstrike
{
  class ReportFolder;

  /// Modes of a blade at one speed of its hub.
  struct ModesAtSpeed
  {
    double         speed = 0.; ///< rad/s
    VibrationModes modes;
  };

  /// Which mode of each speed goes on from each of the first speed's: of those that are left the one that is most like
  /// it (modal assurance criterion), [n_speeds][n_modes]. Curves that cross keep their shapes.
  std::vector<std::vector<std::size_t>> follow_modes(const std::vector<ModesAtSpeed> &speeds);

  std::string describe_modes(const ModesAtSpeed &at); ///< a table

  /// modes.csv; of several speeds campbell.csv and campbell.svg with the engine orders that cross the modes.
  void write_modes(const ReportFolder &folder, const std::vector<ModesAtSpeed> &speeds);
} // namespace birdstrike
