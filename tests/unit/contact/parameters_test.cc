#include <birdstrike/contact/parameters.h>
#include <birdstrike/core/errors.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

using namespace birdstrike;

TEST(ContactParameters, EntriesReachTheirMembers)
{
  ContactParameters        parameters;
  dealii::ParameterHandler prm;
  parameters.declare(prm);
  prm.parse_input_from_string("subsection Contact\n"
                              "  set Enabled = false\n"
                              "  set Friction = 0.1\n"
                              "  set Pressure patches = centre: 0 0 0 0.005; side: 0.02 0 -1e-3 0.004\n"
                              "end\n");
  parameters.check();
  EXPECT_FALSE(parameters.is_enabled);
  EXPECT_EQ(parameters.friction, 0.1);
  const auto patches = parameters.pressure_patches();
  ASSERT_EQ(patches.size(), 2u);
  EXPECT_EQ(patches[1].name, "side");
  EXPECT_EQ(patches[1].centre, Point3(0.02, 0., -1e-3));
  EXPECT_EQ(patches[1].radius, 0.004);
}

TEST(ContactParameters, WhatCannotBeMeantIsRefused)
{
  ContactParameters parameters;
  parameters.check();
  parameters.stiffness_scale = 0.;
  EXPECT_THROW(parameters.check(), InputError);
  for (const char *patches :
       {"centre 0 0 0 0.005", "centre: 0 0 0", "centre: 0 0 0 -1", "centre: 0 0 0 1 2", "a b: 0 0 0 1"})
    {
      ContactParameters bad;
      bad.patches = patches;
      EXPECT_THROW(bad.check(), InputError) << patches;
    }
}
