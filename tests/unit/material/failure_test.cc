#include <birdstrike/core/errors.h>
#include <birdstrike/material/metal_parameters.h>
#include <birdstrike/material/plane_stress_return.h>
#include <birdstrike/material/radial_return.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace birdstrike;

namespace
{
  /// Constants that Johnson & Cook (1985, table 1) print for 4340 steel, and what heats it.
  Failure steel_4340()
  {
    Failure failure;
    failure.law = FailureLaw::johnson_cook;
    failure.d   = {{0.05, 3.44, -2.12, 0.002, 0.61}};
    return failure;
  }

  Hardening heated()
  {
    Hardening h;
    h.heat_capacity       = 477.;
    h.room_temperature    = 293.;
    h.melting_temperature = 1793.;
    return h;
  }

  /// One plastic step of 1e-3 in 1e-6 s (1000/s) at a triaxiality.
  PlasticStep<double> at_triaxiality(const double triaxiality, const double temperature = 293.)
  {
    return {1e-3, triaxiality * 800e6, 800e6, temperature, 1e-6};
  }
} // namespace

// By hand: at one per second and room temperature e_f = 0.05 + 3.44 exp(-2.12 s*); tension 1/3, shear 0, compression
// -1/3, biaxial tension 2/3. Eight digits of the exponentials.
TEST(Failure, JohnsonCookStrainFollowsTheTriaxiality)
{
  const Failure f = steel_4340();
  EXPECT_NEAR(compute_failure_strain(f, 0., 1., 0.), 3.49, 1e-12);
  EXPECT_NEAR(compute_failure_strain(f, 1. / 3., 1., 0.), 0.05 + 3.44 * 0.49328575, 1e-7);
  EXPECT_NEAR(compute_failure_strain(f, -1. / 3., 1., 0.), 0.05 + 3.44 * 2.02722258, 1e-7);
  EXPECT_NEAR(compute_failure_strain(f, 2. / 3., 1., 0.), 0.05 + 3.44 * 0.24333083, 1e-7);
  EXPECT_GT(compute_failure_strain(f, -1. / 3., 1., 0.), compute_failure_strain(f, 1. / 3., 1., 0.))
    << "tension is the brittle side: positive mean stress, negative D3";
  EXPECT_EQ(compute_failure_strain(f, 5., 1., 0.), compute_failure_strain(f, 1.5, 1., 0.)) << "the law ends at 1.5";
  EXPECT_EQ(compute_failure_strain(f, -1e6, 1., 0.), compute_failure_strain(f, -1.5, 1., 0.)) << "no overflow";
}

// 1 + 0.002 ln(1000) = 1.01381551, T* = (1043 - 293)/(1793 - 293) = 1/2, hence 1 + 0.61/2 = 1.305
TEST(Failure, RateAndTemperatureMultiply)
{
  const Failure f = steel_4340();
  EXPECT_NEAR(compute_failure_strain(f, 0., 1000., 0.5), 3.49 * 1.01381551 * 1.305, 1e-7);
  EXPECT_DOUBLE_EQ(compute_failure_strain(f, 0., 0.01, 0.), 3.49)
    << "slower than the reference counts as the reference";
  const double damage = compute_damage_increment(f, heated(), at_triaxiality(0., 1043.));
  EXPECT_NEAR(damage, 1e-3 / (3.49 * 1.01381551 * 1.305), 1e-11);
  Hardening cold     = heated();
  cold.heat_capacity = 0.;
  EXPECT_NEAR(compute_damage_increment(f, cold, at_triaxiality(0., 1043.)), 1e-3 / (3.49 * 1.01381551), 1e-11)
    << "what does not heat has no homologous temperature";
}

// D of Cowper and Symonds, the rate that doubles the stress, is no reference of the damage: at 1000/s r* = 1000 in 1/s
// as above, also where D = 40.4/s (mild steel), which would make it 24.75, or 6500/s (aluminium), which would make
// it 1.
TEST(Failure, TheDamageHasTheReferenceRateOfJohnsonCookStrengthOnly)
{
  const Failure f = steel_4340();
  Hardening     h = heated();
  h.rate_law      = RateLaw::cowper_symonds;
  for (const double d : {40.4, 6500.})
    {
      h.reference_rate = d;
      EXPECT_NEAR(compute_damage_increment(f, h, at_triaxiality(0.)), 1e-3 / (3.49 * 1.01381551), 1e-11);
    }
  h.rate_law       = RateLaw::johnson_cook;
  h.reference_rate = 10.; // 1 + 0.002 ln(100) = 1.00921034
  EXPECT_NEAR(compute_damage_increment(f, h, at_triaxiality(0.)), 1e-3 / (3.49 * 1.00921034), 1e-11);
}

