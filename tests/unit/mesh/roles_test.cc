#include "solid_mesh_harness.h"

#include <birdstrike/mesh/roles.h>

#include <cmath>

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
          const BladeRoles roles(mesh, root_id, tip_id, {Point3(0.2, 0., 0.), Point3(0., 100., side * 150.)});
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

  // A blade whose sections turn from 20 to 65 degrees about x, n(s) = (0, -sin, cos) of the stagger. Struck at half of
  // the span along d = cos(12 deg) t + sin(12 deg) n there, t its chord direction: at 42.5 degrees, so that d lies
  // at 54.5 degrees to y. With n of the tip (65 degrees) it has the angle 65 + 90 - 54.5 = 100.5 degrees: the tip's
  // normal looks at it, though the face behind is the one that is struck everywhere.
  template <int dim>
  void expect_one_side_of_a_twisted_blade()
  {
    BladeParameters p;
    p.mesh.generator           = MeshGenerator::blade;
    p.mesh.length              = 0.3;
    p.mesh.chord               = 0.1;
    p.mesh.n_span              = 24;
    p.mesh.n_chord             = 8;
    p.mesh.n_layers            = 1;
    p.mesh.profile.root_radius = 0.15;
    p.mesh.profile.stagger     = "20 + 45*s";
    p.is_halved                = false;
    const BladeMesh<dim> mesh(p);
    const auto           along = [](const double degrees) {
      return Point3(0., std::cos(degrees * M_PI / 180.), std::sin(degrees * M_PI / 180.));
    };
    for (const double side : {1., -1.})
      {
        const Point3     velocity = 200. * (side > 0. ? along(54.5) : along(30.5)); // to either face, by 12 degrees
        const BladeRoles roles(mesh, root_id, tip_id, {Point3(0.3, 0., 0.), velocity});
        EXPECT_GT(side * roles.root.normal.dot(along(110.)), 0.99);
        EXPECT_GT(side * roles.tip.normal.dot(along(155.)), 0.99);
        EXPECT_EQ(roles.root.is_turned, side < 0.);
        EXPECT_EQ(roles.tip.is_turned, side < 0.);
      }
  }

  TEST(BladeRoles, TheStruckSideIsThatWhereTheBirdAims)
  {
    expect_one_side_of_a_twisted_blade<2>();
    expect_one_side_of_a_twisted_blade<3>();
  }

  // Sections turn from 70 to 110 degrees about x: the root's chord runs towards +y, cos(70 deg), and so does its
  // continuation at the tip, which has y = cos(110 deg), whichever side is struck. 40 degrees on 24 elements: an end
  // has the mean of its cells, half an element from it, 0.8 degrees or 0.015.
  template <int dim>
  void expect_one_sense_of_the_chord()
  {
    BladeParameters p;
    p.mesh.generator       = MeshGenerator::blade;
    p.mesh.length          = 0.3;
    p.mesh.chord           = 0.1;
    p.mesh.n_span          = 24;
    p.mesh.n_chord         = 8;
    p.mesh.n_layers        = 1;
    p.mesh.profile.stagger = "70 + 40*s";
    p.is_halved            = false;
    const BladeMesh<dim> mesh(p);
    const auto           along = [](const double degrees) {
      return Point3(0., std::cos(degrees * M_PI / 180.), std::sin(degrees * M_PI / 180.));
    };
    for (const double side : {1., -1., 0.})
      {
        const BladeRoles roles(mesh, root_id, tip_id, {Point3(0.15, 0., 0.), side * 200. * along(170.)});
        EXPECT_LT((roles.root.chord - along(70.)).norm(), 0.02) << dim << side;
        EXPECT_LT((roles.tip.chord - along(110.)).norm(), 0.02) << dim << side;
        for (const double degrees : {75., 90., 105.})
          {
            const double sign = roles.root.normal.dot(along(160.)) > 0. ? 1. : -1.;
            EXPECT_LT((roles.chord_at(sign * along(degrees + 90.), Point3::UnitX()) - along(degrees)).norm(), 1e-12);
          }
      }
  }

  TEST(BladeRoles, TheChordRunsOnFromThatOfTheRoot)
  {
    expect_one_sense_of_the_chord<2>();
    expect_one_sense_of_the_chord<3>();
  }

  // Edges that meet face no common way: each has the sign of its own.
  TEST(BladeRoles, ChordsOfEdgesThatMeetAreTheirOwn)
  {
    const ShellMesh  mesh(plate(6, 4, 2));
    const BladeRoles roles(mesh, {2}, {1}, {});
    expect_near(roles.root.chord, Point3::UnitX());
    expect_near(roles.tip.chord, Point3::UnitY());
  }

  // Without a tip the root decides; an end that runs all around has no axes.
  TEST(BladeRoles, AbsentEndsHaveNoSay)
  {
    const ShellMesh  mesh(plate(6, 4, 2));
    const BladeRoles clamped(mesh, root_id, all_around, {Point3(0.2, 0., 0.), Point3(0., 0., -150.)});
    EXPECT_FALSE(clamped.tip.is_present());
    EXPECT_TRUE(clamped.tip.nodes.empty());
    expect_near(clamped.root.normal, -Point3::UnitZ());
    EXPECT_FALSE(BladeRoles(mesh, {}, {}, {}).root.is_present());
  }
} // namespace birdstrike::roles_test
