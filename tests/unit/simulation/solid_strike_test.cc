#include "strike_harness.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace birdstrike;
using namespace birdstrike::test;

namespace
{
  /// quickstart.prm with a blade of bricks.
  Strike run_solid(std::vector<std::string> more = {})
  {
    const std::vector<std::string> coarse{
      "Blade/Kind=solid",    "Blade/Mesh/Elements along span=20", "Blade/Mesh/Elements along chord=6",
      "Blade/Mesh/Layers=2", "Bird/Particle spacing=0.005",       "Time/End time=0.6e-3"};
    more.insert(more.begin(), coarse.begin(), coarse.end());
    return run_shipped("quickstart.prm", more);
  }
} // namespace

// The balances that every run must keep, on a blade of bricks struck on its skin.
TEST(SolidStrike, KeepsEnergyAndMomentum)
{
  const Strike run = run_solid();
  EXPECT_EQ(run.summary.text("blade/kind"), "solid");
  EXPECT_EQ(run.summary.number("blade/elements"), 240u);
  EXPECT_LT(run.summary.number("energy/max_relative_error"), 1e-2); // coupled gate
  EXPECT_LT(run.summary.number("momentum/max_relative_error"), 1e-8);
  EXPECT_LT(run.summary.number("contact/max_penetration_over_spacing"), 0.5);
  EXPECT_GT(run.summary.number("energy/parts/blade_viscous"), 0.);
  EXPECT_GT(run.summary.number("root/peak_normal_stress"), 880e6); // the root yields
}

// One layer of solid-shells bends and yields as the shell does; found on this coarse mesh: impulse 0.2 % and tip 3 %
// apart at 1 ms, where the tip moves at 60 m/s.
TEST(SolidStrike, AgreesWithTheShell)
{
  const Strike run   = run_solid({"Blade/Mesh/Layers=1", "Time/End time=1e-3"}),
               shell = run_solid({"Blade/Kind=shell", "Time/End time=1e-3"});
  EXPECT_NEAR(run.summary.number("contact/impulse/2") / shell.summary.number("contact/impulse/2"), 1., 0.01);
  EXPECT_NEAR(run.summary.number("tip/final") / shell.summary.number("tip/final"), 1., 0.05);
}

// The blade's steps are a fifth of the bird's here. Impulses of the bird's step would ring the thickness of the bricks:
// 46 J within the first 40 us, where the compression of the metal itself takes less than 1 J.
TEST(SolidStrike, SubCyclesDoNotRingTheThickness)
{
  const Strike single = run_solid({"Time/Multirate=false"}), multi = run_solid();
  EXPECT_GT(multi.summary.number("steps/blade"), 3 * multi.summary.number("steps/bird"));
  EXPECT_LT(multi.summary.number("energy/parts/blade_viscous"), 5.);
  EXPECT_NEAR(multi.summary.number("contact/impulse/2") / single.summary.number("contact/impulse/2"), 1., 0.01);
  EXPECT_NEAR(multi.summary.number("tip/final"), single.summary.number("tip/final"), 0.2e-3);
}

TEST(SolidStrike, IsBitwiseTheSameForOneAndTwoThreads)
{
  const Strike one = run_solid({"Time/Threads=1", "Time/End time=0.3e-3"}),
               two = run_solid({"Time/Threads=2", "Time/Force threads=true", "Time/End time=0.3e-3"});
  EXPECT_EQ(one.curves, two.curves);
}

// Lattice and tolerance of the shell's test: spray amplifies round-off, the two agree to that scatter.
TEST(SolidStrike, HalfTheSceneGivesTheAnswerOfTheWhole)
{
  const std::vector<std::string> mesh{"Blade/Mesh/Elements along chord=10", "Bird/Particle spacing=0.004"};
  std::vector<std::string>       mirrored_mesh = mesh;
  mirrored_mesh.push_back("Case/Symmetry plane=y");
  const Summary a = run_solid(mesh).summary, b = run_solid(mirrored_mesh).summary;
  ASSERT_EQ(a.number("bird/particles"), b.number("bird/particles"));
  ASSERT_EQ(a.number("blade/elements"), b.number("blade/elements"));
  ASSERT_EQ(a.number("blade/nodes"), b.number("blade/nodes"));
  const auto expect_same = [](const char *what, const double whole, const double mirrored) {
    EXPECT_NEAR(mirrored, whole, 0.005 * std::abs(whole)) << what;
  };
  expect_same("blade mass", a.number("blade/mass"), b.number("blade/mass"));
  expect_same("tip deflection", a.number("tip/peak"), b.number("tip/peak"));
  expect_same("root moment", a.number("root/peak_moment"), b.number("root/peak_moment"));
  expect_same("root stress", a.number("root/peak_normal_stress"), b.number("root/peak_normal_stress"));
  expect_same("impulse", a.number("contact/impulse/2"), b.number("contact/impulse/2"));
  expect_same("plastic work", a.number("plastic/work"), b.number("plastic/work"));
  EXPECT_EQ(b.number("contact/impulse/1"), 0.);
  EXPECT_LT(b.number("energy/max_relative_error"), 1e-2);
  EXPECT_LT(b.number("momentum/max_relative_error"), 1e-8);
}

// The edge strike: particles meet side faces of 4.27 mm, slide round both edges, and none goes through.
TEST(SolidStrike, AnEdgeStrikeKeepsItsBalances)
{
  const Strike run = run_shipped("oblique.prm", {"Blade/Kind=solid", "Blade/Mesh/Elements along span=20",
                                                 "Blade/Mesh/Elements along chord=6", "Blade/Mesh/Layers=1",
                                                 "Bird/Particle spacing=0.005", "Time/End time=0.8e-3"});
  EXPECT_LT(run.summary.number("energy/max_relative_error"), 1e-2);
  EXPECT_LT(run.summary.number("momentum/max_relative_error"), 1e-10);
  EXPECT_LT(run.summary.number("contact/max_penetration_over_spacing"), 0.5);
}
