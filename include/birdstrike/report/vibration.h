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

  constexpr std::size_t no_mode = static_cast<std::size_t>(-1);

  /// Which mode of each speed goes on from each of the first speed's first n, [n_speeds][n]: the pairs of two speeds
  /// that are most alike (modal assurance criterion) first. Curves that cross keep their shapes. One to which none of
  /// the next speed is alike (criterion below a half) ends there: no_mode from then on.
  std::vector<std::vector<std::size_t>> follow_modes(const std::vector<ModesAtSpeed> &speeds, std::size_t n);

  /// How many more are found at each of several speeds for n to be followed: others cross them from above.
  std::size_t n_spare_modes(std::size_t n, std::size_t n_speeds);

  std::string describe_modes(const ModesAtSpeed &at, std::size_t n); ///< a table of the first n

  /// modes.csv; of several speeds campbell.csv and campbell.svg with the engine orders that cross the n modes. Returns
  /// a sentence for each that ends before the last speed.
  std::vector<std::string> write_modes(const ReportFolder &folder, const std::vector<ModesAtSpeed> &speeds,
                                       std::size_t n);
} // namespace birdstrike
