#include "../record.h"
#include "strike_harness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace birdstrike;
using namespace birdstrike::test;

namespace
{
  constexpr double mass = 0.1005, density = 950.;

  double diameter()
  {
    return std::cbrt(2. * mass / (std::numbers::pi * density)); // L = 2 D
  }

  Strike strike_rigid_plate(const double speed, const double n_across, const std::vector<std::string> &more = {})
  {
    std::vector<std::string> overrides{"Bird/Velocity=0,0," + std::to_string(speed),
                                       "Bird/Particle spacing=" + std::to_string(diameter() / n_across),
                                       "Time/End time=" + std::to_string(1.3 * 2. * diameter() / speed)};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return run_shipped("rigid-plate.prm", overrides);
  }

  void expect_jet_theory(const double speed, const double n_across, const double gauge_tolerance)
  {
    const Strike run  = strike_rigid_plate(speed, n_across);
    const double area = 0.25 * std::numbers::pi * diameter() * diameter(), duration = 2. * diameter() / speed;

    EXPECT_GE(run.summary.number("contact/impulse/2") / (mass * speed), 0.97);
    EXPECT_LE(run.summary.number("contact/impulse/2") / (mass * speed), 1.02);

    const double force = mean_over(run.curves, "contact_force_z", 0.35 * duration, 0.65 * duration);
    EXPECT_NEAR(force / (density * area * speed * speed), 1., 0.10);

    const double stagnation = mean_over(run.curves, "pressure_centre", 0.35 * duration, 0.65 * duration);
    EXPECT_NEAR(stagnation / (0.5 * density * speed * speed), 1., gauge_tolerance);

    EXPECT_LT(run.summary.number("contact/max_penetration_over_spacing"), 0.5);
    EXPECT_LT(run.summary.number("energy/max_relative_error"), 4e-3); // found 0.15 to 0.23 %
    EXPECT_LT(run.summary.number("momentum/max_relative_error"), 1e-10);
    EXPECT_EQ(run.summary.number("steps/blade"), 0u); // no element exists
  }
} // namespace

// Bird on a rigid plate at D/dx = 12 and 16. Impulse: all of m v, nothing rebounds (bounds 0.97 to 1.02; a rebound
// would pass 1.05). Steady force rho A v^2 within 10 % and stagnation pressure rho v^2 / 2 within 15 % (incompressible
// jet theory, Wilbeck 1978), the pressure averaged over 0.6 of the radius and 0.3 L/v: a smaller gauge holds too few
// particles at this spacing (at D/dx = 12 and half the radius the mean still scatters by 15 %, and a single gauge is
// given 30 %).
class RigidPlateStrike : public testing::TestWithParam<double>
{
};

TEST_P(RigidPlateStrike, ImpulseSteadyForceAndStagnationPressure)
{
  for (const auto &[n_across, gauge_tolerance] : {std::pair{12., 0.30}, {16., 0.15}})
    {
      SCOPED_TRACE(n_across);
      expect_jet_theory(GetParam(), n_across, gauge_tolerance);
    }
}

INSTANTIATE_TEST_SUITE_P(Speeds, RigidPlateStrike, testing::Values(100., 177.4, 300.));

// Coarse particles feel the first shock at once, which makes energy where it is not foreseen (bird.h): 2.7 % with this
// liquid and spacing, and impulses that differed by 2.4 % between these Courant numbers. What is left is a tenth of it.
TEST(RigidPlateStrike, FirstShockOfACoarseBirdMakesNoEnergy)
{
  const auto strike = [](const std::string &courant_number) {
    return run_shipped("rigid-plate.prm",
                       {"Bird/Velocity=0,0,100", "Bird/Particle spacing=0.008", "Time/End time=0.2e-3",
                        "Bird/Equation of state/Type=linear", "Bird/Courant number=" + courant_number});
  };
  const Strike run = strike("0.35"), finer = strike("0.25");
  EXPECT_LT(std::abs(run.summary.number("energy/error_origins/bird")), 3e-3 * run.summary.number("energy/initial"));
  EXPECT_LT(run.summary.number("energy/max_relative_error"), 3e-3);
  EXPECT_NEAR(run.summary.number("contact/impulse/2") / finer.summary.number("contact/impulse/2"), 1., 3e-3);
}

// Oblique, frictionless: no tangential impulse, and the normal one is m v sin(theta).
TEST(RigidPlateStrike, ObliqueStrikeIsFrictionless)
{
  const double speed = 302.1, angle = 36.4 * std::numbers::pi / 180.;
  const Strike run = strike_rigid_plate(
    177.4, 12.,
    {"Bird/Velocity=0," + std::to_string(speed * std::cos(angle)) + "," + std::to_string(speed * std::sin(angle))});
  const auto impulse = run.summary.json.at("contact").at("impulse").get<std::array<double, 3>>();
  EXPECT_NEAR(impulse[2] / (mass * speed * std::sin(angle)), 1., 0.03);
  EXPECT_LT(std::hypot(impulse[0], impulse[1]) / impulse[2], 1e-3);
}

// A jet on a free rigid plate of the blade's mass: quasi-steady plate speed v (1 - exp(-m/M)) = 31.0 m/s when the bird
// is consumed; at 0.7 ms its tail still pushes (0.950), from 1 ms on it has (0.964). A particle bird has a shock,
// spreads and bulks: 5 % of the quasi-steady value.
TEST(RigidPlateStrike, FreePlateTakesTheMomentumOfAJet)
{
  const Strike run = strike_rigid_plate(
    177.4, 12., {"Blade/Rigid/Motion=free along normal", "Blade/Rigid/Mass=0.5233", "Time/End time=1e-3"});
  const double speed = run.curves.at("blade_momentum_z").back() / 0.5233;
  EXPECT_NEAR(speed / 30.998, 1., 0.05);
  EXPECT_LT(run.summary.number("momentum/max_relative_error"), 1e-10);
}

// What the slices of one bird leave on the plate, cut across its axis or at 45 degrees to it, sums to what the whole
// bird leaves: 1.6 and 0.9 % more with particles of 4 mm, for every part bounces a little by itself (5 mm, three parts:
// 5
// %). Masses make up the bird's.
TEST(RigidPlate, SlicesOfABirdSumToTheWhole)
{
  const auto strike = [](std::vector<std::string> more) {
    more.insert(more.begin(), {"Bird/Particle spacing=0.004", "Time/End time=1.2e-3"});
    return run_shipped("rigid-plate.prm", more);
  };
  const double whole = strike({}).summary.number("contact/impulse/2");
  for (const char *normal : {"0, 0, 1", "1, 0, 1"})
    {
      double impulse = 0., sum = 0.;
      for (const char *between : {"-1, 0", "0, 1"})
        {
          const Strike part =
            strike({"Bird/Slice/Between=" + std::string(between), "Bird/Slice/Normal=" + std::string(normal)});
          impulse += part.summary.number("contact/impulse/2");
          sum += part.summary.number("bird/mass");
        }
      EXPECT_NEAR(sum, mass, 1e-12 * mass) << normal;
      record(normal, impulse / whole);
      EXPECT_NEAR(impulse / whole, 1., 0.025) << normal;
    }
}
