#include "strike_harness.h"

#include "simulation/symmetry.h"
#include <birdstrike/core/number.h>

#include <gtest/gtest.h>

using namespace birdstrike;

TEST(Symmetry, WholeSceneIsTheHalfAndItsMirrorImage)
{
  // mass m at (x, y, z) with velocity v, and its image at (x, -y, z) with (vx, -vy, vz)
  const Point3   x(1., 2., 3.), v(4., 5., 6.), xm(1., -2., 3.), vm(4., -5., 6.);
  const Point3   p = v + vm, l = x.cross(v) + xm.cross(vm), half = x.cross(v);
  MomentumReport momentum;
  momentum.momentum = momentum.contact_impulse = {{v[0], v[1], v[2]}};
  momentum.angular_momentum                    = {{half[0], half[1], half[2]}};
  const MomentumReport whole                   = Symmetry(true).whole(momentum);
  for (int d = 0; d < 3; ++d)
    {
      EXPECT_EQ(whole.momentum[d], p[d]);
      EXPECT_EQ(whole.contact_impulse[d], p[d]);
      EXPECT_EQ(whole.angular_momentum[d], l[d]);
      EXPECT_EQ(Symmetry(false).whole(momentum).momentum[d], v[d]);
    }
}

TEST(Symmetry, EnergiesAndForcesDoubleStressesStay)
{
  EnergyReport energy;
  energy.kinetic = 1., energy.elastic = 2., energy.plastic = 3., energy.hourglass = 4., energy.dissipated = 5.;
  energy.viscous = 10.;
  energy.retired = 6., energy.eroded = 7., energy.external_work = 8., energy.contact_work = 9.;
  const Symmetry     mirrored(true);
  const EnergyReport whole = mirrored.whole(energy);
  EXPECT_EQ(whole.total(), 2. * energy.total());
  EXPECT_EQ(whole.external_work, 16.);
  EXPECT_EQ(whole.contact_work, 18.);
  RootSectionReport root;
  root.normal_force = 1., root.bending_moment = 2., root.transverse_force = 3.;
  root.stress_rear = {5.};
  EXPECT_EQ(mirrored.whole(root).bending_moment, 4.);
  EXPECT_EQ(mirrored.whole(root).peak_stress(), 5.);
}

// The same lattice and mesh whole and halved (at other spacings the whole bird may have particles in the plane). Spray
// amplifies round-off of float pairs, so the two agree to that scatter, not to the last bit.
TEST(Symmetry, HalfTheSceneGivesTheAnswerOfTheWhole)
{
  const std::vector<std::string> mesh{"Blade/Mesh/Elements along chord=10", "Blade/Mesh/Elements along span=31",
                                      "Time/End time=1e-3"};
  std::vector<std::string>       half = mesh;
  half.push_back("Case/Symmetry plane=y");
  const Summary a = test::run_shipped("quickstart.prm", mesh).summary;
  const Summary b = test::run_shipped("quickstart.prm", half).summary;
  ASSERT_EQ(a.bird.particles, b.bird.particles);
  ASSERT_EQ(a.blade.elements, b.blade.elements);
  const auto expect_same = [](const char *what, const double whole, const double mirrored) {
    std::printf("  %s %+.3f %%\n", what, 100. * (mirrored / whole - 1.));
    EXPECT_NEAR(mirrored, whole, 0.005 * std::abs(whole)) << what;
  };
  expect_same("bird mass", a.bird.mass, b.bird.mass);
  expect_same("blade mass", a.blade.mass, b.blade.mass);
  expect_same("tip deflection", a.tip.peak, b.tip.peak);
  expect_same("root moment", a.root.peak_moment, b.root.peak_moment);
  expect_same("root stress", a.root.peak_normal_stress, b.root.peak_normal_stress);
  expect_same("impulse", a.contact.impulse[2], b.contact.impulse[2]);
  expect_same("peak force", a.contact.peak_force, b.contact.peak_force);
  expect_same("initial energy", a.energy.initial, b.energy.initial);
  expect_same("plastic work", a.plastic.work, b.plastic.work);
  EXPECT_EQ(b.contact.impulse[1], 0.);
  EXPECT_LT(b.energy.max_relative_error, 5e-3);
  EXPECT_LT(b.momentum.max_relative_error, 1e-8);
}
