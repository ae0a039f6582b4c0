#include <birdstrike/material/plane_stress_return.h>

#include <gtest/gtest.h>

#include "titanium.h"

using namespace birdstrike;
using birdstrike::test::titanium;

namespace
{
  struct State
  {
    double stress[3] = {0., 0., 0.}, p = 0., yield = 0.;
  };

  void apply(State &s, const Hardening &h, const std::array<double, 3> &strain, const double dt = 1.)
  {
    if (s.yield == 0.)
      s.yield = compute_flow_stress(h, 0., 0., dt, 1.).value;
    const double e[3] = {strain[0], strain[1], strain[2]};
    add_plane_stress(titanium, e, s.stress);
    s.p += plane_stress_return(titanium, h, s.p, s.yield, 1., dt, s.stress).strain;
    s.yield = compute_flow_stress(h, s.p, 0., dt, 1.).value;
  }

  /// Uniaxial stress by choosing the lateral strain of every increment (secant on syy = 0).
  State pull(const Hardening &h, const double strain, const unsigned int n_steps, const double dt = 1.)
  {
    State state;
    for (unsigned int i = 0; i < n_steps; ++i)
      {
        double a = -0.3 * strain / n_steps, b = -0.55 * strain / n_steps, fa = 0.;
        for (unsigned int k = 0; k < 60; ++k)
          {
            State trial = state;
            apply(trial, h, {strain / n_steps, k == 0 ? a : b, 0.}, dt);
            const double f = trial.stress[1];
            if (k == 0)
              {
                fa = f;
                continue;
              }
            if (std::abs(f) < 1e-3 || f == fa)
              {
                state = trial;
                break;
              }
            const double next = b - f * (b - a) / (f - fa);
            a                 = b;
            fa                = f;
            b                 = next;
          }
      }
    return state;
  }

  Hardening make_hardening(const HardeningLaw law, const double modulus, const double exponent = 1.,
                           const double strain = 1.)
  {
    Hardening h;
    h.law      = law;
    h.yield    = 880e6;
    h.modulus  = modulus;
    h.exponent = exponent;
    h.strain   = strain;
    return h;
  }
} // namespace

TEST(PlaneStressReturn, UniaxialStressWithLinearHardening)
{
  // closed form: E_t = E H/(E + H), e = 0.05; one step or fifty: the path is proportional but for the elastic part
  const State s = pull(make_hardening(HardeningLaw::linear, 1.2e9), 0.05, 50);
  EXPECT_NEAR(s.stress[0], 930.191304e6, 930e6 * 1e-6);
  EXPECT_NEAR(s.p, 0.04182609, 0.04182609e-6 * 2.);
}

TEST(PlaneStressReturn, ShearYieldsAtVonMises)
{
  State s;
  apply(s, make_hardening(HardeningLaw::perfect, 0.), {0., 0., 0.1});
  EXPECT_NEAR(s.stress[2], 508.068e6, 1e3);
  EXPECT_EQ(s.stress[0], 0.);
}

TEST(PlaneStressReturn, TheStateLiesOnEveryCurve)
{
  // whatever the increment, a single return must satisfy the implicit equations: yield and normality
  const std::array<Hardening, 5> laws{
    make_hardening(HardeningLaw::perfect, 0.), make_hardening(HardeningLaw::linear, 1.2e9),
    make_hardening(HardeningLaw::swift, 0., 0.2, 0.01), make_hardening(HardeningLaw::voce, 200e6, 15.),
    make_hardening(HardeningLaw::johnson_cook, 331e6, 0.34)};
  for (Hardening h : laws)
    for (const double rate_factor : {0., 0.014})
      for (const double size : {0.008, 0.02, 0.3})
        {
          h.rate_factor         = rate_factor;
          const double dt       = 1e-6;
          const double e[3]     = {size, 0.2 * size, -0.7 * size};
          double       trial[3] = {0., 0., 0.}, s[3];
          add_plane_stress(titanium, e, trial);
          std::copy(trial, trial + 3, s);
          const double yield = compute_flow_stress(h, 0., 0., dt, 1.).value;
          const auto   step  = plane_stress_return(titanium, h, 0., yield, 1., dt, s);
          const double q     = von_mises_plane(s);
          ASSERT_GT(step.strain, 0.);
          EXPECT_NEAR(q / compute_flow_stress(h, 0., step.strain, dt, 1.).value, 1., 1e-12);
          // C^-1 (trial - s) = dp/q (sxx - syy/2, syy - sxx/2, 3 sxy)
          const double E = titanium.young, nu = titanium.poisson, G = titanium.shear_modulus();
          const double d[3] = {trial[0] - s[0], trial[1] - s[1], trial[2] - s[2]};
          const double x    = step.strain / q;
          EXPECT_NEAR((d[0] - nu * d[1]) / E, x * (s[0] - 0.5 * s[1]), 1e-12 * size);
          EXPECT_NEAR((d[1] - nu * d[0]) / E, x * (s[1] - 0.5 * s[0]), 1e-12 * size);
          EXPECT_NEAR(d[2] / G, x * 3. * s[2], 1e-12 * size);
        }
}

