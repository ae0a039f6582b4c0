#include <birdstrike/report/force_channel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

using namespace birdstrike;

namespace
{
  using ForceCurve = std::function<double(double)>; // N over s

  constexpr double pi = std::numbers::pi;

  /// Of a force along x, recorded in steps of `step` s until `end`.
  FilteredForce filter(const ForceCurve &force, const double end, const double step, const double channel_class = 1000.)
  {
    ForceChannel channel(channel_class);
    const auto   n = std::lround(end / step);
    for (long k = 0; k <= n; ++k)
      channel.update(step * static_cast<double>(k), {force(step * static_cast<double>(k)), 0., 0.});
    return channel.filter();
  }

  /// Gain in dB of a sine of `frequency` Hz, far from the ends of 60 periods of the class.
  double gain(const double frequency, const double channel_class)
  {
    const double end      = 60. / channel_class;
    const auto   filtered = filter([&](const double t) { return std::sin(2. * pi * frequency * t); }, end,
                                 1e-3 / channel_class, channel_class);
    double       sine = 0., cosine = 0., n = 0.; // by correlation over whole periods in the middle
    const double from = std::ceil(20. * frequency / channel_class) / frequency,
                 to   = std::floor(40. * frequency / channel_class) / frequency;
    for (std::size_t k = 0; k < filtered.values.size(); ++k)
      if (const double t = filtered.time(k); t >= from && t < to)
        {
          sine += filtered.values[k][0] * std::sin(2. * pi * frequency * t);
          cosine += filtered.values[k][0] * std::cos(2. * pi * frequency * t);
          n += 0.5;
        }
    EXPECT_LT(std::abs(cosine), 1e-3 * std::abs(sine) + 1e-6 * n) << "a shift of phase at " << frequency << " Hz";
    return 20. * std::log10(std::abs(sine) / n);
  }

  double half_sine(const double t, const double duration)
  {
    return t > 0. && t < duration ? std::sin(pi * t / duration) : 0.;
  }

  double impulse_of(const FilteredForce &filtered)
  {
    double sum = 0.;
    for (const auto &value : filtered.values)
      sum += value[0] * filtered.interval;
    return sum;
  }
} // namespace

// SAE J211-1 figure 1: within +0.5 and -1 dB to F_H = CFC, +0.5 and -4 dB at F_N = CFC/0.6, from there falling by no
// less than 9 and no more than 24 dB an octave.
TEST(ForceChannel, MeanOfTheLastIsItsImpulseOverItsTime)
{
  ForceChannel channel(1000.); // intervals of 5 us
  EXPECT_EQ(channel.mean_of_last(1e-3), (std::array<double, 3>{}));
  for (int k = 0; k <= 1000; ++k) // of 1 us
    channel.update(1e-6 * k, {1e6 * 1e-6 * k, -2., 0.});
  EXPECT_NEAR(channel.mean_of_last(0.2e-3)[0], 900., 1e-9 * 900.); // of a ramp to 1000 N
  EXPECT_NEAR(channel.mean_of_last(0.2e-3)[1], -2., 1e-12);
  EXPECT_NEAR(channel.mean_of_last(5e-3)[0], 500., 1e-9 * 500.) << "all there is";
  channel.update(1.003e-3, {1003., -2., 0.}); // within an interval
  EXPECT_NEAR(channel.mean_of_last(0.2e-3)[0], 0.5 * (800. + 1003.), 1e-6);
}

TEST(ForceChannel, GainStaysInTheCorridor)
{
  for (const double channel_class : {1000., 600., 180.})
    {
      for (const double share : {0.1, 0.3, 0.5, 0.8, 1.})
        {
          EXPECT_LT(gain(share * channel_class, channel_class), 0.5) << share;
          EXPECT_GT(gain(share * channel_class, channel_class), -1.) << share;
        }
      const double corner = channel_class / 0.6;
      for (const double octaves : {0., 0.5, 1., 2.})
        {
          const double g = gain(corner * std::exp2(octaves), channel_class);
          EXPECT_LT(g, 0.5 - 9. * octaves) << octaves;
          EXPECT_GT(g, -4. - 24. * octaves) << octaves;
        }
    }
}

