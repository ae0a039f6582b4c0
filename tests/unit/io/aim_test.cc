#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>

#include <gtest/gtest.h>

#include <cmath>

#include "expect_parts.h"
#include "refusal.h"
#include "scratch_folder.h"

using namespace birdstrike;

namespace
{
  const std::string oblique = BIRDSTRIKE_SOURCE_DIR "/prm/oblique.prm";

  /// The plate of the shipped cases, and nothing of the bird.
  std::string plain(const ScratchFolder &scratch)
  {
    return scratch.write("plain.prm", "");
  }
} // namespace

/// The paper gives speed and angle; the shipped velocity is one of 302.097 m/s at 36.4000 degrees.
TEST(Aim, SpeedAndAngleAreTheShippedVelocityOfTheObliqueCase)
{
  const ScratchFolder scratch;
  CaseParameters      parameters;
  parameters.read(plain(scratch), {"Bird/Speed=302.1 m/s", "Bird/Angle to surface=36.4 deg"});
  EXPECT_EQ(parameters.bird.velocity[0], 0.);
  EXPECT_NEAR(parameters.bird.velocity[1], 243.1559, 1e-5 * 302.1);
  EXPECT_NEAR(parameters.bird.velocity[2], 179.2710, 1e-5 * 302.1);
  EXPECT_EQ(parameters.blade.bird->velocity, parameters.bird.velocity);
  EXPECT_EQ(parameters.blade.bird->target, parameters.bird.target());
}

/// Whoever has a file with a velocity, and wants to say it the other way.
TEST(Aim, AnEntryOfTheFileIsGivenBackByTheWordDefault)
{
  CaseParameters parameters;
  expect_parts(refusal(oblique, {"Bird/Speed=200", "Bird/Angle to surface=90"}),
               {"contradicts Bird/Velocity", "default"});
  parameters.read(oblique, {"Bird/Velocity=default", "Bird/Speed=200", "Bird/Angle to surface=90",
                            "Bird/Aim point=default", "Bird/Aim span fraction=0.5", "Bird/Aim chord fraction=0.5"});
  EXPECT_EQ(parameters.bird.velocity, (std::array<double, 3>{{0., 0., 200.}}));
  EXPECT_NEAR(parameters.bird.aim_point[0], 0.1556, 1e-12);
}

TEST(Aim, ARightAngleIsTheNormalItself)
{
  const ScratchFolder scratch;
  CaseParameters      parameters, back;
  parameters.read(plain(scratch), {"Bird/Speed=177.4", "Bird/Angle to surface=90"});
  EXPECT_EQ(parameters.bird.velocity, (std::array<double, 3>{{0., 0., 177.4}}));
  back.read(plain(scratch), {"Bird/Speed=100", "Bird/Angle to surface=-90"});
  EXPECT_EQ(back.bird.velocity, (std::array<double, 3>{{0., 0., -100.}}));
}

TEST(Aim, ThePrintedFileRunsToTheSameBits)
{
  const ScratchFolder scratch;
  CaseParameters      first, again;
  first.read(plain(scratch), {"Bird/Speed=302.1", "Bird/Angle to surface=36.4", "Bird/Aim span fraction=0.7",
                              "Bird/Aim chord fraction=0.25"});
  again.read(scratch.write("parameters.prm", first.file.as_prm()));
  EXPECT_EQ(again.bird.velocity, first.bird.velocity);
  EXPECT_EQ(again.bird.aim_point, first.bird.aim_point);
  EXPECT_EQ(again.file.as_prm(), first.file.as_prm());
  EXPECT_EQ(first_difference(first, again, {}), "");
}

TEST(Aim, SharesLieOnTheRealSurface)
{
  const ScratchFolder scratch;
  CaseParameters      plate;
  plate.read(plain(scratch), {"Bird/Aim span fraction=70 %", "Bird/Aim chord fraction=0.5"});
  EXPECT_EQ(plate.bird.aim_point, (std::array<double, 3>{{0.7 * 0.3112, 0., 0.}}));
}