TEST(PlaneStressReturn, LiesOnACurveWithCowperAndSymonds)
{
  Hardening h        = make_hardening(HardeningLaw::curve, 0.);
  h.curve.segments   = {{{0., 0.005, 0.}, {0.005, 0.02, 3e9}, {0.025, 0.1, 2e8}}};
  h.curve.n_segments = 3;
  for (const double rate : {0., 40.4, 1e5})
    for (const double size : {0.0085, 0.012, 0.03, 0.3})
      {
        h.rate_law        = rate > 0. ? RateLaw::cowper_symonds : RateLaw::johnson_cook;
        h.reference_rate  = rate > 0. ? rate : 1.;
        h.rate_factor     = rate > 0. ? 1. : 0.;
        h.rate_exponent   = 5.;
        const double dt   = 1e-5;
        const double e[3] = {size, 0.2 * size, -0.7 * size};
        double       s[3] = {0., 0., 0.};
        add_plane_stress(titanium, e, s);
        const auto   step = plane_stress_return(titanium, h, 0., h.yield, 1., dt, s);
        const double p = step.strain, over = rate > 0. ? std::pow(p / (dt * rate), 0.2) : 0.;
        const double curve = h.yield + 3e9 * std::clamp(p - 0.005, 0., 0.02) + 2e8 * std::clamp(p - 0.025, 0., 0.1);
        ASSERT_GT(p, 0.);
        EXPECT_NEAR(von_mises_plane(s) / (curve * (1. + over)), 1., 1e-12) << rate << ' ' << size;
      }
}

TEST(PlaneStressReturn, JohnsonCookRateIsThatOfTheStep)
{
  Hardening h   = make_hardening(HardeningLaw::johnson_cook, 331e6, 0.34);
  h.rate_factor = 0.012;
  const State s = pull(h, 0.1, 20, 1e-6); // 5e3 /s
  // in the last step nearly all strain is plastic: rate = (de - ds/E)/dt
  const double expected = (h.yield + h.modulus * std::pow(s.p, 0.34)) * (1. + 0.012 * std::log(0.1 / 20. / 1e-6));
  EXPECT_NEAR(s.stress[0] / expected, 1., 1e-3) << "elastic share of the last step, about 2 % of the rate";
}

TEST(PlaneStressReturn, SteadyFlowHasTheStressOfItsRate)
{
  // in steady shear all strain is plastic, at rates below and above the reference
  Hardening h     = make_hardening(HardeningLaw::perfect, 0.);
  h.rate_factor   = 0.014;
  const double dt = 1e-7;
  for (const double rate : {0.3, 0.9, 1., 1.5, 10., 1e2, 1e3, 1e4, 1e5})
    {
      State state;
      state.stress[2] = 0.999 * 880e6 / std::sqrt(3.);
      double before = -1., grown = 0.;
      for (int k = 0; k < 20000 && std::abs(grown - rate * dt) > 1e-11 * rate * dt; ++k)
        {
          before = state.p;
          apply(state, h, {0., 0., std::sqrt(3.) * rate * dt}, dt);
          grown = state.p - before;
        }
      EXPECT_NEAR(von_mises_plane(state.stress) / (880e6 * (1. + 0.014 * std::log(std::max(rate, 1.)))), 1., 1e-10)
        << rate;
    }
}

TEST(PlaneStressReturn, LanesAgreeWithDoubles)
{
  const Hardening h = make_hardening(HardeningLaw::swift, 0., 0.2, 0.01);
  Lanes           s[3];
  double          e[3][n_lanes];
  for (std::size_t k = 0; k < n_lanes; ++k)
    for (int c = 0; c < 3; ++c)
      {
        e[c][k] = 1e9 * std::sin(1. + k + 2.3 * c);
        s[c][k] = e[c][k];
      }
  const auto step = plane_stress_return(titanium, h, Lanes(0.01), Lanes(0.9e9), Lanes(1.), 1., s);
  for (std::size_t k = 0; k < n_lanes; ++k)
    {
      double     one[3] = {e[0][k], e[1][k], e[2][k]};
      const auto single = plane_stress_return(titanium, h, 0.01, 0.9e9, 1., 1., one);
      EXPECT_NEAR(step.strain[k], single.strain, 1e-14);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(s[c][k], one[c], 1e-2) << "Pa, of 1e9: both have converged to 1e-13, lanes on";
    }
}
