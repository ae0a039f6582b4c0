#pragma once

#include <birdstrike/core/archive.h>

#include <array>
#include <cstddef>
#include <vector>

namespace birdstrike
{
  /// The contact force as an instrument's channel shows it.
  struct FilteredForce
  {
    double                             begin = 0., interval = 0.; ///< s, value k is at begin + k interval
    std::vector<std::array<double, 3>> values;                    ///< N; empty where nothing was recorded
    double                             peak = 0., peak_time = 0.; ///< N, of the norm; s

    double time(std::size_t k) const
    {
      return begin + static_cast<double>(k) * interval;
    }
  };

  /// Low-pass filter of a channel frequency class (SAE J211-1 appendix C, ISO 6487): a two-pole Butterworth filter run
  /// forward and then backward, four poles without a shift of phase,
  ///   w_d = 2 pi CFC 2.0775, w_a = tan(w_d T / 2),
  ///   y_k = a_0 (x_k + 2 x_{k-1} + x_{k-2}) + b_1 y_{k-1} + b_2 y_{k-2},
  ///   a_0 = w_a^2 / d, b_1 = 2 (1 - w_a^2) / d, b_2 = (-1 + sqrt(2) w_a - w_a^2) / d, d = 1 + sqrt(2) w_a + w_a^2.
  /// In place; `interval` T in s, `channel_class` CFC in Hz. Before and after its samples the curve is taken as zero.
  void filter_channel(std::vector<double> &samples, double interval, double channel_class);

  /// Records the contact force (N, global components) for a channel frequency class. Steps of a run vary, the filter's
  /// do not: what is kept are means over intervals of 1/(200 CFC), between evaluations the force is linear. The sum of
  /// the means is therefore its integral by the trapezoidal rule, which is the impulse that the steps give, and the
  /// mean itself takes 0.04 % of a sine at 2 CFC. One value an interval, however many steps.
  class ForceChannel
  {
  public:
    /// `channel_class` in Hz: 1000, 600, 180; 0 records nothing.
    explicit ForceChannel(double channel_class = 0.);

    /// So that what is recorded within the next `duration` (s) allocates nothing.
    void make_room(double duration);

    /// At times (s) that ascend from 0.
    void update(double time, const std::array<double, 3> &force);

    /// Of all so far. It begins and ends 2/CFC outside of what was recorded, where the filter has rung out (1e-8) and
    /// there is no force: a force that acts when the run ends is taken to end with it.
    FilteredForce filter() const;

    /// Mean (N) over the last `duration` (s) of what was recorded, in whole intervals and what has come since; over all
    /// where that is less.
    std::array<double, 3> mean_of_last(double duration) const;

    void archive(Archive &archive);

  private:
    double                             channel_class;
    std::vector<std::array<double, 3>> means;     ///< N, of whole intervals from time 0
    std::array<double, 3>              impulse{}; ///< N s, of the interval since then
    std::array<double, 3>              last_force{};
    double                             last_time = 0.;

    double interval() const;
    void   integrate_to(double time, const std::array<double, 3> &force);
  };
} // namespace birdstrike
