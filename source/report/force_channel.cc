#include <birdstrike/report/force_channel.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace birdstrike
{
  namespace
  {
    constexpr double intervals_per_period = 200.; ///< of the class's frequency
    constexpr double quiet_periods        = 2.;   ///< before and after what is recorded

    /// The two-pole filter over a range, from rest.
    template <class Iterator>
    void run_two_poles(Iterator sample, const Iterator end, const double w)
    {
      const double d = 1. + std::numbers::sqrt2 * w + w * w, a = w * w / d, b1 = 2. * (1. - w * w) / d,
                   b2 = (-1. + std::numbers::sqrt2 * w - w * w) / d;
      double x1 = 0., x2 = 0., y1 = 0., y2 = 0.;
      for (; sample != end; ++sample)
        {
          const double x = *sample, y = a * (x + 2. * x1 + x2) + b1 * y1 + b2 * y2;
          x2      = std::exchange(x1, x);
          y2      = std::exchange(y1, y);
          *sample = y;
        }
    }
  } // namespace

  void filter_channel(std::vector<double> &samples, const double interval, const double channel_class)
  {
    const double w = std::tan(std::numbers::pi * channel_class * 2.0775 * interval);
    run_two_poles(samples.begin(), samples.end(), w);
    run_two_poles(samples.rbegin(), samples.rend(), w);
  }

  ForceChannel::ForceChannel(const double channel_class) : channel_class(channel_class)
  {
  }

  double ForceChannel::interval() const
  {
    return 1. / (intervals_per_period * channel_class);
  }

  void ForceChannel::make_room(const double duration)
  {
    const std::size_t needed =
      channel_class > 0. ? means.size() + static_cast<std::size_t>(duration / interval()) + 2 : 0;
    if (means.capacity() < needed)
      means.reserve(2 * needed);
  }

  void ForceChannel::integrate_to(const double time, const std::array<double, 3> &force)
  {
    for (unsigned int d = 0; d < 3; ++d)
      impulse[d] += 0.5 * (last_force[d] + force[d]) * (time - last_time);
    last_force = force;
    last_time  = time;
  }

  void ForceChannel::update(const double time, const std::array<double, 3> &force)
  {
    if (channel_class == 0.)
      return;
    if (time == 0.)
      last_force = force;
    for (double end; (end = static_cast<double>(means.size() + 1) * interval()) <= time;)
      {
        const double          share = (end - last_time) / (time - last_time);
        std::array<double, 3> at_end;
        for (unsigned int d = 0; d < 3; ++d)
          at_end[d] = last_force[d] + share * (force[d] - last_force[d]);
        integrate_to(end, at_end);
        for (double &sum : impulse)
          sum /= interval();
        means.push_back(std::exchange(impulse, {}));
      }
    integrate_to(time, force);
  }

  FilteredForce ForceChannel::filter() const
  {
    FilteredForce filtered;
    if (means.empty() && last_time == 0.)
      return filtered;
    const auto          n_quiet = static_cast<std::size_t>(quiet_periods * intervals_per_period);
    std::vector<double> channel;
    filtered.interval = interval();
    filtered.begin    = (0.5 - static_cast<double>(n_quiet)) * interval();
    filtered.values.resize(n_quiet + means.size() + 1 + n_quiet);
    for (unsigned int d = 0; d < 3; ++d)
      {
        channel.assign(filtered.values.size(), 0.);
        for (std::size_t k = 0; k < means.size(); ++k)
          channel[n_quiet + k] = means[k][d];
        channel[n_quiet + means.size()] = impulse[d] / interval();
        filter_channel(channel, interval(), channel_class);
        for (std::size_t k = 0; k < channel.size(); ++k)
          filtered.values[k][d] = channel[k];
      }
    for (std::size_t k = 0; k < filtered.values.size(); ++k)
      if (const auto &[x, y, z] = filtered.values[k]; std::hypot(x, y, z) > filtered.peak)
        {
          filtered.peak      = std::hypot(x, y, z);
          filtered.peak_time = filtered.time(k);
        }
    return filtered;
  }

  std::array<double, 3> ForceChannel::mean_of_last(const double duration) const
  {
    if (means.empty() && last_time == 0.)
      return {};
    const auto            wanted = static_cast<std::size_t>(std::lround(duration / interval()));
    const std::size_t     n      = std::min(means.size(), wanted);
    std::array<double, 3> sum    = impulse;
    for (std::size_t k = means.size() - n; k < means.size(); ++k)
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] += means[k][d] * interval();
    const double since = last_time - static_cast<double>(means.size() - n) * interval();
    for (double &component : sum)
      component = since > 0. ? component / since : 0.;
    return sum;
  }

  void ForceChannel::archive(Archive &archive)
  {
    const auto group = archive.group("channel");
    archive("impulse", impulse);
    archive("last force", last_force);
    archive("last time", last_time);
    archive.records("means", means, [](auto &row, std::array<double, 3> &mean) { row("force", mean); });
  }
} // namespace birdstrike
