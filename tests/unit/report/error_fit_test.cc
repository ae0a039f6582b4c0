#include "report/study/error_fit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

using namespace birdstrike;

namespace
{
  using Values = std::vector<double>;

  Values of_power(const Values &h, const double limit, const double c, const double p)
  {
    Values f;
    for (const double size : h)
      f.push_back(limit + c * std::pow(size, p));
    return f;
  }

  Values alike(const std::size_t n)
  {
    return Values(n, 1. / static_cast<double>(n));
  }

  /// 1/h^k, of sum 1.
  Values inverse_power(const Values &h, const double k)
  {
    Values w;
    double sum = 0.;
    for (const double size : h)
      sum += std::pow(size, -k);
    for (const double size : h)
      w.push_back(std::pow(size, -k) / sum);
    return w;
  }

  // Impulse (N s) of an oblique strike by particle spacing (mm).
  const Values spacings{1.25, 1.75, 2.5, 3.5, 5.}, impulses{8.89, 9.10, 9.44, 10.19, 11.01};
} // namespace

TEST(ErrorFit, FindsTheOrderAndTheLimitOfAPower)
{
  for (const double p : {0.6, 1., 1.5, 1.99})
    for (const double limit : {-7., 0., 3.})
      for (const double c : {-0.05, 2.})
        for (const auto &h : {Values{1., 2., 4., 8.}, Values{0.7, 1., 1.2, 1.9, 2.2}, Values{3e-3, 4e-3, 6e-3, 9e-3}})
          {
            const ErrorFit fit   = fit_error(h, of_power(h, limit, c, p));
            const double   error = c * std::pow(h[0], p);
            // Round-off of a value over the smallest change, which an extrapolation by the smallest p multiplies by
            // 1e3.
            const double round_off = 1e3 * 2e-16 * (std::abs(limit) + 20.);
            EXPECT_NEAR(fit.order, p, round_off / std::abs(error)) << limit << " " << c;
            EXPECT_NEAR(fit.limit, limit, round_off);
            EXPECT_NEAR(fit.error, error, round_off);
            EXPECT_NEAR(fit.residual, 0., round_off);
            EXPECT_NEAR(fit.deviation, 0., round_off);
          }
}

// scipy 1.10, digits that two starts agree on:
//   H = numpy.array([1.25, 1.75, 2.5, 3.5, 5]); F = numpy.array([8.89, 9.10, 9.44, 10.19, 11.01]); w = 1/H/sum(1/H)
//   (f0, a, p), _ = scipy.optimize.curve_fit(lambda h, f0, a, p: f0 + a*h**p, H, F, [8, 0.5, 1], sigma=w**-0.5,
//   xtol=1e-14) r = F - f0 - a*H**p; print(p, f0, a*H[0]**p, r[0], numpy.sqrt(5*sum(w*r*r)/(5 - 3)));  unweighted:
//   sigma=numpy.ones(5)
TEST(ErrorFit, IsThatOfAnotherProgramForValuesWithScatter)
{
  const ErrorFit weighted = fit_expansion(Expansion::power, spacings, impulses, inverse_power(spacings, 1.));
  EXPECT_NEAR(weighted.order, 1.289507, 1e-6);
  EXPECT_NEAR(weighted.limit, 8.437778, 1e-6);
  EXPECT_NEAR(weighted.error, 0.437132, 1e-6);
  EXPECT_NEAR(weighted.residual, 0.015090, 1e-6);
  EXPECT_NEAR(weighted.deviation, 0.0772560, 1e-7);
  const ErrorFit unweighted = fit_expansion(Expansion::power, spacings, impulses, alike(5));
  EXPECT_NEAR(unweighted.order, 1.193240, 1e-6);
  EXPECT_NEAR(unweighted.limit, 8.345169, 1e-6);
  EXPECT_NEAR(unweighted.deviation, 0.0894631, 1e-7);
  EXPECT_EQ(fit_error(spacings, impulses).limit, weighted.limit) << "the smaller deviation";
}

