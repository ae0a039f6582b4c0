#include "report/comparison/curve_features.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using birdstrike::compute_mean_over_last_period;
using birdstrike::find_turning_points;

namespace
{
  struct Curve
  {
    std::vector<double> t, y;
  };

  /// A blade that is thrown from 0 to `stays` + `amplitude` and then vibrates about `stays`, with a ripple of the
  /// second bending mode (6.27 times the first) on it.
  Curve vibrate(const double stays, const double amplitude, const double ripple, const double n_periods)
  {
    constexpr double period = 27e-3;
    Curve            curve;
    for (double t = 0.; t <= n_periods * period; t += period / 5000.)
      {
        const double phase = 2. * std::numbers::pi * t / period;
        curve.t.push_back(t);
        curve.y.push_back(stays + amplitude * std::sin(phase - 0.5) + ripple * std::sin(6.27 * phase));
      }
    return curve;
  }
} // namespace

TEST(CurveFeatures, TurningPointsAlternateAndRipplesAreNone)
{
  const std::vector<double> y{0., 1., 0.9, 3., 2.95, 1., 1.05, 0.5, 2., 1.9};
  const auto                points = find_turning_points(y, 0.5);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].index, 3u);
  EXPECT_TRUE(points[0].is_maximum);
  EXPECT_EQ(points[1].index, 7u);
  EXPECT_FALSE(points[1].is_maximum);
  EXPECT_TRUE(find_turning_points(y, 5.).empty());
  EXPECT_TRUE(find_turning_points({}, 0.5).empty());
}

TEST(CurveFeatures, MeanOverAPeriodIsTheDeflectionThatStays)
{
  const Curve curve = vibrate(0.12, 0.05, 0., 3.);
  const auto  mean  = compute_mean_over_last_period(curve.t, curve.y);
  ASSERT_TRUE(mean);
  EXPECT_NEAR(mean->period, 27e-3, 27e-3 / 2500.) << "both ends are samples";
  EXPECT_NEAR(mean->mean, 0.12, 1e-6) << "a sine sampled 5000 times";
}

TEST(CurveFeatures, ACurveTheOtherWayHasTheOppositeMean)
{
  Curve      curve = vibrate(0.12, 0.05, 0., 3.);
  const auto mean  = compute_mean_over_last_period(curve.t, curve.y);
  for (double &y : curve.y)
    y = -y;
  EXPECT_EQ(compute_mean_over_last_period(curve.t, curve.y)->mean, -mean->mean);
}

TEST(CurveFeatures, ARippleIsNotTakenForThePeriod)
{
  const Curve curve = vibrate(0.12, 0.05, 0.006, 3.);
  const auto  mean  = compute_mean_over_last_period(curve.t, curve.y);
  ASSERT_TRUE(mean);
  // the ripple moves the extremes by at most half of its own period, and leaves at most half a wave of itself
  EXPECT_NEAR(mean->period, 27e-3, 27e-3 / 6.27);
  EXPECT_NEAR(mean->mean, 0.12, 0.006);
}

TEST(CurveFeatures, LessThanAPeriodAfterThePeakHasNoMean)
{
  const Curve curve = vibrate(0.12, 0.05, 0., 1.2); // peak at 0.33 periods
  EXPECT_FALSE(compute_mean_over_last_period(curve.t, curve.y));
  EXPECT_FALSE(compute_mean_over_last_period({}, {}));
  EXPECT_FALSE(compute_mean_over_last_period(std::vector<double>{0., 1.}, std::vector<double>{0., 0.}));
}
