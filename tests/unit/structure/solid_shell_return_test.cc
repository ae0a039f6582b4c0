#include "structure/elements/solid/solid_shell_return.h"
#include <birdstrike/material/radial_return.h>

#include <gtest/gtest.h>

#include <random>

namespace solid_shell_return_test
{
  using namespace birdstrike;

  namespace
  {
    const Elasticity elasticity{113.8e9, 0.342};

    std::vector<Hardening> some_laws()
    {
      std::vector<Hardening> laws(6);
      laws[1].law         = HardeningLaw::linear;
      laws[1].modulus     = 1.25e9;
      laws[2].law         = HardeningLaw::swift;
      laws[2].exponent    = 0.2;
      laws[3].law         = HardeningLaw::voce;
      laws[3].modulus     = 300e6;
      laws[3].exponent    = 20.;
      laws[4].law         = HardeningLaw::johnson_cook;
      laws[4].modulus     = 695e6;
      laws[4].exponent    = 0.36;
      laws[4].rate_factor = 0.011;
      laws[5]             = laws[1];
      laws[5].rate_factor = 0.05;
      for (Hardening &law : laws)
        law.reference_rate = 1e-3;
      return laws;
    }

    /// Points of a test, and the same with Cowper and Symonds' rate.
    std::vector<Hardening> curves()
    {
      std::vector<Hardening> laws(2);
      laws[0].law              = HardeningLaw::curve;
      laws[0].curve.segments   = {{{0., 0.004, 0.}, {0.004, 0.01, 2e10}, {0.014, 0.2, 5e8}}};
      laws[0].curve.n_segments = 3;
      laws[1]                  = laws[0];
      laws[1].rate_law         = RateLaw::cowper_symonds;
      laws[1].rate_factor      = 1.;
      laws[1].reference_rate   = 1300.;
      laws[1].rate_exponent    = 5.;
      return laws;
    }

    struct Sample
    {
      std::mt19937                           random{5};
      std::uniform_real_distribution<double> number{-1., 1.};
      double                                 operator()()
      {
        return number(random);
      }
    };
  } // namespace

  TEST(SolidShellReturn, IsTheRadialReturnForPointsThatAreAlike)
  {
    Sample     number;
    const auto rule = make_thickness_points(ThicknessRule::gauss, 5);
    for (const Hardening &hardening : some_laws())
      for (int sample = 0; sample < 200; ++sample)
        {
          double       s[6], p = sample % 3 ? 0.02 * std::abs(number()) : 0.;
          const double dt = 1e-6, yield = compute_flow_stress(hardening, p, 0., dt, 1.).value;
          for (double &component : s)
            component = 2e9 * std::abs(number()) * number();
          SolidShellReturn<double> section(elasticity, hardening, rule);
          for (auto &point : section.point)
            {
              point.trace   = s[0] + s[1] - 2. * s[2];
              point.rest    = 0.75 * (s[0] - s[1]) * (s[0] - s[1]) + 3. * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
              point.varying = 0.;
              point.plastic_strain = p;
              point.yield          = yield;
              point.softening      = 1.;
            }
          section.solve(dt, true);
          const double across   = s[2] + section.shift;
          const auto   expected = radial_return(elasticity, hardening, p, yield, 1., dt, s);
          EXPECT_NEAR(across, s[2], 1e-10 * 2e9);
          for (unsigned int k = 0; k < rule.n; ++k)
            {
              const auto &point = section.point[k];
              EXPECT_NEAR(point.chi * std::sqrt(section.square(point)), expected.strain, 1e-12);
              EXPECT_NEAR(point.trace_factor * section.shifted_trace(point), s[0] + s[1] - 2. * s[2], 1e-10 * 2e9);
            }
        }
  }

  namespace
  {
    // Any mixture of points, trials up to a hundred times the yield stress (twice, with a rate, whose threshold is a
    // kink, or a curve, which has some): on the yield surface where something flows, within it elsewhere; the pressure
    // is that of the trial, to round-off.
    void expect_points_where_they_belong(const std::vector<Hardening> &laws)
    {
      Sample     number;
      const auto rule      = make_thickness_points(ThicknessRule::gauss, 7);
      int        n_flowing = 0, n_resting = 0;
      for (const double poisson : {-0.5, 0., 0.3, 0.499})
        for (const Hardening &hardening : laws)
          for (int sample = 0; sample < 200; ++sample)
            {
              const Elasticity metal{113.8e9, poisson};
              const bool       is_curve = hardening.law == HardeningLaw::curve;
              const double     most     = is_curve ? 0.4 : hardening.rate_factor > 0. ? 1.1 : 3.;
              const double     size = std::pow(10., (is_curve ? 8.9 : 8.) + most * std::abs(number())), dt = 1e-6;
              SolidShellReturn<double> section(metal, hardening, rule);
              for (auto &point : section.point)
                {
                  point.trace          = size * number();
                  point.rest           = std::pow(size * number(), 2);
                  point.varying        = sample % 2 ? std::pow(size * number(), 2) : 0.;
                  point.plastic_strain = sample % 3 ? 0.02 * std::abs(number()) : 0.;
                  point.softening      = 1.;
                  point.yield          = compute_flow_stress(hardening, point.plastic_strain, 0., dt, 1.).value;
                }
              section.solve(dt, true);
              double pressure = 3. * section.shift;
              for (unsigned int k = 0; k < rule.n; ++k)
                {
                  const auto  &point = section.point[k];
                  const double q = std::sqrt(section.square(point)), strain = point.chi * q;
                  // of curves what a strain of 1e-12 makes is round-off: with Cowper and Symonds as much as 2 % of the
                  // stress
                  const double round_off = is_curve ? 1e-12 : 0.;
                  const auto   flow      = [&](const double of_step) {
                    return compute_flow_stress(hardening, point.plastic_strain, of_step, dt, 1.).value;
                  };
                  if (point.chi > 0.)
                    {
                      EXPECT_GT(q / flow(std::max(strain - round_off, 0.)), 1. - 1e-9) << size;
                    }
                  EXPECT_LT(q / flow(strain + round_off), 1. + 1e-9) << size;
                  ++(point.chi > 0. ? n_flowing : n_resting);
                  pressure += 0.5 * rule.weight[k] * (point.trace_factor * section.shifted_trace(point) - point.trace);
                }
              EXPECT_NEAR(pressure, 0., 1e-9 * size);
            }
      EXPECT_GT(n_flowing, 1000);
      EXPECT_GT(n_resting, 1000);
    }
  } // namespace

  TEST(SolidShellReturn, EveryPointEndsWhereItBelongs)
  {
    expect_points_where_they_belong(some_laws());
  }

  TEST(SolidShellReturn, EveryPointEndsOnACurve)
  {
    expect_points_where_they_belong(curves());
  }
} // namespace solid_shell_return_test
