#include <birdstrike/core/errors.h>
#include <birdstrike/material/metal_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace birdstrike;

TEST(MetalParameters, TheTableGivesWhatIsNotGiven)
{
  dealii::ParameterHandler prm;
  MetalParameters          parameters;
  parameters.declare(prm);
  prm.parse_input_from_string("set Name = Ti-8Al-1Mo-1V\nset Hardening = linear\nset Hardening modulus = 1.25e9\n"
                              "set Density = 4400\n");
  const Metal metal = parameters.metal();
  EXPECT_EQ(metal.elasticity.young, 121e9);
  EXPECT_EQ(metal.elasticity.poisson, 0.32);
  EXPECT_EQ(metal.density, 4400.) << "an entry that is given replaces the table";
  EXPECT_EQ(metal.hardening.yield, 930e6);
  EXPECT_EQ(metal.hardening.law, HardeningLaw::linear);
  EXPECT_EQ(metal.hardening.modulus, 1.25e9);
}

TEST(MetalParameters, CustomMetalsMustBeComplete)
{
  MetalParameters parameters;
  parameters.name    = "custom";
  parameters.density = "2700";
  parameters.young   = "70e9";
  parameters.poisson = "0.3";
  EXPECT_THROW(parameters.metal(), InputError);
  parameters.yield = "300e6";
  EXPECT_NO_THROW(parameters.metal());
}

TEST(MetalParameters, BadValuesAreRefused)
{
  MetalParameters parameters;
  parameters.poisson = "0.5";
  EXPECT_THROW(parameters.metal(), InputError);
  parameters.poisson = "0.3x";
  EXPECT_THROW(parameters.metal(), InputError);
  parameters.poisson   = "0.3";
  parameters.hardening = "johnson-cook"; // the table has no hardening modulus for this alloy
  EXPECT_THROW(parameters.metal(), InputError);
  parameters.modulus = "331e6";
  EXPECT_NO_THROW(parameters.metal());
}

TEST(MetalParameters, HeatingTakesTheHeatDataOfItsMetal)
{
  MetalParameters parameters;
  parameters.name = "Al 2024 Johnson-Cook";
  EXPECT_EQ(parameters.metal().hardening.heat_capacity, 0.) << "isothermal";
  parameters.is_adiabatic = true;
  EXPECT_EQ(parameters.metal().hardening.heat_capacity, 875.);
  EXPECT_EQ(parameters.metal().hardening.melting_temperature, 775.);
  parameters.melting_temperature = "200"; // colder than the room
  EXPECT_THROW(parameters.metal(), InputError);
  parameters.melting_temperature = "900";
  parameters.heat_capacity       = "0.875"; // kJ
  EXPECT_THROW(parameters.metal(), InputError);
  parameters.heat_capacity = "880";
  EXPECT_EQ(parameters.metal().hardening.heat_capacity, 880.);
  EXPECT_EQ(parameters.metal().hardening.melting_temperature, 900.);
  parameters.name                = "Al 6061-T6";
  parameters.melting_temperature = "table";
  EXPECT_THROW(parameters.metal(), InputError) << "nothing was read of this one";
}

TEST(ThermalSoftening, LeavesAMillionthOfAMoltenMetal)
{
  Hardening h;
  h.heat_capacity       = 500.;
  h.melting_temperature = 1873.;
  for (const double exponent : {1e-3, 1., 1.7})
    {
      h.softening_exponent = exponent;
      EXPECT_EQ(thermal_softening(h, h.room_temperature), 1.) << "no softening at room temperature, whatever the law";
      EXPECT_NEAR(thermal_softening(h, 1083.), 1. - std::pow(0.5, exponent), 1e-14);
      EXPECT_EQ(thermal_softening(h, 3000.), 1e-6);
    }
}
