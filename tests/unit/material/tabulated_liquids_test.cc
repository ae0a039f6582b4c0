#include "material/porous_liquid.h"
#include "material/pressure_table.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/material/equation_of_state.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  EquationOfState make_porous(const double porosity, const double density)
  {
    EosParameters parameters;
    parameters.type        = EosType::porous;
    parameters.porosity    = porosity;
    parameters.sound_speed = 1480.;
    parameters.check();
    return EquationOfState(parameters, density);
  }

  EquationOfState make_tabulated(const std::string &points, const double density = 950.)
  {
    EosParameters parameters;
    parameters.type           = EosType::tabulated;
    parameters.pressure_table = points;
    parameters.check();
    return EquationOfState(parameters, density);
  }

  std::string refusal(const std::string &points)
  {
    try
      {
        make_tabulated(points);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "accepted";
  }

  /// Simpson's rule on n intervals of [0, mu] for the integral of p/rho^2 d rho, J/kg.
  double integrate(const EquationOfState &eos, const double mu, const int n)
  {
    double sum = 0.;
    for (int k = 0; k <= n; ++k)
      {
        const double m = mu * k / n, weight = k == 0 || k == n ? 1. : k % 2 == 1 ? 4. : 2.;
        sum += weight * eos.pressure(m) / (eos.reference_density() * (1. + m) * (1. + m));
      }
    return sum * mu / (3. * n);
  }
} // namespace

// Shocks by bisection in the closed form, in decimals (tests/verification/reference/c1_porous_hugoniot.py).
TEST(PorousLiquid, ReproducesTheTabulatedHugoniotStates)
{
  std::ifstream file(BIRDSTRIKE_SOURCE_DIR "/tests/data/hugoniot_porous.csv");
  ASSERT_TRUE(file) << "missing hugoniot_porous.csv";
  std::string line;
  std::getline(file, line);
  int n_rows = 0;
  for (; std::getline(file, line); ++n_rows)
    {
      std::replace(line.begin(), line.end(), ',', ' ');
      std::istringstream row(line);
      double             porosity, density, v, ratio, p, shock, c1;
      row >> porosity >> density >> v >> ratio >> p >> shock >> c1;
      const EquationOfState eos   = make_porous(porosity, density);
      const HugoniotState   state = eos.hugoniot(v);
      EXPECT_NEAR(state.density_ratio, ratio, 1e-7 * ratio) << line;
      EXPECT_NEAR(state.pressure, p, 1e-6 * p) << line;
      EXPECT_NEAR(state.shock_speed, shock, 1e-6 * shock) << line;
      const double mu = state.density_ratio - 1.;
      EXPECT_NEAR(std::sqrt(eos.sound_speed_squared(mu, state.pressure)), c1, 1e-4 * c1)
        << line; // cubics: one order less
    }
  EXPECT_EQ(n_rows, 30);
}

TEST(PorousLiquid, TableIsWithinAMillionthOfTheClosedForm)
{
  for (const double porosity : {0., 1e-4, 0.02, 0.1, 0.5})
    {
      const PorousLiquid  liquid{porosity, 313e6, 7., 101325.};
      const PressureTable table       = liquid.tabulate();
      double              of_pressure = 0., of_slope = 0.;
      for (double p = 1e-3; liquid.at(p).mu < table.last_mu(); p *= 1.0037)
        {
          const auto exact = liquid.at(p);
          of_pressure      = std::max(of_pressure, std::abs(table.pressure(exact.mu) / p - 1.));
          of_slope         = std::max(of_slope, std::abs(table.slope(exact.mu) / exact.slope - 1.));
        }
      std::printf("  z = %-6g pressure %.1e, slope %.1e\n", porosity, of_pressure, of_slope);
      EXPECT_LT(of_pressure, 1e-6) << porosity;
      EXPECT_LT(of_slope, 2e-4) << porosity;
    }
}