// Values and results of cfd-verify's tests (test_model.py), whose weights are 1/h^2; its optimiser stops at 1e-8.
TEST(ErrorFit, ExpansionsAreThoseOfCfdVerify)
{
  const Values h{0.1, 0.2, 0.35, 0.5}, w = inverse_power(h, 2.), steps{10., 10.02, 10.03, 10.05};
  EXPECT_NEAR(fit_expansion(Expansion::first, h, Values{10., 9.95, 10.05, 10.}, w).limit, 9.991967476, 2e-8);
  EXPECT_NEAR(fit_expansion(Expansion::second, h, of_power(h, 10., -5., 4.), w).limit, 10.016485557, 2e-8);
  EXPECT_NEAR(fit_expansion(Expansion::first_and_second, h, steps, w).limit, 9.979217216, 2e-8);
  EXPECT_NEAR(fit_expansion(Expansion::power, h, steps, w).order, 0.0834, 1e-4) << "a flat minimum";
}

// Four grids of Qu and Mudawar's micro-channel, with what meteor-cfd's tests expect of them.
TEST(ErrorFit, UncertaintiesAreThoseOfMeteorCfd)
{
  Values h;
  for (const double cells : {259350., 115200., 48600., 14400.})
    h.push_back(std::pow(cells, -1. / 3.));
  const Values   outlet{0.23507, 0.23490, 0.23459, 0.23374}, inlet{0.09289, 0.09239, 0.09163, 0.09050};
  const ErrorFit smooth = fit_error(h, outlet), slow = fit_error(h, inlet);
  EXPECT_NEAR(smooth.order, 1.895, 0.005);
  EXPECT_NEAR(smooth.limit, 0.235325, 2e-5);
  EXPECT_NEAR(uncertainty(smooth, data_range(outlet), 1.25), 3.2e-4, 1e-5) << "3.1e-4 to 3.3e-4";
  EXPECT_NEAR(slow.order, 0.55, 0.05);
  EXPECT_NEAR(slow.limit, 0.09635, 2.5e-4);
  EXPECT_NEAR(uncertainty(slow, data_range(inlet), 1.25), 4.35e-3, 3.5e-4) << "4.0e-3 to 4.7e-3";
  // Swings of 0.2 about 2 + 0.7 h^1.5, of which their rules take the first order: sigma and U as printed there.
  const Values   swings{2. + 0.7 * std::pow(0.125, 1.5) + 0.2, 2. + 0.7 * 0.125 - 0.2,
                      2. + 0.7 * std::pow(0.5, 1.5) + 0.2, 2.7 - 0.2};
  const ErrorFit first = fit_expansion(Expansion::first, Values{0.125, 0.25, 0.5, 1.}, swings, alike(4));
  EXPECT_NEAR(first.deviation, 0.2446, 1e-4);
  EXPECT_NEAR(data_range(swings), 0.2042, 1e-4);
  EXPECT_NEAR(uncertainty(first, data_range(swings), 3.), 1.5945, 1e-3) << "sigma above Delta";
}

TEST(ErrorFit, TakesOtherExpansionsWhereThePowerIsNone)
{
  const Values   h{1., 2., 4., 8.};
  const ErrorFit fast = fit_error(h, of_power(h, 3., 0.01, 4.));
  EXPECT_NEAR(fast.order, 4., 1e-9) << "observed";
  EXPECT_EQ(fast.expansion, Expansion::second);
  const ErrorFit slow = fit_error(h, of_power(h, 3., 0.01, 0.2));
  EXPECT_NEAR(slow.order, 0.2, 1e-9);
  EXPECT_EQ(slow.expansion, Expansion::first_and_second) << "its deviation is the smallest of three";
  const ErrorFit grows = fit_error(h, of_power(h, 3., 0.01, -1.));
  EXPECT_NEAR(grows.order, -1., 1e-9);
  EXPECT_NE(grows.expansion, Expansion::power);
}

TEST(ErrorFit, OfALogarithmHasOrderZero)
{
  const Values h{1., 2., 4., 8.}, f{3., 3.1, 3.2, 3.3};
  EXPECT_NEAR(fit_expansion(Expansion::power, h, f, alike(4)).order, 0., 1e-9) << "round-off over changes of 0.1";
  EXPECT_TRUE(std::isfinite(fit_error(h, f).limit)) << "of another expansion";
}

TEST(ErrorFit, UncertaintyAddsTheScatter)
{
  const ErrorFit fit{Expansion::power, 1., 0.02, 1., -0.1, 0.01, 0.02};
  EXPECT_NEAR(uncertainty(fit, 0.03, 1.25), 1.25 * 0.1 + 0.02 + 0.01, 1e-15);
  EXPECT_NEAR(uncertainty(fit, 0.03, 3.), 0.33, 1e-15);
  EXPECT_NEAR(uncertainty(fit, 0.01, 1.25), 6. * 0.13, 1e-15) << "3 sigma/Delta";
}

