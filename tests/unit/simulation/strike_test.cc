#include "strike_harness.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace birdstrike;
using namespace birdstrike::test;

namespace
{
  Strike run_coarse(std::vector<std::string> more = {}, const std::string &file = "quickstart.prm")
  {
    const std::vector<std::string> coarse{"Bird/Particle spacing=0.005", "Blade/Mesh/Elements along span=20",
                                          "Blade/Mesh/Elements along chord=6", "Time/End time=1e-3"};
    more.insert(more.begin(), coarse.begin(), coarse.end());
    return run_shipped(file, more);
  }
} // namespace

// Coupled strike on the deformable blade: the balances that every run must keep.
TEST(Strike, KeepsEnergyAndMomentum)
{
  const Strike run = run_coarse();
  EXPECT_LT(run.summary.number("energy/max_relative_error"), 5e-3); // coupled gate
  EXPECT_LT(run.summary.number("momentum/max_relative_error"), 1e-8);
  EXPECT_LT(run.summary.number("contact/max_penetration_over_spacing"), 0.5);
  EXPECT_LT(run.summary.number("energy/max_hourglass_over_internal"), 0.05);
  // A semi-coupled model of the same strike, with the load on a fixed disc, gives 14 N s; m v = 17.83 N s is the bound
  // (nothing rebounds). The particle bird spreads over parts of the blade that move less and so leaves more behind.
  EXPECT_GT(run.summary.number("contact/impulse/2"), 13.);
  EXPECT_LT(run.summary.number("contact/impulse/2"), 17.83);
  EXPECT_NEAR(run.summary.number("contact/impulse/0"), 0., 0.3);
  EXPECT_GT(run.summary.number("root/peak_normal_stress"), 880e6); // the root yields
}

// The edge strike sheds particles that still push their neighbours a little: 1e-8 needs every half kick booked.
TEST(Strike, KeepsMomentumWhileParticlesLeave)
{
  const Strike run = run_coarse({"Time/End time=1.5e-3"}, "oblique.prm");
  EXPECT_GT(run.summary.number("retired/particles"), run.summary.number("bird/particles") / 4);
  EXPECT_LT(run.summary.number("momentum/max_relative_error"), 1e-10);
  EXPECT_LT(run.summary.number("energy/max_relative_error"), 5e-3);
  EXPECT_LT(run.summary.number("contact/max_penetration_over_spacing"), 0.5);
}

TEST(Strike, TheTipFirstMovesBackwards)
{
  const Strike run = run_coarse();
  EXPECT_LT(value_at(run.curves, "tip_mid_chord", 0.25e-3), -0.5e-3);
  EXPECT_GT(value_at(run.curves, "tip_mid_chord", 1e-3), 5e-3);
}

TEST(Strike, IsBitwiseTheSameForOneAndTwoThreads)
{
  const Strike one = run_coarse({"Time/Threads=1"}), two = run_coarse({"Time/Threads=2", "Time/Force threads=true"});
  EXPECT_EQ(one.curves, two.curves);
}

TEST(Strike, MultirateAgreesWithASingleRate)
{
  // elements of 30 mm step three times slower than the particles; ratio 1 is the reference
  const std::vector<std::string> slow_blade{"Blade/Mesh/Elements along span=12", "Blade/Mesh/Elements along chord=3"};
  auto                           with = [&](const std::string &entry) {
    auto more = slow_blade;
    more.push_back(entry);
    return run_coarse(more);
  };
  const Strike multi = with("Time/Multirate=true"), single = with("Time/Multirate=false");
  EXPECT_LT(multi.summary.number("steps/blade"), single.summary.number("steps/blade"));
  EXPECT_NEAR(multi.summary.number("contact/impulse/2") / single.summary.number("contact/impulse/2"), 1., 0.01);
  EXPECT_NEAR(multi.summary.number("tip/final") / single.summary.number("tip/final"), 1., 0.03);
  EXPECT_LT(multi.summary.number("energy/max_relative_error"), 5e-3);
  EXPECT_LT(multi.summary.number("momentum/max_relative_error"), 1e-8);
}

TEST(Strike, SkipsPartsThatTheSceneLacks)
{
  const Strike blade = run_shipped("blade-impulse.prm", {"Time/End time=50e-6"});
  EXPECT_EQ(blade.summary.number("bird/particles"), 0u);
  EXPECT_EQ(blade.summary.number("steps/bird"), 0u);
  const Strike bird = run_shipped("bird-free.prm", {"Time/End time=50e-6"});
  EXPECT_EQ(bird.summary.number("blade/elements"), 0u);
  EXPECT_EQ(bird.summary.number("steps/blade"), 0u);
  EXPECT_LT(bird.summary.number("energy/max_relative_error"), 1e-12);
}
