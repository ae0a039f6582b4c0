#include <birdstrike/core/number.h>
#include <birdstrike/simulation/symmetry.h>

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
  energy.retired = 6., energy.eroded = 7., energy.external_work = 8., energy.contact_work = 9.;
  const Symmetry     mirrored(true);
  const EnergyReport whole = mirrored.whole(energy);
  EXPECT_EQ(whole.total(), 2. * energy.total());
  EXPECT_EQ(whole.external_work, 16.);
  EXPECT_EQ(whole.contact_work, 18.);
  RootSectionReport root;
  root.normal_force = 1., root.bending_moment = 2., root.transverse_force = 3.;
  root.stress_top = {5.};
  EXPECT_EQ(mirrored.whole(root).bending_moment, 4.);
  EXPECT_EQ(mirrored.whole(root).peak_stress(), 5.);
}