TEST(ErrorFit, RefusesFewerValuesThanUnknowns)
{
  const Values three{1., 2., 3.};
  EXPECT_THROW(fit_error(three, three), std::logic_error);
  EXPECT_THROW(fit_expansion(Expansion::power, three, three, alike(3)), std::logic_error);
  EXPECT_THROW(fit_expansion(Expansion::first, three, three, alike(2)), std::logic_error);
  EXPECT_NO_THROW(fit_expansion(Expansion::first, three, Values{1., 2., 4.}, alike(3)));
}

// F. Anscombe, Graphs in statistical analysis, Am. Statistician 27 (1973) 17, first and second set: intercepts 3.0 with
// standard errors 1.1247 and 1.1253 (R, summary(lm(y1 ~ x1))); Student's 97.5 % quantile of nine degrees is 2.262157.
TEST(ErrorFit, IntervalOfAKnownOrderIsThatOfAnIntercept)
{
  const Values x{10, 8, 13, 9, 11, 14, 6, 4, 12, 7, 5};
  const Values first{8.04, 6.95, 7.58, 8.81, 8.33, 9.96, 7.24, 4.26, 10.84, 4.82, 5.68};
  const Values second{9.14, 8.14, 8.74, 8.77, 9.26, 8.10, 6.13, 3.10, 9.13, 7.26, 4.74};
  EXPECT_NEAR(fit_known_order(1., x, first).limit, 3.0001, 5e-5);
  EXPECT_NEAR(fit_known_order(1., x, first).half_interval, 2.262157 * 1.1247, 2e-4) << "half a unit of the last digit";
  EXPECT_NEAR(fit_known_order(1., x, second).limit, 3.0009, 5e-5);
  EXPECT_NEAR(fit_known_order(1., x, second).half_interval, 2.262157 * 1.1253, 2e-4);
  Values roots;
  for (const double each : x)
    roots.push_back(std::sqrt(each));
  EXPECT_NEAR(fit_known_order(2., roots, first).limit, 3.0001, 5e-5) << "the same line over h^2";
}

// The p-values are numpy's and scipy's (lstsq over 1, x, x ln x; stats.t). The second set is a parabola, and drawn to
// be taken for a line by all that a line's own fit tells.
TEST(ErrorFit, AnOrderThatTheValuesContradictIsRejected)
{
  const Values x{10, 8, 13, 9, 11, 14, 6, 4, 12, 7, 5};
  const Values first{8.04, 6.95, 7.58, 8.81, 8.33, 9.96, 7.24, 4.26, 10.84, 4.82, 5.68};
  const Values second{9.14, 8.14, 8.74, 8.77, 9.26, 8.10, 6.13, 3.10, 9.13, 7.26, 4.74};
  EXPECT_NEAR(fit_known_order(1., x, first).p_value, 0.497944, 1e-6);
  EXPECT_FALSE(fit_known_order(1., x, first).rejects_order());
  EXPECT_NEAR(fit_known_order(1., x, second).p_value, 4.9637e-9, 1e-12);
  EXPECT_TRUE(fit_known_order(1., x, second).rejects_order());
  // Tip peaks of prm/oblique.prm, mm, with particles 1.2 apart: order 0.92 by least squares.
  Values h{1.};
  while (h.size() < 7)
    h.push_back(1.2 * h.back());
  const Values tips{196.7, 198.1, 199.1, 200.1, 202.6, 204.8, 206.6};
  EXPECT_NEAR(fit_known_order(1., h, tips).p_value, 0.579065, 1e-6);
  EXPECT_NEAR(fit_known_order(2., h, tips).p_value, 0.010368, 1e-6);
  EXPECT_TRUE(std::isnan(fit_known_order(1., Values{1., 2., 3.}, Values{1., 2., 2.5}).p_value)) << "none to test it by";
  EXPECT_FALSE(fit_known_order(1., Values{1., 2., 3.}, Values{1., 2., 2.5}).rejects_order());
}