// Wood's formula at rest: 1/(rho c^2) = (1 - z)/K_l + z/(gamma p0).
TEST(PorousLiquid, HasTheSoundSpeedOfABubblyLiquidAtRest)
{
  const double K = 1000. * 1480. * 1480.;
  for (const double z : {0., 1e-3, 0.1, 0.5})
    {
      const double density = (1. - z) * 1000. + z * 101325. / (287.05 * 288.15);
      const double exact   = std::sqrt(1. / (density * ((1. - z) / K + z / (1.4 * 101325.))));
      EXPECT_NEAR(make_porous(z, density).reference_sound_speed() / exact, 1., 1e-12) << z;
    }
}

TEST(PorousLiquid, LiquidDensityFollowsFromTheBirdsOrIsRefused)
{
  EosParameters parameters;
  parameters.type           = EosType::porous;
  parameters.liquid_density = 1000.;
  EXPECT_NO_THROW(EquationOfState(parameters, 900.));
  EXPECT_NO_THROW(EquationOfState(parameters, 905.)); // within a per cent
  try
    {
      EquationOfState(parameters, 950.);
      FAIL() << "a bird of 950 kg/m^3 is not water with 10 % of pores";
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("Bird/Density = 900.12"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("1055.4"), std::string::npos) << error.what();
    }
}

// The table stores exactly what its pressure does: Simpson's rule, whose own error at this fineness is below 1e-9 of
// the smooth pieces.
TEST(TabulatedLiquid, EnergyIsTheIntegralOfItsPressure)
{
  const EquationOfState porous = make_porous(0.1, 900.), drawn = make_tabulated("0: 0; 0.1: 1e8; 0.15: 3e8; 0.8: 9e9");
  for (const double mu : {-0.3, -0.01, 1e-3, 0.05, 0.1, 0.13, 0.3, 0.75, 1.1})
    {
      EXPECT_NEAR(porous.energy(mu) / integrate(porous, mu, 2000000), 1., 1e-9) << mu;
      EXPECT_NEAR(drawn.energy(mu) / integrate(drawn, mu, 2000000), 1., 1e-9) << mu;
    }
}

TEST(TabulatedLiquid, LanesAreDoublesAndTheSlopeIsThatOfThePressure)
{
  for (const EquationOfState &eos : {make_porous(0.1, 900.), make_tabulated("0: 0; 0.1: 1e8; 0.15: 3e8; 0.8: 9e9")})
    for (const double first : {-0.02, 0.09, 0.4, 2.5})
      {
        const Lanes mu([first](const auto k) { return first + 0.0171 * k; });
        const Lanes p = eos.pressure(mu), c2 = eos.sound_speed_squared(mu, p);
        for (std::size_t k = 0; k < n_lanes; ++k)
          {
            const double m = mu[k], step = 1e-6;
            EXPECT_EQ(p[k], eos.pressure(m));
            EXPECT_EQ(c2[k], eos.sound_speed_squared(m, eos.pressure(m)));
            const double slope =
              (eos.pressure(m + step) - eos.pressure(m - step)) / (2. * step * eos.reference_density());
            EXPECT_NEAR(c2[k], slope, 1e-5 * slope) << m; // central difference over a piece a hundred steps long
          }
      }
}

// Points of Murnaghan's law: shocks between them within the order of monotone cubics, four times less error at half the
// distance.
TEST(TabulatedLiquid, PointsOfMurnaghansLawAreThatLiquid)
{
  const EquationOfState murnaghan(EosParameters(), 950.);
  double                error[2];
  for (const int refinement : {0, 1})
    {
      const double step = refinement == 0 ? 0.02 : 0.01;
      std::string  points;
      for (int k = 0; k * step < 0.401; ++k)
        points += fmt::format("{}{:.17g}: {:.17g}", k == 0 ? "" : "; ", k * step, murnaghan.pressure(k * step));
      const EquationOfState table = make_tabulated(points);
      error[refinement]           = 0.;
      for (double v = 20.; v < 500.; v += 7.)
        error[refinement] =
          std::max(error[refinement], std::abs(table.hugoniot(v).pressure / murnaghan.hugoniot(v).pressure - 1.));
      EXPECT_NEAR(table.reference_sound_speed(), murnaghan.reference_sound_speed(), refinement == 0 ? 8. : 2.5);
      EXPECT_EQ(table.struck_sound_speed(177.4), table.reference_sound_speed());
    }
  std::printf("  largest error of a shock's pressure %.1e, %.1e\n", error[0], error[1]);
  EXPECT_LT(error[1], 1e-3);
  EXPECT_GT(error[0] / error[1], 3.);
}

