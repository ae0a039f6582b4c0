#include "report/study/grid_convergence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace birdstrike;

namespace
{
  /// A column of table 1 of Celik et al. (2008): numbers of cells in two dimensions, values, and what they print.
  struct Published
  {
    double n1, n2, n3, f1, f2, f3;
    double order, extrapolated, change, extrapolated_error, gci; ///< the last three in percent
  };

  // Reattachment length (monotone); axial velocity (order below one); axial velocity elsewhere (oscillating).
  const Published published[] = {{18000, 8000, 4500, 6.063, 5.972, 5.863, 1.53, 6.1685, 1.5, 1.7, 2.2},
                                 {18000, 4500, 980, 10.7880, 10.7250, 10.6050, 0.75, 10.8801, 0.6, 0.9, 1.1},
                                 {18000, 4500, 980, 6.0042, 5.9624, 6.0909, 1.51, 6.0269, 0.7, 0.4, 0.5}};

  std::vector<double> sizes_of(const Published &p)
  {
    return {1. / std::sqrt(p.n1), 1. / std::sqrt(p.n2), 1. / std::sqrt(p.n3)};
  }

  /// f = 3 + c h^p on grids that need not grow by one ratio.
  GridConvergence estimate_of_power(const double p, const double c, const std::vector<double> &h)
  {
    std::vector<double> f;
    for (const double size : h)
      f.push_back(3. + c * std::pow(size, p));
    return estimate_convergence(h, f);
  }
} // namespace

TEST(GridConvergence, IsThatOfThePublishedTable)
{
  for (const Published &p : published)
    {
      const auto   h   = sizes_of(p);
      const double r21 = h[1] / h[0], r32 = h[2] / h[1];
      const double order = compute_observed_order(p.f1, p.f2, p.f3, r21, r32);
      EXPECT_NEAR(order, p.order, 0.01) << "printed with two decimals, of ratios printed with three";
      const double value = extrapolate(p.f1, p.f2, r21, order);
      EXPECT_NEAR(value, p.extrapolated, 5e-4) << "half a unit of f in its last digit, amplified by 1/(r^p - 1)";
      EXPECT_NEAR(100. * std::abs((p.f1 - p.f2) / p.f1), p.change, 0.05) << "printed with one decimal";
      EXPECT_NEAR(100. * std::abs((value - p.f1) / value), p.extrapolated_error, 0.06);
      EXPECT_NEAR(100. * 1.25 * std::abs(value - p.f1) / p.f1, p.gci, 0.06);
    }
}

TEST(GridConvergence, EstimatesAsPublishedWhereItIsAsymptotic)
{
  const Published      &p    = published[0];
  const GridConvergence made = estimate_convergence(sizes_of(p), std::vector{p.f1, p.f2, p.f3});
  EXPECT_EQ(made.trend, Trend::asymptotic);
  EXPECT_NEAR(made.order, 1.53, 0.01);
  EXPECT_NEAR(100. * made.gci, 2.2, 0.06);
  EXPECT_NEAR(made.bar, made.gci * p.f1, 1e-12);
  EXPECT_NEAR(made.ratio, 1., 0.05) << "f1/f2 where the order is the observed one";
  const Published &oscillating = published[2];
  EXPECT_EQ(
    estimate_convergence(sizes_of(oscillating), std::vector{oscillating.f1, oscillating.f2, oscillating.f3}).trend,
    Trend::oscillating);
}

TEST(GridConvergence, FindsTheOrderAndTheLimitOfAPower)
{
  for (const double p : {0.6, 1., 1.5, 2.})
    for (const auto &h : {std::vector{1., 2., 4.}, std::vector{1., 1.3, 2.1}, std::vector{0.7, 1., 1.2, 1.9}})
      {
        const GridConvergence made = estimate_of_power(p, -0.05, h);
        EXPECT_EQ(made.trend, Trend::asymptotic) << p;
        EXPECT_NEAR(made.order, p, 1e-8) << "round-off over changes of a hundredth";
        EXPECT_NEAR(made.extrapolated, 3., 1e-9);
        EXPECT_NEAR(made.bar, 1.25 * 0.05 * std::pow(h[0], p), 1e-9);
      }
}

TEST(GridConvergence, TrustsNoOrderThatTheMethodHasNot)
{
  const GridConvergence fast = estimate_of_power(4., 0.01, {1., 2., 4.});
  EXPECT_EQ(fast.trend, Trend::not_asymptotic);
  EXPECT_NEAR(fast.bar, 3. * 0.15 / 3., 1e-9) << "3 |f2 - f1|/(2^2 - 1)";
  const GridConvergence slow = estimate_of_power(0.2, 0.01, {1., 2., 4.});
  EXPECT_EQ(slow.trend, Trend::not_asymptotic);
  EXPECT_GT(slow.bar, 0.01) << "what is left to go";
}