TEST(ErrorFit, OneInTwentyOfLaddersOfTheOrderIsRejected)
{
  std::mt19937               engine(1);
  std::normal_distribution<> scatter(0., 0.003);
  const Values               h{1., 1.2, 1.44, 1.728, 2.0736, 2.48832};
  constexpr int              n        = 4000;
  std::array<int, 2>         rejected = {0, 0}; // the right order, the wrong one
  for (int k = 0; k < n; ++k)
    {
      Values values = of_power(h, 1., 0.05, 1.);
      for (double &value : values)
        value += scatter(engine);
      for (const std::size_t wrong : {0u, 1u})
        if (fit_known_order(wrong == 0 ? 1. : 2., h, values).rejects_order())
          ++rejected[wrong];
    }
  EXPECT_NEAR(rejected[0] / double(n), 0.05, 3. * std::sqrt(0.05 * 0.95 / n)) << "three standard deviations of a share";
  EXPECT_GT(rejected[1], 4 * rejected[0]) << "a change of 0.07 shows the other order above scatter of 0.003";
}

// The tips reject order 2, not order 1: the hull ends where orders between are rejected.
TEST(ErrorFit, ARangeOfOrdersHasAllThatTheirIntervalsSpan)
{
  Values h{1.};
  while (h.size() < 7)
    h.push_back(1.2 * h.back());
  const Values        tips{196.7, 198.1, 199.1, 200.1, 202.6, 204.8, 206.6};
  const KnownOrderFit one = fit_known_order(1., h, tips), two = fit_known_order(2., h, tips);
  const KnownOrderFit low = fit_order_range({1., 1.}, h, tips), both = fit_order_range({1., 2.}, h, tips);
  EXPECT_EQ(low.limit, one.limit);
  EXPECT_EQ(low.half_interval, one.half_interval);
  EXPECT_FALSE(both.rejects_order());
  EXPECT_NEAR(both.limit - both.half_interval, one.limit - one.half_interval, 1e-12);
  EXPECT_LT(both.limit + both.half_interval, two.limit + two.half_interval) << "order 2 is rejected";
  EXPECT_GT(both.limit + both.half_interval, one.limit + one.half_interval);
  const KnownOrderFit wrong = fit_order_range({3., 4.}, h, tips);
  EXPECT_TRUE(wrong.rejects_order());
  EXPECT_GT(wrong.half_interval, 0.5 * (fit_known_order(4., h, tips).limit - fit_known_order(3., h, tips).limit));
}

// Orders 1, 1.5 and 2, which nobody knows but for their bounds.
TEST(ErrorFit, ARangeOfOrdersHoldsTheTruth)
{
  std::mt19937               engine(2);
  std::normal_distribution<> scatter(0., 1.);
  constexpr int              n = 400;
  for (const double s : {0.0005, 0.002, 0.01})
    for (const double p : {1., 1.5, 2.})
      {
        const Values h{1., 1.3, 1.69, 2.197, 2.8561};
        int          held = 0;
        for (int k = 0; k < n; ++k)
          {
            Values values = of_power(h, 1., 0.02, p);
            for (double &value : values)
              value += s * scatter(engine);
            const KnownOrderFit fit = fit_order_range({1., 2.}, h, values);
            held += std::abs(fit.limit - 1.) <= fit.half_interval ? 1 : 0;
          }
        EXPECT_GT(held / double(n), 0.93) << s << " " << p;
      }
}

TEST(ErrorFit, AKnownOrderLeavesNoIntervalOnItsPower)
{
  for (const double p : {1., 2.})
    {
      const Values        h{1., 1.2, 1.44, 1.728};
      const KnownOrderFit fit = fit_known_order(p, h, of_power(h, 3., -0.05, p));
      EXPECT_NEAR(fit.limit, 3., 1e-13) << "round-off of the values over how little sizes differ";
      EXPECT_NEAR(fit.half_interval, 0., 1e-12);
      EXPECT_EQ(fit.p_value, 1.) << "what is left is round-off";
    }
  EXPECT_THROW(fit_known_order(1., Values{1., 2.}, Values{1., 2.}), std::logic_error);
  EXPECT_THROW(fit_known_order(1., Values{1., 2., 3.}, Values{1., 2.}), std::logic_error);
  EXPECT_THROW(fit_known_order(0., Values{1., 2., 3.}, Values{1., 2., 3.}), std::logic_error);
}
