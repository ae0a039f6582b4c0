#include <birdstrike/material/radial_return.h>

#include <gtest/gtest.h>

#include <cmath>

#include "titanium.h"

using namespace birdstrike;
using birdstrike::test::titanium;

namespace
{
  const Hardening perfect; // 880 MPa

  struct Point
  {
    double stress[6] = {}, plastic_strain = 0.;

    PlasticIncrement<double> strain(const Hardening &h, const double (&increment)[6], const double dt = 1.)
    {
      const double yield = compute_flow_stress(h, plastic_strain, 0., dt, 1.).value;
      add_elastic_stress(titanium, increment, stress);
      const auto step = radial_return(titanium, h, plastic_strain, yield, 1., dt, stress);
      plastic_strain += step.strain;
      return step;
    }
  };
} // namespace

TEST(RadialReturn, UniaxialStrain)
{
  Point point;
  point.strain(perfect, {1.03775e-2, 0., 0., 0., 0., 0.});
  EXPECT_NEAR(point.stress[0], 1832.405e6, 2e4) << "Hugoniot elastic limit, strain given to six digits";
  point = Point();
  for (int i = 0; i < 40; ++i)
    point.strain(perfect, {0.02 / 40, 0., 0., 0., 0., 0.});
  EXPECT_NEAR(point.stress[0], 2987.5105e6, 2987.5e6 * 1e-6);
  EXPECT_NEAR(point.stress[1], 2107.5105e6, 2107.5e6 * 1e-6);
}

TEST(RadialReturn, UniaxialStress)
{
  // H = 1.2 GPa: E_t = 1.187478 GPa; at 5 % of strain 930.191304 MPa and a plastic strain of 0.04182609
  Hardening linear;
  linear.law     = HardeningLaw::linear;
  linear.modulus = 1.2e9;
  Point     point;
  const int n = 50;
  for (int i = 0; i < n; ++i)
    {
      // the lateral strain that leaves no lateral stress, by secants
      double lateral[2] = {-0.342 * 0.05 / n, -0.5 * 0.05 / n}, stress[2];
      Point  trial[2];
      for (int k = 0; k < 30; ++k)
        {
          for (int side = k == 0 ? 0 : 1; side < 2; ++side)
            {
              trial[side] = point;
              trial[side].strain(linear, {0.05 / n, lateral[side], lateral[side], 0., 0., 0.});
              stress[side] = trial[side].stress[1];
            }
          if (std::abs(stress[1]) < 1e-3)
            break;
          const double next = lateral[1] - stress[1] * (lateral[1] - lateral[0]) / (stress[1] - stress[0]);
          lateral[0]        = lateral[1];
          stress[0]         = stress[1];
          lateral[1]        = next;
        }
      point = trial[1];
    }
  EXPECT_NEAR(point.stress[0] / 930.191304e6, 1., 1e-6);
  EXPECT_NEAR(point.plastic_strain / 0.04182609, 1., 1e-6);
}

TEST(RadialReturn, ShearYieldsAtTheFlowStressOverRootThree)
{
  Point point;
  point.strain(perfect, {0., 0., 0., 0.05, 0., 0.});
  EXPECT_NEAR(point.stress[3], 508.068e6, 508.068e6 * 1e-6);
  EXPECT_EQ(point.stress[0], 0.);
}

TEST(RadialReturn, MeetsEveryHardeningCurve)
{
  Hardening h;
  h.yield                = 880e6;
  h.modulus              = 200e6;
  h.exponent             = 0.3;
  h.strain               = 0.01;
  const double strain[6] = {0.01, -0.003, 0.02, 0.004, 0.001, -0.002};
  for (const auto law : {HardeningLaw::linear, HardeningLaw::swift, HardeningLaw::voce, HardeningLaw::johnson_cook})
    for (const double rate_factor : {0., 0.03})
      {
        h.law         = law;
        h.rate_factor = rate_factor;
        Point        point;
        const double dt   = 1e-5;
        const auto   step = point.strain(h, strain, dt);
        const double p    = step.strain;
        const double q    = law == HardeningLaw::linear  ? 880e6 + 200e6 * p
                            : law == HardeningLaw::swift ? 880e6 * std::pow(1. + p / 0.01, 0.3)
                            : law == HardeningLaw::voce  ? 880e6 + 200e6 * (1. - std::exp(-0.3 * p))
                                                         : 880e6 + 200e6 * std::pow(p, 0.3);
        EXPECT_GT(p, 0.005);
        EXPECT_NEAR(von_mises(point.stress) / (q * (1. + rate_factor * std::log(p / dt))), 1., 1e-12) << int(law);
      }
}

