#include <birdstrike/time_control/peak.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace birdstrike;

namespace
{
  /// Time at which a maximum counts as passed on a curve sampled every 10 us; -1 if it never does until 60 ms.
  template <class Deflection, class Load>
  double find_end(const Deflection &deflection, const Load &load, const double wait)
  {
    FirstMaximum maximum;
    for (int k = 0; k < 6000; ++k)
      {
        const double t = 1e-5 * k;
        maximum.update(t, deflection(t), load(t));
        if (maximum.is_passed(t, wait))
          return t;
      }
    return -1.;
  }

  double short_load(const double t)
  {
    return t < 0.5e-3 ? 1e5 : 0.;
  }
} // namespace

TEST(FirstMaximum, WaitsForThePeakOfTheSwing)
{
  const auto swing = [](const double t) { return 0.3 * std::sin(std::numbers::pi * t / 20e-3); };
  EXPECT_NEAR(find_end(swing, short_load, 1e-3), 11e-3, 2e-5);
}

TEST(FirstMaximum, IsNotFooledByTheBackwardMotion)
{
  // a trace forward, 4 mm backwards for 3 ms, then the swing
  const auto tip = [](const double t) {
    return t < 1e-4 ? 1e-6 : t < 3e-3 ? -4e-3 : 0.3 * std::sin(std::numbers::pi * (t - 3e-3) / 20e-3);
  };
  EXPECT_NEAR(find_end(tip, short_load, 1e-3), 14e-3, 2e-5);
}

TEST(FirstMaximum, IsNotFooledByTheWayBackThroughZero)
{
  // a bump of 1 mm at 0.25 ms, 9 mm backwards at 1.75 ms, then the swing to 77 mm at 13 ms
  const auto tip = [](const double t) {
    if (t < 0.5e-3)
      return 1e-3 * std::sin(std::numbers::pi * t / 0.5e-3);
    return t < 3e-3 ? -9e-3 * std::sin(std::numbers::pi * (t - 0.5e-3) / 2.5e-3)
                    : 77e-3 * std::sin(std::numbers::pi * (t - 3e-3) / 20e-3);
  };
  EXPECT_NEAR(find_end(tip, short_load, 1e-3), 14e-3, 2e-5);
  FirstMaximum maximum;
  for (int k = 0; k < 500; ++k)
    maximum.update(1e-5 * k, tip(1e-5 * k), short_load(1e-5 * k));
  EXPECT_FALSE(maximum.has_turned_back(4.99e-3, 0.)) << "to the larger one on the other side";
}

// Of what spin and pressure deflect before anything strikes, 115 mm, the swing backwards is 3 mm.
TEST(FirstMaximum, IsThatOfTheWayFromTheStart)
{
  const auto tip = [](const double t) {
    return 0.115 + (t < 3e-3 ? -3e-3 : 0.1) * std::sin(std::numbers::pi * (t < 3e-3 ? t / 3e-3 : (t - 3e-3) / 20e-3));
  };
  EXPECT_NEAR(find_end(tip, short_load, 1e-3), 14e-3, 2e-5);
}

TEST(FirstMaximum, IsNotFooledWhileTheLoadActs)
{
  // a peak under load, then rest: it counts only once the load has gone
  const auto tip  = [](const double t) { return t < 1e-3 ? t : 1e-3 - 1e-2 * (t - 1e-3); };
  const auto load = [](const double t) { return t < 4e-3 ? 1e5 : 0.; };
  EXPECT_NEAR(find_end(tip, load, 1e-3), 5e-3, 2e-5);
}

TEST(FirstMaximum, IsNotFooledByARippleShorterThanTheWait)
{
  const auto tip = [](const double t) {
    return 0.3 * std::sin(std::numbers::pi * t / 20e-3) + 3e-3 * std::sin(2. * std::numbers::pi * t / 1.5e-3);
  };
  const double end = find_end(tip, short_load, 1e-3);
  EXPECT_GT(end, 10e-3);
  EXPECT_LT(end, 12.5e-3);
}

TEST(FirstMaximum, NeverEndsACurveThatRises)
{
  EXPECT_EQ(find_end([](const double t) { return t; }, short_load, 1e-3), -1.);
}

TEST(FirstMaximum, IsFoundInTheOtherDirectionToo)
{
  // nothing strikes: the swing of an initial velocity, away from the normal
  const auto swing = [](const double t) { return -0.3 * std::sin(std::numbers::pi * t / 20e-3); };
  const auto none  = [](double) { return 0.; };
  EXPECT_NEAR(find_end(swing, none, 1e-3), 11e-3, 2e-5);
  // a bird throws the tip backwards for good, most at 10 ms: known when it has swung through to its lesser maximum on
  // the other side, at 30 ms, and twice 10 ms have passed
  const auto thrown = [](const double t) { return (t < 20e-3 ? -0.3 : -0.1) * std::sin(std::numbers::pi * t / 20e-3); };
  EXPECT_NEAR(find_end(thrown, short_load, 1e-3), 50e-3, 2e-5);
}

TEST(SignedPeak, IsTheLargestInEitherDirection)
{
  SignedPeak peak;
  EXPECT_EQ(peak.value(), 0.);
  EXPECT_TRUE(peak.update(1., 2.));
  EXPECT_TRUE(peak.update(2., -3.));
  EXPECT_FALSE(peak.update(3., 3.)) << "the first of two equal ones";
  EXPECT_EQ(peak.value(), -3.);
  EXPECT_EQ(peak.time(), 2.);
  EXPECT_TRUE(peak.update(4., std::nan(""))) << "a lost value is not hidden";
}

// A run that goes on after a NaN does not lose it in its peaks.
TEST(Peak, KeepsWhatIsNoNumber)
{
  for (const int at : {0, 1, 4})
    {
      Peak       peak;
      SignedPeak signed_peak;
      for (int k = 0; k < 5; ++k)
        {
          peak.update(k, k == at ? NAN : 1. + k);
          signed_peak.update(k, k == at ? NAN : -1. - k);
        }
      EXPECT_TRUE(std::isnan(peak.value())) << at;
      EXPECT_EQ(peak.time(), at);
      EXPECT_TRUE(std::isnan(signed_peak.value())) << at;
      EXPECT_EQ(signed_peak.time(), at);
    }
}
