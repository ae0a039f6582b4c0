#include <birdstrike/material/metal_constants.h>
#include <birdstrike/material/metal_parameters.h>

#include <gtest/gtest.h>

#include <map>

namespace birdstrike
{
  namespace
  {
    std::map<std::string, double> listed(const Metal &metal)
    {
      std::map<std::string, double> values;
      for (const MetalConstant &constant : constants_in_use(metal))
        values[constant.key] = constant.value;
      return values;
    }

    TEST(MetalConstants, OfTheDefaultTitaniumSayThatItDoesNotHarden)
    {
      const Metal metal = MetalParameters().metal();
      EXPECT_EQ(listed(metal), (std::map<std::string, double>{{"density", 4430.},
                                                              {"youngs_modulus", 113.8e9},
                                                              {"poissons_ratio", 0.342},
                                                              {"yield_stress", 880e6},
                                                              {"elongation", 0.14}}));
      EXPECT_EQ(describe(metal), "Ti-6Al-4V: 4430 kg/m^3, E 113.8 GPa, nu 0.342, yield 880 MPa, no hardening, no rate "
                                 "dependence, does not fail");
    }

    TEST(MetalConstants, AreThoseThatTheLawsUseAndNoOthers)
    {
      MetalParameters given;
      given.name        = "Al 2024 Johnson-Cook";
      given.failure.law = FailureLaw::johnson_cook;
      auto aluminium    = listed(given.metal());
      EXPECT_EQ(aluminium.at("yield_stress"), 369e6); // A 369 B 684 n 0.73 C 0.0083; damage 0.13 0.13 -1.5
      EXPECT_EQ(aluminium.at("hardening_modulus"), 684e6);
      EXPECT_EQ(aluminium.at("hardening_exponent"), 0.73);
      EXPECT_EQ(aluminium.at("rate_factor"), 0.0083);
      EXPECT_EQ(aluminium.at("failure_d3"), -1.5);
      EXPECT_NE(describe(given.metal()).find("johnson-cook hardening 684 MPa, exponent 0.73, rate 0.0083"),
                std::string::npos)
        << describe(given.metal());

      given.hardening   = "elastic";
      given.failure.law = FailureLaw::none;
      EXPECT_FALSE(listed(given.metal()).contains("yield_stress"));
      EXPECT_NE(describe(given.metal()).find("never yields"), std::string::npos);
    }
  } // namespace
} // namespace birdstrike
