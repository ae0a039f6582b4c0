#include "bird_case.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace birdstrike;
using namespace birdstrike::test;

TEST(Bird, OnlyLooseParticlesThatMissTheBladeRetire)
{
  ThreadPool   pool(1);
  Bird         bird(small_bird(), EosParameters(), pool);
  const double z = bird.packing().centre[2];
  const Box    ahead{{{-0.1, -0.1, z + 0.3}}, {{0.1, 0.1, z + 0.31}}};
  const Box    behind{{{-0.1, -0.1, z - 0.31}}, {{0.1, 0.1, z - 0.3}}};
  EXPECT_EQ(bird.retire(behind), 0u) << "unstrained liquid holds together";
  bird.set_state([](Point3 &, Point3 &, double &mu) { mu = -0.05; });
  EXPECT_EQ(bird.retire(ahead), 0u) << "its path meets the blade";
  const double      energy = bird.energies().total(), momentum = bird.momenta().momentum[2];
  const std::size_t n = bird.state().size();
  EXPECT_EQ(bird.retire(behind), n);
  EXPECT_NEAR(bird.energies().total(), energy, 1e-12 * energy);
  EXPECT_NEAR(bird.momenta().retired[2], momentum, 1e-12 * momentum);
  EXPECT_EQ(bird.points().n, 0u);
  EXPECT_TRUE(std::isinf(bird.step_limit().value)) << "nobody is left to vote";
}

TEST(Bird, LiquidUnderTensionIsNotLoose)
{
  ThreadPool     pool(1);
  BirdParameters pulled = small_bird();
  pulled.tension_cutoff = false;
  Bird         bird(pulled, EosParameters(), pool);
  const double z = bird.packing().centre[2];
  const Box    behind{{{-0.1, -0.1, z - 0.31}}, {{0.1, 0.1, z - 0.3}}};
  bird.set_state([](Point3 &, Point3 &, double &mu) { mu = -0.05; });
  EXPECT_EQ(bird.retire(behind), 0u) << "-6 MPa hold it together";
}
