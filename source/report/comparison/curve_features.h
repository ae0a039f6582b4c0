#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace birdstrike
{
  struct TurningPoint
  {
    std::size_t index;
    bool        is_maximum;
  };

  /// Alternating maxima and minima of a curve, those kept that stand out by more than `threshold` (in the curve's unit)
  /// from both neighbours: the peak and valley filter of cycle counting (ASTM E1049). Neither end is one.
  std::vector<TurningPoint> find_turning_points(std::span<const double> values, double threshold);

  struct MeanOverPeriod
  {
    double mean   = 0.; ///< in the curve's unit
    double begin  = 0.; ///< s
    double period = 0.; ///< s
  };

  /// Mean (trapezoidal rule) over the last whole period of a free vibration: between the last two maxima or the last
  /// two minima, whichever end later, from the largest absolute value on. For a linear vibration about a deflection
  /// that stays this is that deflection; its error is the amplitude's decay in a period. Ripples of less than a quarter
  /// of the range after the peak are not taken for periods. Nothing if the curve holds no whole period after its peak.
  std::optional<MeanOverPeriod> compute_mean_over_last_period(std::span<const double> times,
                                                              std::span<const double> values);
} // namespace birdstrike