TEST(RadialReturn, FollowsACurveAndCowperAndSymonds)
{
  // a level stretch, a steep one and the constant end; steps that end in each, begin at none of its corners
  Hardening h;
  h.law              = HardeningLaw::curve;
  h.yield            = 300e6;
  h.curve.segments   = {{{0., 0.01, 0.}, {0.01, 0.02, 4e9}, {0.03, 0.2, 1e8}}};
  h.curve.n_segments = 3;
  const auto curve   = [](const double p) {
    return p < 0.01 ? 300e6 : p < 0.03 ? 300e6 + 4e9 * (p - 0.01) : 380e6 + 1e8 * std::min(p - 0.03, 0.2);
  };
  for (const double size : {1e-3, 3e-3, 0.01, 0.05, 0.4})
    for (const double rate : {0., 40.4, 6500.})
      {
        h.rate_law       = rate > 0. ? RateLaw::cowper_symonds : RateLaw::johnson_cook;
        h.reference_rate = rate > 0. ? rate : 1.;
        h.rate_factor    = rate > 0. ? 1. : 0.;
        h.rate_exponent  = rate > 100. ? 4. : 5.;
        Point        point;
        const double dt = 1e-6;
        double       p  = 0.;
        for (int k = 0; k < 12; ++k)
          {
            const double strain[6] = {size, -0.3 * size, -0.4 * size, 0.4 * size, 0.1 * size, -0.2 * size};
            const double dp        = point.strain(h, strain, dt).strain;
            p += dp;
            const double over = rate > 0. && dp > 0. ? std::pow(dp / (dt * rate), 1. / h.rate_exponent) : 0.;
            if (dp > 0.)
              {
                EXPECT_NEAR(von_mises(point.stress) / (curve(p) * (1. + over)), 1., 1e-12)
                  << size << ' ' << rate << ' ' << k;
              }
          }
        EXPECT_GT(p, 0.);
      }
}

TEST(RadialReturn, SteadyFlowHasTheStressOfItsRate)
{
  // In steady shear all strain is plastic: the equivalent rate is that of the strain, below and above the reference.
  Hardening h;
  h.rate_factor   = 0.014;
  const double dt = 1e-7;
  for (const double rate : {0.3, 0.9, 1., 1.5, 10., 1e2, 1e3, 1e4, 1e5})
    {
      Point point;
      point.stress[3] = 0.999 * 880e6 / std::sqrt(3.);
      PlasticIncrement<double> step{0., 0., 0.};
      for (int k = 0; k < 20000 && std::abs(step.strain - rate * dt) > 1e-11 * rate * dt; ++k)
        {
          step                 = point.strain(h, {0., 0., 0., 0.5 * std::sqrt(3.) * rate * dt, 0., 0.}, dt);
          const double reached = step.strain > 0. ? step.stress : von_mises(point.stress);
          ASSERT_NEAR(von_mises(point.stress) / reached, 1., 3e-13) << "strain and stress of one solution";
        }
      EXPECT_NEAR(von_mises(point.stress) / (880e6 * (1. + 0.014 * std::log(std::max(rate, 1.)))), 1., 1e-10) << rate;
    }
}

TEST(RadialReturn, LanesThatDoNotYieldKeepTheirStress)
{
  Lanes stress[6]    = {0., 0., 0., 0., 0., 0.};
  stress[0]          = Lanes([](const auto k) { return k % 2 == 0 ? 500e6 : 1500e6; });
  const Lanes before = stress[0];
  const auto  step   = radial_return(titanium, perfect, Lanes(0.), Lanes(880e6), Lanes(1.), 1., stress);
  for (std::size_t k = 0; k < n_lanes; ++k)
    if (k % 2 == 0)
      {
        EXPECT_EQ(lane(step.strain, k), 0.);
        EXPECT_EQ(lane(stress[0], k), lane(before, k));
      }
    else
      {
        double alone[6] = {lane(before, k), 0., 0., 0., 0., 0.};
        EXPECT_EQ(lane(step.strain, k), radial_return(titanium, perfect, 0., 880e6, 1., 1., alone).strain);
        EXPECT_NEAR(lane(von_mises(stress), k) / 880e6, 1., 1e-14);
      }
}

TEST(HughesWinget, AFullTurnGivesTheStressBack)
{
  double       stress[6] = {3., 5., -1., 1., 0.5, -2.};
  const double start[6]  = {3., 5., -1., 1., 0.5, -2.};
  // the midpoint displacement gradient of a turn by a is antisymmetric with 2 tan(a/2)
  Matrix3<double>       w    = Matrix3<double>::Zero();
  const Vector3<double> axis = Vector3<double>(1., 2., -2.) / 3. * 2. * std::tan(0.5 * 10. * std::acos(-1.) / 180.);
  w << 0., -axis[2], axis[1], axis[2], 0., -axis[0], -axis[1], axis[0], 0.;
  const Vector3<double> spin = compute_half_spin(w);
  for (int i = 0; i < 36; ++i)
    {
      double strain[6];
      compute_turned_strain(w, spin, strain);
      for (const double e : strain)
        EXPECT_EQ(e, 0.);
      rotate_hughes_winget(spin, stress);
    }
  for (int c = 0; c < 6; ++c)
    EXPECT_NEAR(stress[c], start[c], 1e-12);
}

TEST(HughesWinget, ElasticSimpleShearIsJaumannsToSecondOrder)
{
  // G sin(gamma), G (1 - cos(gamma))
  const double G     = titanium.shear_modulus();
  const auto   error = [G](const int n, const double gamma) {
    double          stress[6] = {}, strain[6];
    Matrix3<double> gradient  = Matrix3<double>::Zero();
    gradient(0, 1)            = gamma / n;
    const auto spin           = compute_half_spin(gradient);
    for (int i = 0; i < n; ++i)
      {
        compute_turned_strain(gradient, spin, strain);
        rotate_hughes_winget(spin, stress);
        add_elastic_stress(titanium, strain, stress);
      }
    return std::hypot(stress[3] / G - std::sin(gamma), stress[0] / G - (1. - std::cos(gamma)));
  };
  for (const double gamma : {0.5, 1., std::acos(-1.)})
    {
      EXPECT_LT(error(2000, gamma), 1e-6);
      EXPECT_NEAR(error(50, gamma) / error(100, gamma), 4., 0.1);
    }
}