// Below a plate in z = 0, and beside its edge at y = -44.45 mm.
TEST(Aim, SaysHowFarAnAimPointLiesOffTheMidSurface)
{
  const ScratchFolder scratch;
  const auto          distance_of = [&](const std::string &point) {
    CaseParameters plate;
    plate.read(plain(scratch), {"Bird/Aim point=" + point});
    return plate.bird.aimed_surface.value().distance;
  };
  EXPECT_NEAR(distance_of("0.2, 0.01, 0"), 0., 1e-12);
  EXPECT_NEAR(distance_of("0.2, 0.01, -0.021"), 0.021, 1e-12);
  EXPECT_NEAR(distance_of("0.2, -0.05, 0"), 0.05 - 0.0889 / 2., 1e-12);
}

TEST(Aim, TheOffsetFollowsTheChord)
{
  const ScratchFolder scratch;
  CaseParameters      plate, blade;
  plate.read(oblique, {});
  EXPECT_EQ(plate.bird.target(), (std::array<double, 3>{{0.21784, -0.04445, 0.}}));
  blade.read(plain(scratch),
             {"Blade/Mesh/Generator=blade", "Blade/Mesh/Profile/Stagger=60", "Bird/Chordwise offset=0.01"});
  const auto target = blade.bird.target();
  EXPECT_NEAR(target[1] - blade.bird.aim_point[1], 0.005, 1e-15);
  EXPECT_NEAR(target[2] - blade.bird.aim_point[2], 0.01 * std::sqrt(0.75), 1e-15);
}

TEST(Aim, WhatIsGivenBothWaysMustAgree)
{
  CaseParameters same;
  same.read(oblique, {"Bird/Speed=302.1", "Bird/Angle to surface=36.4", "Bird/Aim span fraction=0.7",
                      "Bird/Aim chord fraction=0.5", "Bird/Flight direction=0, 0.80489, 0.59342"});
  EXPECT_EQ(same.bird.velocity, (std::array<double, 3>{{0., 243.1559, 179.2710}}));
  EXPECT_EQ(same.bird.aim_point, (std::array<double, 3>{{0.21784, 0., 0.}}));
  expect_parts(refusal(oblique, {"Bird/Speed=300"}), {"Bird/Speed = 300 m/s", "Bird/Velocity", "302.097 m/s"});
  expect_parts(refusal(oblique, {"Bird/Angle to surface=36"}), {"Bird/Angle to surface = 36", "Bird/Velocity"});
  expect_parts(refusal(oblique, {"Bird/Flight direction=0, 1, 1"}), {"Bird/Flight direction", "Bird/Velocity"});
  expect_parts(refusal(oblique, {"Bird/Aim span fraction=0.6", "Bird/Aim chord fraction=0.5"}),
               {"Bird/Aim point", "Aim span fraction", "0.18672"});
}

TEST(Aim, HalfAnAlternativeAndABladeWithoutChordAreRefused)
{
  const ScratchFolder scratch;
  const std::string   file = plain(scratch);
  expect_parts(refusal(file, {"Bird/Speed=100"}), {"Angle to surface is missing"});
  expect_parts(refusal(file, {"Bird/Angle to surface=30"}), {"Bird/Speed is missing"});
  expect_parts(refusal(file, {"Bird/Aim span fraction=0.5"}), {"Aim chord fraction", "not given"});
  expect_parts(refusal(file, {"Bird/Flight direction=0, 0, 0", "Bird/Speed=1"}), {"Flight direction", "no direction"});
  expect_parts(refusal(file, {"Bird/Speed=100", "Bird/Angle to surface=0"}), {"never meets"});
  expect_parts(refusal(file, {"Bird/Speed=100", "Bird/Angle to surface=30", "Blade/Kind=rigid"}),
               {"no span and chord"});
  expect_parts(refusal(file, {"Bird/Speed=100", "Bird/Angle to surface=30", "Blade/Loads/Initial velocity=0; 0; 10"}),
               {"the blade moves at the start"});
  expect_parts(refusal(file, {"Bird/Speed=100", "Bird/Angle to surface=30", "Blade/Spin/Speed=600"}),
               {"Bird/Angle to surface", "Blade/Spin/Speed"});
}