// Miner's sum over a path of two states: half of the strain to failure in shear, then tension until D = 1.
TEST(Failure, DamageAddsUpOverAPath)
{
  const Failure   f      = steel_4340();
  const Hardening h      = heated();
  double          damage = 0., strain = 0.;
  while (strain < 0.5 * 3.49 * 1.01381551 - 5e-4)
    {
      damage += compute_damage_increment(f, h, at_triaxiality(0.));
      strain += 1e-3;
    }
  EXPECT_NEAR(damage, 0.5, 3e-4);
  while (damage < 1.)
    {
      damage += compute_damage_increment(f, h, at_triaxiality(1. / 3.));
      strain += 1e-3;
    }
  EXPECT_NEAR(strain, 0.5 * (3.49 + 0.05 + 3.44 * 0.49328575) * 1.01381551, 2e-3);
}

TEST(Failure, PlasticStrainLimitIsTheSumOverTheLimit)
{
  Failure f;
  f.law            = FailureLaw::plastic_strain;
  f.plastic_strain = 0.25;
  double damage    = 0.;
  for (int k = 0; k < 250; ++k)
    damage += compute_damage_increment(f, Hardening(), at_triaxiality(k % 3 - 1.));
  EXPECT_NEAR(damage, 1., 1e-12);
}

TEST(Failure, SizeFactorsAreStraightLinesBetweenPoints)
{
  SizeFactors factors;
  EXPECT_EQ(factors.at(1e-3), 1.) << "none";
  EXPECT_TRUE(factors.is_within(1.));
  factors.points[0] = {1e-3, 3.};
  factors.n         = 1;
  for (const double size : {1e-6, 1e-3, 1.})
    EXPECT_EQ(factors.at(size), 3.);
  factors.points[1] = {2e-3, 1.5};
  factors.points[2] = {6e-3, 0.5};
  factors.n         = 3;
  EXPECT_EQ(factors.at(0.5e-3), 3.);
  EXPECT_EQ(factors.at(1e-3), 3.);
  EXPECT_DOUBLE_EQ(factors.at(1.5e-3), 2.25);
  EXPECT_EQ(factors.at(2e-3), 1.5);
  EXPECT_DOUBLE_EQ(factors.at(3e-3), 1.25);
  EXPECT_EQ(factors.at(6e-3), 0.5);
  EXPECT_EQ(factors.at(1.), 0.5);
  EXPECT_TRUE(factors.is_within(1e-3) && factors.is_within(6e-3));
  EXPECT_TRUE(factors.is_within(std::nextafter(1e-3, 0.))) << "round-off of an area";
  EXPECT_FALSE(factors.is_within(0.999e-3) || factors.is_within(6.001e-3));
}

TEST(Failure, SizeFactorsAreReadAndBadOnesRefused)
{
  MetalParameters p;
  p.failure.law          = FailureLaw::plastic_strain;
  p.failure.size_factors = "1e-3: 2; 4e-3: 1";
  EXPECT_DOUBLE_EQ(p.metal().failure.size_factors.at(2e-3), 1. + 2. / 3.);
  p.failure.size_factors = "";
  EXPECT_EQ(p.metal().failure.size_factors.n, 0u);
  for (const char *bad : {"1e-3", "1e-3: 0", "0: 1", "-1e-3: 1", "2e-3: 1; 1e-3: 2", "1e-3: 1; 1e-3: 2", "1e-3: nan",
                          "1e-3: 2000", "small: 1", "1e-3: 1 2"})
    {
      p.failure.size_factors = bad;
      EXPECT_THROW(p.metal(), InputError) << bad;
    }
  p.failure.size_factors = "1: 1";
  for (int k = 2; k < 18; ++k)
    p.failure.size_factors += "; " + std::to_string(k) + ": 1";
  EXPECT_THROW(p.metal(), InputError) << "seventeen points";
}

