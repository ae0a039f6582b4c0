#include "solid_mesh_harness.h"

#include <birdstrike/mesh/roles.h>

namespace birdstrike::roles_test
{
  using namespace solid_mesh_harness;

  namespace
  {
    const std::vector<unsigned int> root_id{0}, tip_id{1}, all_around{0, 1, 2, 3};

    void expect_near(const Point3 &a, const Point3 &b)
    {
      EXPECT_LT((a - b).norm(), 1e-12) << a.transpose() << " and " << b.transpose(); // round-off of some sums
    }

    /// Of a plate in x (span) and y (chord) about y = 0, or its half.
    template <int dim>
    void expect_axes(const BladeParameters &p)
    {
      const BladeMesh<dim> mesh(p);
      for (const double side : {1., -1.})
        {
          const BladeRoles roles(mesh, root_id, tip_id, Point3(0., 100., side * 150.));
          expect_near(roles.root.middle, Point3::Zero());
          expect_near(roles.tip.middle, Point3(p.mesh.length, 0., 0.));
          expect_near(roles.root.span, Point3::UnitX());
          expect_near(roles.tip.span, -Point3::UnitX());
          for (const BladeEnd *end : {&roles.root, &roles.tip})
            {
              expect_near(end->chord, Point3::UnitY());
              expect_near(end->normal, Point3(0., 0., side));
              EXPECT_EQ(end->is_turned, side < 0.);
            }
        }
    }
  } // namespace

  TEST(BladeRoles, ShellAndSolidAndTheirHalvesHaveTheSameAxes)
  {
    BladeParameters p = plate(6, 4, 2);
    for (const bool is_halved : {false, true})
      {
        p.is_halved = is_halved;
        expect_axes<2>(p);
        expect_axes<3>(p);
      }
  }

  // Without a tip the root decides; an end that runs all around has no axes.
  TEST(BladeRoles, AbsentEndsHaveNoSay)
  {
    const ShellMesh  mesh(plate(6, 4, 2));
    const BladeRoles clamped(mesh, root_id, all_around, Point3(0., 0., -150.));
    EXPECT_FALSE(clamped.tip.is_present());
    EXPECT_TRUE(clamped.tip.nodes.empty());
    expect_near(clamped.root.normal, -Point3::UnitZ());
    EXPECT_FALSE(BladeRoles(mesh, {}, {}, Point3::Zero()).root.is_present());
  }
} // namespace birdstrike::roles_test