TEST(GridConvergence, SaysWhereThereIsNone)
{
  const std::vector<double> h{1., 2., 4.};
  const auto                trend = [&](const double f1, const double f2, const double f3) {
    return estimate_convergence(h, std::vector{f1, f2, f3});
  };
  EXPECT_EQ(trend(3., 2., 1.5).trend, Trend::diverging);
  EXPECT_TRUE(std::isnan(trend(3., 2., 1.5).bar));
  EXPECT_EQ(trend(1., 2., 1.9).trend, Trend::diverging) << "swings that grow";
  const GridConvergence swings = trend(1., 1.01, 0.98);
  EXPECT_EQ(swings.trend, Trend::oscillating);
  EXPECT_NEAR(swings.bar, 0.06, 1e-12) << "three times the largest change";
  EXPECT_FALSE(swings.is_trusted());
  EXPECT_EQ(trend(1., 1., 1.).trend, Trend::settled);
  EXPECT_EQ(trend(1., 1., 1.).gci, 0.);
  EXPECT_EQ(trend(0., 0., 0.).gci, 0.);
  EXPECT_EQ(trend(1., 1., 1.2).trend, Trend::not_asymptotic) << "one grid stood still: no power";
  EXPECT_EQ(trend(1., NAN, 1.).trend, Trend::unknown);
  EXPECT_THROW(estimate_convergence(std::vector{1., 2.}, std::vector{1., 2.}), std::logic_error);
  EXPECT_THROW(estimate_convergence(std::vector{2., 1., 3.}, std::vector{1., 2., 3.}), std::logic_error);
}

TEST(GridConvergence, AFourthGridMayObject)
{
  // Orders: 1 of the three finest grids, 3 of the three coarsest.
  const std::vector<double> h{1., 2., 4., 8.}, f{3.01, 3.02, 3.04, 3.2};
  EXPECT_EQ(estimate_convergence(std::span(h).first(3), std::span(f).first(3)).trend, Trend::asymptotic);
  EXPECT_EQ(estimate_convergence(h, f).trend, Trend::not_asymptotic);
  // Orders 1.2 and 2.5, a fit of 2.08 with little scatter: with one more grid 1.29, and a limit that is farther away.
  const std::vector<double> spacings{1.25, 1.75, 2.5, 3.5, 5.}, impulses{8.89, 9.10, 9.44, 10.19, 11.01};
  const GridConvergence     four = estimate_convergence(std::span(spacings).first(4), std::span(impulses).first(4)),
                        five     = estimate_convergence(spacings, impulses);
  EXPECT_EQ(four.trend, Trend::not_asymptotic);
  EXPECT_GT(four.bar, std::abs(five.extrapolated - impulses[0])) << "three times the distance to its own limit";
}

// scipy 1.10, see error_fit_test.cc: f_ext = 8.437778, U = 1.25*0.437132 + 0.077256 + 0.015090.
TEST(GridConvergence, IsByLeastSquaresOverFourGridsAndMore)
{
  const std::vector<double> h{1.25, 1.75, 2.5, 3.5, 5.}, f{8.89, 9.10, 9.44, 10.19, 11.01};
  const GridConvergence     made = estimate_convergence(h, f);
  EXPECT_EQ(made.trend, Trend::asymptotic);
  EXPECT_EQ(made.method(), "least squares over 5 levels");
  EXPECT_NEAR(made.order, 1.289507, 1e-6);
  EXPECT_NEAR(made.extrapolated, 8.437778, 1e-6);
  EXPECT_NEAR(made.bar, 0.638761, 3e-6) << "three terms of six digits";
  EXPECT_DOUBLE_EQ(made.gci, made.bar / 8.89);
  EXPECT_TRUE(std::isnan(made.ratio));
  EXPECT_EQ(estimate_convergence(std::span(h).first(3), std::span(f).first(3)).method(), "three levels");
}

TEST(GridConvergence, OfValuesWithScatterHoldsTheTruthInItsBar)
{
  // Scatter of standard deviation 0.9, times a tenth of the last change of 1 + 0.05 h; a fifteenth of that of h^1.5.
  const std::vector<double> drawn{0.50, -1.12, 0.31, 1.45, -0.68}, h{1., 1.4, 2., 2.8, 4.};
  for (const double p : {1., 1.5})
    for (const double sign : {-1., 1.})
      for (const double swing : {-1., 1.})
        {
          std::vector<double> f;
          for (std::size_t k = 0; k < h.size(); ++k)
            f.push_back(1. + sign * 0.05 * std::pow(h[k], p) + swing * 0.002 * drawn[k]);
          const GridConvergence made = estimate_convergence(h, f);
          EXPECT_EQ(made.trend, Trend::asymptotic);
          EXPECT_GT(made.deviation, 0.001) << "of 0.002, with two degrees of freedom";
          EXPECT_GE(made.bar, std::abs(f[0] - 1.)) << p << " " << sign << " " << swing;
        }
}