TEST(Failure, LanesDoWhatOneNumberDoes)
{
  const Failure   f = steel_4340();
  const Hardening h = heated();
  const Lanes     triaxiality([](const auto k) { return -1. + 0.5 * double(k); });
  const auto      damage = compute_damage_increment(
         f, h, PlasticStep<Lanes>{Lanes(1e-3), triaxiality * 800e6, Lanes(800e6), Lanes(700.), 1e-6});
  for (std::size_t k = 0; k < n_lanes; ++k)
    EXPECT_NEAR(damage[k] / compute_damage_increment(f, h, at_triaxiality(triaxiality[k], 700.)), 1., 1e-14);
  const auto still =
    compute_damage_increment(f, h, PlasticStep<Lanes>{Lanes(0.), Lanes(0.), Lanes(0.), Lanes(293.), 1e-6});
  EXPECT_TRUE(all(still == Lanes(0.))) << "an unstressed point neither fails nor is it not a number";
}

// Uniaxial: s^2/(2E); pure shear: s^2/(2G)
TEST(Failure, ElasticEnergyOfAPlaneState)
{
  const Elasticity metal{73e9, 0.33};
  const double     pulled[3] = {300e6, 0., 0.}, sheared[3] = {0., 0., 200e6};
  EXPECT_NEAR(plane_stress_energy(metal, pulled), 300e6 * 300e6 / (2. * 73e9), 1e-6);
  EXPECT_NEAR(plane_stress_energy(metal, sheared), 200e6 * 200e6 / (2. * metal.shear_modulus()), 1e-6);
}

TEST(Failure, ElasticEnergyOfThreeDimensions)
{
  const Elasticity metal{73e9, 0.33};
  const double     pulled[6] = {300e6, 0., 0., 0., 0., 0.}, sheared[6] = {0., 0., 0., 0., 200e6, 0.};
  const double     pressed[6] = {-500e6, -500e6, -500e6, 0., 0., 0.};
  EXPECT_NEAR(compute_elastic_energy(metal, pulled), 300e6 * 300e6 / (2. * 73e9), 1e-6);
  EXPECT_NEAR(compute_elastic_energy(metal, sheared), 200e6 * 200e6 / (2. * metal.shear_modulus()), 1e-6);
  EXPECT_NEAR(compute_elastic_energy(metal, pressed), 500e6 * 500e6 / (2. * metal.bulk_modulus()), 1e-6);
}

TEST(FailureParameters, AreReadAndRefused)
{
  dealii::ParameterHandler prm;
  MetalParameters          parameters;
  parameters.declare(prm);
  EXPECT_FALSE(parameters.metal().failure.can_fail());
  prm.parse_input_from_string("set Name = Al 2024 Johnson-Cook\nset Failure = Johnson-Cook\nset Damage D3 = -1.6\n"
                              "set Failed share = 0.6\nset Smallest step = 0.05\n");
  const Failure failure = parameters.metal().failure;
  EXPECT_EQ(failure.law, FailureLaw::johnson_cook);
  EXPECT_EQ(failure.d, (std::array<double, 5>{{0.13, 0.13, -1.6, 0.011, 0.}}));
  EXPECT_EQ(failure.failed_share, 0.6);
  EXPECT_EQ(failure.smallest_step, 0.05);
  EXPECT_EQ(Failure().smallest_step, 0.) << "off";

  parameters.failure.d[2] = "-1.6 J"; // not a number to the end
  EXPECT_THROW(parameters.metal(), InputError);
  parameters.failure.d = {{"-0.5", "0.2", "-1.5", "0", "0"}}; // negative in tension
  EXPECT_THROW(parameters.metal(), InputError);
  MetalParameters titanium;
  titanium.failure.law = FailureLaw::johnson_cook; // the table has no damage constants
  EXPECT_THROW(titanium.metal(), InputError);
  titanium.failure.law = FailureLaw::plastic_strain;
  EXPECT_NO_THROW(titanium.metal());
  titanium.failure.law           = FailureLaw::none;
  titanium.failure.smallest_step = 0.05; // of elements that never go
  try
    {
      titanium.metal();
      ADD_FAILURE() << "accepted";
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("Blade/Material/Smallest step"), std::string::npos) << error.what();
    }
  titanium.failure.law = FailureLaw::plastic_strain;
  EXPECT_NO_THROW(titanium.metal());
  titanium.hardening = "elastic"; // never yields, never fails
  EXPECT_THROW(titanium.metal(), InputError);
}