// The phaseless filter answers an impulse with w/(2 sqrt 2) exp(-s) (cos s + sin s), s = w |t|/sqrt 2, w = 2 pi 2.0775
// CFC. The transform to steps of T errs by (w T)^2/12 = 4e-4 at w.
TEST(ForceChannel, AHalfSineBecomesItsConvolution)
{
  constexpr double duration = 0.8e-3, w = 2. * pi * 2077.5, fine = 1e-6;
  const auto       filtered = filter([](const double t) { return half_sine(t, duration); }, 2e-3, 0.7e-6);
  double           largest  = 0.;
  for (std::size_t k = 0; k < filtered.values.size(); ++k)
    {
      double exact = 0.;
      for (double t = 0.5 * fine; t < duration; t += fine)
        {
          const double s = w * std::abs(filtered.time(k) - t) / std::numbers::sqrt2;
          exact +=
            fine * half_sine(t, duration) * w / (2. * std::numbers::sqrt2) * std::exp(-s) * (std::cos(s) + std::sin(s));
        }
      EXPECT_NEAR(filtered.values[k][0], exact, 1e-3) << filtered.time(k);
      largest = std::max(largest, exact);
    }
  EXPECT_NEAR(filtered.peak, largest, 1e-3);
  EXPECT_NEAR(filtered.peak_time, 0.5 * duration, filtered.interval) << "no shift of phase";
}

TEST(ForceChannel, ImpulseIsKept)
{
  // exact by the trapezoidal rule: samples on the corners; what the filter still rings with at the ends is 1e-8
  const auto triangle = [](const double t) { return 1e5 * std::max(0., 1. - std::abs(t - 20e-6) / 20e-6); };
  EXPECT_NEAR(impulse_of(filter(triangle, 1e-3, 4e-6)), 2., 1e-6);
  EXPECT_NEAR(impulse_of(filter([](double) { return 1000.; }, 1.0003e-3, 0.7e-6)), 1.0003, 1e-5)
    << "that acts to the end, within an interval";
}

// 1 kN for 2 us, less than the interval of 5 us: 0.002 N s, as ImpulseIsKept has it.
TEST(ForceChannel, RecordsLessThanAnInterval)
{
  EXPECT_NEAR(impulse_of(filter([](double) { return 1000.; }, 2e-6, 0.5e-6)), 2e-3, 2e-3 * 1e-6);
}

TEST(ForceChannel, StepsOfTheRunDoNotMatter)
{
  const auto   force = [](const double t) { return 1e4 * std::max(0., 1. - t / 0.5e-3); };
  ForceChannel uneven(1000.);
  double       t = 0.;
  uneven.update(0., {force(0.), 0., 0.});
  for (int k = 1; t < 1e-3; ++k) // between 0.05 and 30 us, on the corner and the end
    {
      const double next = t + 0.05e-6 * (1 + (k * k) % 600);
      t                 = t < 0.5e-3 ? std::min(next, 0.5e-3) : std::min(next, 1e-3);
      uneven.update(t, {force(t), 0., 0.});
    }
  const auto a = uneven.filter(), b = filter(force, 1e-3, 0.5e-6);
  ASSERT_EQ(a.values.size(), b.values.size());
  for (std::size_t k = 0; k < a.values.size(); ++k)
    EXPECT_NEAR(a.values[k][0], b.values[k][0], 1e-8 * 1e4) << "round-off of two sums";
  EXPECT_NEAR(a.peak, b.peak, 1e-8 * 1e4);
}

TEST(ForceChannel, NothingIsRecordedOfNoClass)
{
  EXPECT_TRUE(filter([](double) { return 1.; }, 1e-3, 1e-6, 0.).values.empty());
  EXPECT_TRUE(ForceChannel(1000.).filter().values.empty()) << "nor where there is no contact";
}
