#include <birdstrike/core/errors.h>
#include <birdstrike/material/equation_of_state.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  EquationOfState make_liquid(const std::string &type)
  {
    EosParameters parameters;
    parameters.type = eos_types().at(type);
    return EquationOfState(parameters, 950.);
  }
} // namespace

// Exact Rankine-Hugoniot states of three laws at 13 speeds, tabulated by an independent script to 6 or 5 digits.
TEST(EquationOfState, ReproducesTheTabulatedHugoniotStates)
{
  std::ifstream file(BIRDSTRIKE_SOURCE_DIR "/tests/data/hugoniot.csv");
  ASSERT_TRUE(file) << "missing hugoniot.csv";
  std::string line;
  std::getline(file, line);
  int n_rows = 0;
  for (; std::getline(file, line); ++n_rows)
    {
      std::replace(line.begin(), line.end(), ',', ' ');
      std::istringstream row(line);
      std::string        law;
      double             v, ratio, p_mpa, shock, shock_lab, c1;
      row >> law >> v >> ratio >> p_mpa >> shock >> shock_lab >> c1;
      const EquationOfState eos   = make_liquid(law);
      const HugoniotState   state = eos.hugoniot(v);
      // half a unit of the table's last digit
      EXPECT_NEAR(state.density_ratio, ratio, 6e-7) << line;
      EXPECT_NEAR(state.pressure, p_mpa * 1e6, 600.) << line;
      EXPECT_NEAR(state.shock_speed, shock, 6e-3) << line;
      const double mu = state.density_ratio - 1.;
      EXPECT_NEAR(std::sqrt(eos.sound_speed_squared(mu, eos.pressure(mu))), c1, 6e-3) << line;
    }
  EXPECT_EQ(n_rows, 39);
}

// By construction of the law, U_s = c0 + k v exactly.
TEST(EquationOfState, LinearShockLawReturnsItsOwnLine)
{
  const EquationOfState eos = make_liquid("us-up");
  for (const double v : {10., 177.4, 500.})
    {
      EXPECT_NEAR(eos.hugoniot(v).shock_speed, 1482.9 + 2. * v, 1e-8 * 1482.9);
      EXPECT_NEAR(eos.hugoniot_slope(v), 2., 1e-7);
    }
}

TEST(EquationOfState, LanesAgreeWithDoublesAndSoundSpeedIsTheSlope)
{
  for (const char *type : {"linear", "murnaghan", "polynomial", "us-up"})
    {
      const EquationOfState eos = make_liquid(type);
      const Lanes           mu([](const auto k) { return -0.02 + 0.0371 * k; });
      const Lanes           p = eos.pressure(mu), c2 = eos.sound_speed_squared(mu, p);
      for (std::size_t k = 0; k < n_lanes; ++k)
        {
          const double m = mu[k], step = 1e-6;
          EXPECT_NEAR(p[k], eos.pressure(m), 1e-14 * std::abs(eos.pressure(m))) << type;
          const double slope = (eos.pressure(m + step) - eos.pressure(m - step)) / (2. * step * 950.);
          // central difference: error ~ p'''step^2 and round-off ~ 1e-16 p/step
          EXPECT_NEAR(c2[k], slope, 1e-7 * slope) << type;
        }
    }
}

// rho0 c0^2 mu must keep all digits at mu = 1e-12, where (1 + mu)^gamma - 1 would keep four.
TEST(EquationOfState, MurnaghanKeepsItsDigitsNearZero)
{
  EXPECT_NEAR(make_liquid("murnaghan").pressure(1e-12), 128e6 * 7.98 * 1e-12, 1e-14);
}

TEST(EquationOfState, RefusesAnUnknownLawAndASofteningOne)
{
  EXPECT_THROW(make_liquid("magic"), std::out_of_range);
  EosParameters parameters;
  parameters.type        = EosType::us_up;
  parameters.shock_slope = 0.1;
  EXPECT_THROW(parameters.check(), InputError);
}

// e(mu) = integral of p/rho^2 d rho against Simpson's rule on 2000 intervals, whose own error is below 1e-12 here. Both
// signs: below zero polynomial and us-up go on with their slope.
TEST(EquationOfState, EnergyIsTheIntegralOfItsPressure)
{
  for (const std::string type : {"linear", "murnaghan", "polynomial", "us-up"})
    for (const double mu : {-0.3, -0.01, 1e-3, 0.05, 0.3, 0.8})
      {
        if (type == "us-up" && mu > 0.5)
          continue; // near the pole, mu = 1 at k = 2, Simpson's rule needs more
        const EquationOfState eos = make_liquid(type);
        const int             n   = 2000;
        double                sum = 0.;
        for (int k = 0; k <= n; ++k)
          {
            const double m = mu * k / n, weight = k == 0 || k == n ? 1. : k % 2 == 1 ? 4. : 2.;
            sum += weight * eos.pressure(m) / (950. * (1. + m) * (1. + m));
          }
        EXPECT_NEAR(eos.energy(mu) / (sum * mu / (3. * n)), 1., 1e-9) << type << " " << mu;
        EXPECT_GT(eos.energy(mu), 0.);
      }
}

TEST(EquationOfState, EnergyOfAMurnaghanLawWithExponentOneIsTheLinearOne)
{
  EosParameters parameters;
  parameters.murnaghan_exponent = 1.;
  parameters.murnaghan_modulus  = parameters.bulk_modulus;
  const EquationOfState murnaghan(parameters, 950.);
  EXPECT_NEAR(murnaghan.energy(0.1) / make_liquid("linear").energy(0.1), 1., 1e-12);
  EXPECT_NEAR(make_liquid("linear").energy(1e-3) / (0.5 * 2.2e9 / 950. * 1e-6), 1., 2e-3)
    << "K mu^2/2 to first order in mu";
}
