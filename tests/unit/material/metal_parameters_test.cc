#include <birdstrike/core/errors.h>
#include <birdstrike/material/metal_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

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

// No metal of the table is of these laws: with the usual exponent of 1 they would be other laws, without a word.
TEST(MetalParameters, LawsThatTheTableHasNotAreGivenWhole)
{
  for (const auto &[law, entries] :
       {std::pair("swift", std::array{"0.3", "0.01", "table"}), std::pair("voce", std::array{"20", "table", "2e8"}),
        std::pair("johnson-cook", std::array{"0.3", "table", "1e9"})})
    {
      const auto make = [&, law = law](const std::string &exponent, const std::string &strain,
                                       const std::string &modulus) {
        MetalParameters parameters;
        parameters.name      = "Ti-6Al-4V";
        parameters.hardening = law;
        parameters.exponent  = exponent;
        parameters.strain    = strain;
        parameters.modulus   = modulus;
        return parameters.metal();
      };
      EXPECT_NO_THROW(make(entries[0], entries[1], entries[2])) << law;
      EXPECT_THROW(make("table", entries[1], entries[2]), InputError) << law;
      if (std::string(law) == "swift")
        EXPECT_THROW(make(entries[0], "table", entries[2]), InputError);
      else
        EXPECT_THROW(make(entries[0], entries[1], "table"), InputError) << law;
    }
}

// Nor is B of another law the slope of a line: Johnson and Cook's, at 20 % of strain, is three times that.
TEST(MetalParameters, ALineDoesNotTakeAModulusOfAnotherLaw)
{
  MetalParameters parameters;
  parameters.name      = "Al 2024 Johnson-Cook";
  parameters.hardening = "linear";
  EXPECT_THROW(parameters.metal(), InputError);
  parameters.modulus = "5e8";
  EXPECT_EQ(parameters.metal().hardening.modulus, 5e8);
  parameters.hardening = "johnson-cook";
  parameters.modulus   = "table";
  EXPECT_NO_THROW(parameters.metal()) << "its own";
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
  EXPECT_THROW(parameters.metal(), InputError) << "nor an exponent: 1 is linear hardening";
  parameters.exponent = "0.34";
  EXPECT_NO_THROW(parameters.metal());
}

TEST(MetalParameters, ACurveRisesFromTheYieldStress)
{
  MetalParameters parameters;
  parameters.hardening = "curve";
  parameters.curve     = "0: 300e6; 0.02: 380e6; 0.2: 400e6";
  const Hardening h    = parameters.metal().hardening;
  EXPECT_EQ(h.yield, 300e6);
  ASSERT_EQ(h.curve.n_segments, 2u);
  EXPECT_DOUBLE_EQ(h.curve.segments[0].slope, 4e9);
  EXPECT_NEAR(compute_flow_stress(h, 0.01, 0.01, 1., 1.).value, 380e6, 1e-3);
  EXPECT_NEAR(compute_flow_stress(h, 0.5, 0.1, 1., 1.).value, 400e6, 1e-3) << "constant beyond";
  for (const char *bad : {"", "0: 300e6", "0.01: 300e6; 0.1: 400e6", "0: 300e6; 0: 400e6", "0: 300e6; 0.1: 299e6",
                          "0: 300e6; 1e-4: 400e6", "0: 0; 0.1: 1e6", "0: 300e6; 0.1: x"})
    {
      parameters.curve = bad;
      EXPECT_THROW(parameters.metal(), InputError) << bad;
    }
  parameters.curve = "0: 300e6; 0.02: 380e6";
  parameters.yield = "310e6";
  EXPECT_THROW(parameters.metal(), InputError) << "two yield stresses";
  parameters.yield     = "table";
  parameters.hardening = "linear";
  EXPECT_THROW(parameters.metal(), InputError) << "a curve that no law reads";
}

TEST(MetalParameters, CowperAndSymondsNeedTheirRate)
{
  MetalParameters parameters;
  parameters.rate_law = RateLaw::cowper_symonds;
  EXPECT_THROW(parameters.metal(), InputError);
  parameters.reference_rate = "40.4";
  EXPECT_EQ(parameters.metal().hardening.rate_law, RateLaw::cowper_symonds);
  parameters.rate_factor = "0.01";
  EXPECT_THROW(parameters.metal(), InputError);
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