// A table that is straight in p is the linear law, to the last digits, beyond its end and in tension too.
TEST(TabulatedLiquid, StraightPointsAreTheLinearLaw)
{
  const EquationOfState table = make_tabulated("0: 0; 0.03: 66e6; 0.1: 220e6; 0.25: 550e6");
  EosParameters         parameters;
  parameters.type = EosType::linear;
  const EquationOfState linear(parameters, 950.);
  for (const double mu : {-0.2, 0.01, 0.1, 0.2, 0.6})
    {
      EXPECT_NEAR(table.pressure(mu) / linear.pressure(mu), 1., 1e-13) << mu;
      EXPECT_NEAR(table.energy(mu) / linear.energy(mu), 1., 1e-10) << mu; // the closed form loses digits
    }
}

// Whatever points are accepted, no pressure falls: a slope of zero would be a liquid without sound.
TEST(TabulatedLiquid, StaysMonotoneBetweenUnevenPoints)
{
  for (const char *points : {"0: 0; 1e-6: 1; 0.3: 1e9", "0: 0; 0.3: 1e5; 0.3000001: 1e9; 0.5: 2e9",
                             "0: 0; 0.5: 1e6; 0.6: 9e9", "0: 0; 0.1: 1e8; 0.2: 1.9e8; 0.3: 1.2e9", "0: 0; 1: 1"})
    {
      const EquationOfState eos = make_tabulated(points);
      for (double mu = -0.1; mu < 1.2; mu += 1e-4)
        {
          EXPECT_GT(eos.pressure(mu + 1e-4), eos.pressure(mu)) << points << " at " << mu;
          EXPECT_GT(eos.sound_speed_squared(mu, 0.), 0.) << points << " at " << mu;
        }
    }
}

TEST(TabulatedLiquid, RefusesPointsThatAreNoLiquid)
{
  EXPECT_NE(refusal("").find("0 points"), std::string::npos) << refusal("");
  EXPECT_NE(refusal("0: 0").find("1 points"), std::string::npos);
  EXPECT_NE(refusal("0.1: 0; 0.2: 1e8").find("Begin with '0: 0'"), std::string::npos);
  EXPECT_NE(refusal("0: 1e5; 0.2: 1e8").find("Begin with '0: 0'"), std::string::npos);
  EXPECT_NE(refusal("0: 0; 0.2: 1e8; 0.1: 2e8").find("must grow"), std::string::npos);
  EXPECT_NE(refusal("0: 0; 0.1: 1e8; 0.2: 1e8").find("must grow"), std::string::npos);
  EXPECT_NE(refusal("0: 0; 0.1: 1e8; 0.2: 1.2e8").find("softens"), std::string::npos)
    << refusal("0: 0; 0.1: 1e8; 0.2: 1.2e8");
  EXPECT_NE(refusal("0: 0; 0.1: nan").find("Pressure table"), std::string::npos);
  EXPECT_EQ(refusal("0: 0; 0.1: 1e8; 0.2: 1.9e8"), "accepted");
}

TEST(TabulatedLiquid, SaysThatATableEndsBeforeTheShock)
{
  const EquationOfState eos = make_tabulated("0: 0; 0.05: 1.3e8");
  EXPECT_NO_THROW(eos.hugoniot(80.));
  try
    {
      eos.hugoniot(177.4);
      FAIL() << "the shock lies beyond the table";
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("it ends at 0.05"), std::string::npos) << error.what();
    }
}

// What contact is told of a liquid that is soft until it is struck carries the shock of the strike exactly.
TEST(PorousLiquid, StruckSoundSpeedAndSlopeCarryTheShock)
{
  for (const double v : {20., 116., 177.4, 400.})
    {
      const EquationOfState eos = make_porous(0.1, 900.);
      const double          c   = eos.struck_sound_speed(v);
      EXPECT_NEAR(900. * v * (c + eos.hugoniot_slope(v) * v) / eos.hugoniot(v).pressure, 1., 1e-9);
      EXPECT_NEAR(c / eos.hugoniot(v).shock_speed, 0.5, 1e-9);
    }
}
