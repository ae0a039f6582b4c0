#include <birdstrike/core/number.h>
#include <birdstrike/core/symmetry_plane.h>

#include <gtest/gtest.h>

using namespace birdstrike;

TEST(SymmetryPlane, TheWholeIsTheHalfAndItsMirrorImage)
{
  // mass m at (x, y, z) with velocity v, and its image at (x, -y, z) with (vx, -vy, vz)
  const Point3   x(1., 2., 3.), v(4., 5., 6.), xm(1., -2., 3.), vm(4., -5., 6.);
  const Point3   p = v + vm, l = x.cross(v) + xm.cross(vm), half = x.cross(v);
  MomentumReport momentum;
  momentum.momentum = momentum.contact_impulse = {{v[0], v[1], v[2]}};
  momentum.angular_momentum                    = {{half[0], half[1], half[2]}};
  const MomentumReport whole                   = SymmetryPlane(true).whole(momentum);
  for (int d = 0; d < 3; ++d)
    {
      EXPECT_EQ(whole.momentum[d], p[d]);
      EXPECT_EQ(whole.contact_impulse[d], p[d]);
      EXPECT_EQ(whole.angular_momentum[d], l[d]);
      EXPECT_EQ(SymmetryPlane(false).whole(momentum).momentum[d], v[d]);
    }
  const std::size_t three = 3;
  EXPECT_EQ(SymmetryPlane(true).whole(three, 2), 4u) << "two are their own images";
  EXPECT_EQ(SymmetryPlane(false).whole(three, 2), three);
}
