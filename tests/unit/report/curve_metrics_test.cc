#include "report/measurement/curve_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace birdstrike
{
  namespace
  {
    /// Samples of f over [0, 1].
    template <class Function>
    std::vector<double> sample(const std::size_t n, const Function &f)
    {
      std::vector<double> y;
      for (std::size_t k = 0; k < n; ++k)
        y.push_back(f(double(k) / double(n - 1)));
      return y;
    }

    /// A swing that fades.
    double swing(const double t)
    {
      return std::exp(-2. * t) * std::sin(9. * t);
    }
  } // namespace

  TEST(CurveMetrics, ACurveAgreesWithItself)
  {
    const auto y       = sample(1001, swing);
    const auto figures = compute_sprague_geers(y, y);
    EXPECT_EQ(figures.magnitude, 0.);
    EXPECT_EQ(figures.phase, 0.);
    EXPECT_EQ(figures.comprehensive, 0.);
    const IsoRating rating = compute_iso_rating(y, y);
    EXPECT_EQ(rating.corridor, 1.);
    EXPECT_EQ(rating.phase, 1.);
    EXPECT_EQ(rating.magnitude, 1.);
    EXPECT_EQ(rating.slope, 1.);
    EXPECT_NEAR(rating.overall, 1., 1e-15);
    EXPECT_STREQ(rating.grade(), "excellent");
  }

  // Curves that correlate with what they are shifted by: which shift is best must not be a matter of round-off.
  TEST(CurveMetrics, CurvesThatAShiftLeavesAlikeAgreeWithThemselves)
  {
    const double tau = 2. * std::numbers::pi;
    for (const auto &y : {sample(1001, [](const double t) { return 0.1 * t; }),
                          sample(1001, [](const double t) { return std::exp(-3. * t); }),
                          sample(1001, [=](const double t) { return std::round(1e6 * std::sin(10. * tau * t)) / 1e6; }),
                          sample(801, [=](const double t) { return 0.3 * std::sin(8. * tau * t); })})
      for (const double factor : {1., 0.9})
        {
          auto computed = y;
          for (double &value : computed)
            value *= factor;
          const IsoRating rating = compute_iso_rating(y, computed);
          EXPECT_EQ(rating.phase, 1.) << y[1] << " times " << factor;
          if (factor == 1.)
            {
              EXPECT_NEAR(rating.overall, 1., 1e-15);
            }
        }
    for (const double level : {0.01, 0.03, 0.07, 1.})
      {
        EXPECT_EQ(compute_iso_rating(sample(300, [=](double) { return level; }), sample(300, swing)).phase, 1.)
          << level;
        EXPECT_EQ(compute_iso_rating(sample(300, swing), sample(300, [=](double) { return level; })).phase, 1.)
          << level;
      }
  }

  // M = factor - 1 whatever the shape, P = 0; both follow from the formulas.
  TEST(CurveMetrics, AFactorIsTheMagnitude)
  {
    const auto measured = sample(400, swing);
    for (const double factor : {0.5, 1.2, 3.})
      {
        const auto computed = sample(400, [factor](const double t) { return factor * swing(t); });
        const auto figures  = compute_sprague_geers(measured, computed);
        EXPECT_NEAR(figures.magnitude, factor - 1., 1e-14);
        EXPECT_NEAR(figures.phase, 0., 1e-14);
        EXPECT_NEAR(figures.comprehensive, std::abs(factor - 1.), 1e-14);
        EXPECT_EQ(compute_iso_rating(measured, computed).phase, 1.);
      }
  }

  // sin(w t) and sin(w t - a) over whole periods: int m c = cos(a) int m^2, so that P = a/pi and M = 0, trapezoids
  // being exact for trigonometric polynomials over whole periods.
  TEST(CurveMetrics, AShiftIsThePhase)
  {
    const double w        = 6. * std::numbers::pi;
    const auto   measured = sample(601, [w](const double t) { return std::sin(w * t); });
    for (const double shift : {0.1, 1., 2., std::numbers::pi})
      {
        const auto computed = sample(601, [=](const double t) { return std::sin(w * t - shift); });
        const auto figures  = compute_sprague_geers(measured, computed);
        EXPECT_NEAR(figures.magnitude, 0., 1e-13);
        EXPECT_NEAR(figures.phase, shift / std::numbers::pi, 1e-13);
      }
  }

  // A constant distance of a share e of the largest value gives ((0.5 - e)/0.45)^2 between the corridors, 1 within the
  // inner and 0 beyond the outer one.
  TEST(CurveMetrics, TheCorridorIsASquare)
  {
    const auto measured = sample(100, [](const double t) { return 2. * std::sin(std::numbers::pi * t); });
    double     largest  = 0.;
    for (const double y : measured)
      largest = std::max(largest, y);
    for (const auto &[e, expected] : {std::pair(0.04, 1.), {0.275, 0.25}, {0.41, 0.04}, {0.6, 0.}})
      {
        auto computed = measured;
        for (double &y : computed)
          y += e * largest;
        const IsoRating rating = compute_iso_rating(measured, computed);
        EXPECT_NEAR(rating.corridor, expected, 1e-12) << e;
        EXPECT_EQ(rating.phase, 1.) << "a constant does not change a correlation";
        EXPECT_NEAR(rating.slope, 1., 1e-12);
      }
  }

  // A pulse that comes n of N samples late, or early: 1 - n/(0.2 N), and once it is shifted back nothing is different.
  TEST(CurveMetrics, AShiftCostsItsShareOfAFifth)
  {
    const auto pulse = [](const double t) { return std::exp(-200. * (t - 0.5) * (t - 0.5)); };
    const auto at    = [&](const double late) {
      return sample(1000, [&](const double t) { return pulse(t - late / 999.); });
    };
    for (const double n : {50., -50., 120.})
      {
        const IsoRating rating = compute_iso_rating(at(0.), at(n));
        EXPECT_NEAR(rating.phase, 1. - std::abs(n) / 200., 1e-12) << n;
        EXPECT_NEAR(rating.magnitude, 1., 1e-9);
        EXPECT_NEAR(rating.slope, 1., 1e-9);
      }
    EXPECT_EQ(compute_iso_rating(at(0.), at(300.)).phase, 0.) << "more than a fifth";
  }

  // A factor of two: whatever the path of the warping, a plateau of 2 is 1 from one of 1, an error of 1 (score 0); of
  // 1.1 it is 0.1 (score 0.8). Slopes of factor f differ by |f - 1| of themselves: 1 - |f - 1|/2.
  TEST(CurveMetrics, FactorsCostMagnitudeAndSlope)
  {
    const auto plateau = sample(200, [](const double) { return 1.; });
    for (const auto &[factor, expected] : {std::pair(1.1, 0.8), {1.25, 0.5}, {2., 0.}})
      {
        const std::vector<double> computed(200, factor);
        EXPECT_NEAR(compute_iso_rating(plateau, computed).magnitude, expected, 1e-12);
        const auto ramp  = sample(200, [](const double t) { return t; });
        const auto steep = sample(200, [factor](const double t) { return factor * t; });
        EXPECT_NEAR(compute_iso_rating(ramp, steep).slope, 1. - (factor - 1.) / 2., 1e-12);
      }
  }

  TEST(CurveMetrics, RefuseWhatCannotBeCompared)
  {
    const std::vector<double> ten(10, 1.), nine(9, 1.), zero(10, 0.);
    EXPECT_THROW(compute_sprague_geers(ten, nine), std::invalid_argument);
    EXPECT_THROW(compute_iso_rating(nine, nine), std::invalid_argument);
    EXPECT_THROW(compute_sprague_geers(zero, ten), std::invalid_argument);
    EXPECT_EQ(compute_sprague_geers(ten, zero).magnitude, -1.) << "nothing was computed";
    EXPECT_EQ(compute_sprague_geers(ten, zero).phase, 0.5);
  }
} // namespace birdstrike
