#include "report/comparison/curve_features.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    constexpr double ripple = 0.25; ///< of the range after the peak

    double integrate(const std::span<const double> times, const std::span<const double> values)
    {
      double sum = 0.;
      for (std::size_t k = 1; k < times.size(); ++k)
        sum += 0.5 * (values[k] + values[k - 1]) * (times[k] - times[k - 1]);
      return sum;
    }
  } // namespace

  std::vector<TurningPoint> find_turning_points(const std::span<const double> values, const double threshold)
  {
    std::vector<TurningPoint> points;
    std::size_t               highest = 0, lowest = 0; // since the last turning point
    int                       direction = 0;           // of the present branch; 0: not known yet
    for (std::size_t k = 1; k < values.size(); ++k)
      {
        if (values[k] > values[highest])
          highest = k;
        if (values[k] < values[lowest])
          lowest = k;
        if (direction >= 0 && values[highest] - values[k] > threshold)
          {
            if (direction > 0)
              points.push_back({highest, true});
            direction = -1;
            lowest    = k;
          }
        else if (direction <= 0 && values[k] - values[lowest] > threshold)
          {
            if (direction < 0)
              points.push_back({lowest, false});
            direction = 1;
            highest   = k;
          }
      }
    return points;
  }

  std::optional<MeanOverPeriod> compute_mean_over_last_period(const std::span<const double> times,
                                                              const std::span<const double> values)
  {
    if (values.empty() || values.size() != times.size())
      return {};
    if (const auto [least, most] = std::minmax_element(values.begin(), values.end()); - *least > *most)
      {
        std::vector<double> mirrored(values.begin(), values.end());
        for (double &value : mirrored)
          value = -value;
        auto mean = compute_mean_over_last_period(times, mirrored);
        if (mean)
          mean->mean = -mean->mean;
        return mean;
      }
    const auto        peak   = std::max_element(values.begin(), values.end());
    const std::size_t first  = static_cast<std::size_t>(peak - values.begin());
    const double      range  = *peak - *std::min_element(peak, values.end());
    auto              points = find_turning_points(values.subspan(first), ripple * range);
    points.insert(points.begin(), {0, true}); // the peak itself, from which the filter starts
    if (points.size() < 3 || !(range > 0.))
      return {};
    const std::size_t begin = first + points[points.size() - 3].index, end = first + points.back().index;
    const double      period = times[end] - times[begin];
    return MeanOverPeriod{integrate(times.subspan(begin, end - begin + 1), values.subspan(begin, end - begin + 1)) /
                            period,
                          times[begin], period};
  }
} // namespace birdstrike