// Two terms through scatter would extrapolate it: nine in ten bars of 43 times the scatter then.
TEST(GridConvergence, ScatterAloneIsNotExtrapolated)
{
  const std::vector<double>  h{1., 1.2, 1.44, 1.728, 2.0736};
  const double               deviation = 0.003;
  std::mt19937               engine(7);
  std::normal_distribution<> scatter(0., deviation);
  std::vector<double>        bars;
  for (int ladder = 0; ladder < 300; ++ladder)
    {
      std::vector<double> f;
      for (std::size_t k = 0; k < h.size(); ++k)
        f.push_back(1. + scatter(engine));
      if (const GridConvergence made = estimate_convergence(h, f); made.trend == Trend::scattered)
        {
          EXPECT_GE(made.bar, std::abs(f[0] - 1.));
          bars.push_back(made.bar);
        }
    }
  ASSERT_GT(bars.size(), 200u);
  std::ranges::sort(bars);
  EXPECT_LT(bars[bars.size() * 9 / 10], 20. * deviation);
}

TEST(GridConvergence, SaysWhereAFitIsNone)
{
  const std::vector<double> h{1., 2., 4., 8., 16.};
  const auto                of    = [&](const std::vector<double> &f) { return estimate_convergence(h, f); };
  const GridConvergence     grows = of({3., 2., 1.5, 1.25, 1.125});
  EXPECT_EQ(grows.trend, Trend::diverging) << "h^-1";
  EXPECT_TRUE(std::isnan(grows.bar) && std::isnan(grows.extrapolated));
  EXPECT_EQ(of({1., 1.1, 1.2, 1.3, 1.4}).trend, Trend::diverging) << "a logarithm has no limit";
  const GridConvergence swings = of({1., 1.02, 0.99, 1.01, 0.98});
  EXPECT_EQ(swings.trend, Trend::scattered);
  EXPECT_GT(swings.bar, 0.04) << "all that they are apart";
  EXPECT_TRUE(swings.is_trusted() && std::isnan(swings.extrapolated));
  const GridConvergence alone = of({1.1, 1., 1.001, 0.999, 1.});
  EXPECT_EQ(alone.trend, Trend::diverging) << "the finest";
  EXPECT_TRUE(std::isnan(alone.order) && std::isnan(alone.bar));
  const GridConvergence slow = of({3.01, 3.011487, 3.013195, 3.015157, 3.017411});
  EXPECT_EQ(slow.trend, Trend::not_asymptotic) << "order 0.2";
  EXPECT_NEAR(slow.order, 0.2, 1e-3) << "six decimals of changes of 2e-3";
  EXPECT_EQ(estimate_of_power(4., 0.01, h).trend, Trend::not_asymptotic);
  EXPECT_EQ(of({1., 1., 1., 1., 1.}).trend, Trend::settled);
  EXPECT_EQ(of({0., 0., 0., 0., 0.}).gci, 0.);
  EXPECT_EQ(of({1., 1., 1., 1.3, 1.7}).method(), "three levels") << "settled, whatever coarser ones do";
  EXPECT_EQ(of({1., 1., 1.2, 1.3, 1.4}).trend, Trend::not_asymptotic)
    << "one grid stood still: order above 2 or below 0.5";
}

TEST(GridConvergence, TakesValuesOfAnySignAndALimitOfZero)
{
  const std::vector<double> h{1., 2., 4., 8.};
  for (const double limit : {-3., 0.})
    {
      std::vector<double> f;
      for (const double size : h)
        f.push_back(limit + 0.1 * size);
      const GridConvergence made = estimate_convergence(h, f);
      EXPECT_EQ(made.trend, Trend::asymptotic);
      EXPECT_NEAR(made.extrapolated, limit, 1e-12) << "round-off over changes of a tenth";
      EXPECT_NEAR(made.bar, 0.125, 1e-12);
      EXPECT_NEAR(made.gci, 0.125 / std::abs(f[0]), 1e-11);
    }
}

TEST(GridConvergence, LeavesOutLevelsWithoutAValue)
{
  const std::vector<double> h{1., 2., 3., 4., 8.}, f{3.1, 3.2, NAN, 3.4, 3.8};
  const GridConvergence     made = estimate_convergence(h, f);
  EXPECT_EQ(made.n_fitted, 4u);
  EXPECT_NEAR(made.extrapolated, 3., 1e-12);
  const GridConvergence three = estimate_convergence(h, std::vector<double>{3.1, NAN, NAN, 3.4, 3.8});
  EXPECT_EQ(three.method(), "three levels");
  EXPECT_NEAR(three.extrapolated, 3., 1e-9);
  for (const auto &lost : {std::vector<double>{NAN, 3.2, 3.3, 3.4, 3.8}, std::vector<double>{3.1, NAN, NAN, NAN, 3.8}})
    {
      EXPECT_EQ(estimate_convergence(h, lost).trend, Trend::unknown);
      EXPECT_EQ(estimate_convergence(h, lost).method(), "-");
      EXPECT_TRUE(std::isnan(estimate_convergence(h, lost).bar));
    }
}
