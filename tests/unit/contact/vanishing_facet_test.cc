#include "free_masses.h"

#include <gtest/gtest.h>

using namespace birdstrike;
using birdstrike::test::FreeMasses;
using birdstrike::test::g;

/// Facets go (their elements have failed) while points touch them or others.
namespace
{
  constexpr double dt = 1e-7; // s

  /// Three facets of 5 mm in a row along x.
  FreeMasses strip()
  {
    FreeMasses scene;
    scene.add_plate(3, 1, 5e-3, 2e-3);
    return scene;
  }

  struct Calls
  {
    FreeMasses scene;
    Contact    contact{ContactParameters()};
    ThreadPool pool;

    explicit Calls(FreeMasses masses) : scene(std::move(masses))
    {
    }

    Point3 force_at(const Point3 &position)
    {
      scene.place(0, position);
      scene.compute_contact(contact, dt, pool);
      return scene.force_on_point(0);
    }
  };
} // namespace

TEST(VanishingFacet, APointRemembersItsSideOfWhatIsLeft)
{
  // it has come from above and is held 0.2 mm below the middle surface; forgotten, that would be its new side
  Point3 forces[2];
  for (const bool vanishes : {false, true})
    {
      Calls calls(strip());
      calls.scene.add_point({Point3(2.5e-3, 2.5e-3, 1.4e-3), Point3(0., 0., -500.)});
      for (double z = 1.4e-3; z > -0.2e-3; z -= 500. * dt)
        calls.force_at({2.5e-3, 2.5e-3, z});
      EXPECT_GT(calls.force_at({2.5e-3, 2.5e-3, -0.2e-3})[2], 0.);
      if (vanishes)
        calls.scene.remove_facet(2);
      forces[vanishes] = calls.force_at({2.5e-3, 2.5e-3, -0.25e-3});
    }
  EXPECT_GT(forces[0][2], 0.);
  EXPECT_EQ(forces[0], forces[1]);
}

TEST(VanishingFacet, WhatWasUnderAPointPushesItNoMore)
{
  Calls calls(strip());
  calls.scene.add_point({Point3(7.5e-3, 2.5e-3, 1.2e-3)});
  EXPECT_EQ(calls.force_at({7.5e-3, 2.5e-3, 1.6e-3})[2], 0.);
  EXPECT_GT(calls.force_at({7.5e-3, 2.5e-3, 1.2e-3})[2], 0.);
  calls.scene.remove_facet(1);
  EXPECT_EQ(calls.force_at({7.5e-3, 2.5e-3, 1.2e-3}), Point3(0., 0., 0.)) << "the edges left are 2.5 mm away";
  EXPECT_EQ(calls.force_at({7.5e-3, 2.5e-3, -1e-3}), Point3(0., 0., 0.)) << "through the hole";
}

TEST(VanishingFacet, NearTheNewEdgeTheForceIsNoLargerThanBefore)
{
  for (const double x : {5.2e-3, 5.8e-3, 6.1e-3})
    for (const double z : {0.4e-3, 0.9e-3, 1.3e-3})
      {
        Calls calls(strip());
        calls.scene.add_point({Point3(x, 2.5e-3, z)});
        calls.force_at({x, 2.5e-3, 1.6e-3});
        const Point3 before = calls.force_at({x, 2.5e-3, z});
        calls.scene.remove_facet(1);
        const Point3 after = calls.force_at({x, 2.5e-3, z});
        EXPECT_GT(before[2], 0.);
        EXPECT_LE(after.norm(), before.norm() * (1. + 1e-12)) << x << " " << z;
        EXPECT_EQ(after[0] < 0., false) << "away from the new edge, if at all";
      }
}

// A facet that appears (an inner face of a solid, bared by a failed neighbour) where a point already is: what it
// overlaps then carries nothing, what it comes deeper does.
TEST(VanishingFacet, AFacetThatAppearsDoesNotPushWhatItFindsInside)
{
  FreeMasses scene;
  scene.add_plate(1, 1, 5e-3, 2e-3);
  scene.add_plate(1, 1, 5e-3, 2e-3, Point3(0.05, 0., 0.)); // bared later
  const auto bared = scene.facet.back();
  scene.remove_facet(1);
  Calls calls(std::move(scene));
  calls.scene.add_point({Point3(0.0525, 2.5e-3, 1e-3)});
  EXPECT_EQ(calls.force_at({0.0525, 2.5e-3, 1e-3}).norm(), 0.);
  EXPECT_EQ(calls.force_at({0.0525, 2.5e-3, 1e-3}).norm(), 0.);
  calls.scene.facet.push_back(bared);
  calls.scene.neighbor.push_back({-1, -1, -1, -1});
  calls.scene.half_thickness.push_back(1e-3);
  ++calls.scene.facets_revision;
  EXPECT_EQ(calls.force_at({0.0525, 2.5e-3, 1e-3}).norm(), 0.) << "half a millimetre inside";
  EXPECT_EQ(calls.force_at({0.0525, 2.5e-3, 1e-3}).norm(), 0.);
  const double deeper = calls.force_at({0.0525, 2.5e-3, 0.9e-3})[2];
  EXPECT_NEAR(deeper, 1e6 * 0.1e-3, 1.) << "k = rho c^2 V^(1/3) times what it came deeper";
  EXPECT_EQ(calls.force_at({0.0525, 2.5e-3, 1.6e-3}).norm(), 0.);
  EXPECT_NEAR(calls.force_at({0.0525, 2.5e-3, 1e-3})[2], 1e6 * 0.5e-3, 1.) << "once out it is an ordinary point";
}

TEST(VanishingFacet, LooseNodesCountForNothing)
{
  Calls calls(strip());
  calls.scene.add_point({Point3(7.5e-3, 2.5e-3, 3e-3)});
  calls.force_at({7.5e-3, 2.5e-3, 3e-3});
  calls.scene.remove_facet(2);
  // nodes 3 and 7 are loose now: one flies to where the point is
  for (const std::size_t n : {3u, 7u})
    calls.scene.node[n].position = Point3(1., 0., 0.);
  const auto skipped = calls.contact.report().skipped;
  EXPECT_EQ(calls.force_at({1., 0., 0.}).norm(), 0.);
  EXPECT_EQ(calls.force_at({1., 0., 0.}).norm(), 0.);
  EXPECT_EQ(calls.contact.report().skipped, skipped + 2) << "apart from all that is left";
  EXPECT_GT(calls.force_at({2.5e-3, 2.5e-3, 1.4e-3})[2], 0.) << "and back";
}

TEST(VanishingFacet, NothingIsLeftInTheEnd)
{
  Calls calls(strip());
  calls.scene.add_point({Point3(2.5e-3, 2.5e-3, 1.2e-3)});
  calls.force_at({2.5e-3, 2.5e-3, 1.6e-3});
  EXPECT_GT(calls.force_at({2.5e-3, 2.5e-3, 1.2e-3}).norm(), 0.);
  for (int facet = 2; facet >= 0; --facet)
    {
      calls.scene.remove_facet(facet);
      EXPECT_EQ(calls.force_at({2.5e-3, 2.5e-3, 1.2e-3}).norm() > 0., facet > 0);
    }
  EXPECT_EQ(calls.force_at({2.5e-3, 2.5e-3, 0.}).norm(), 0.);
}

TEST(VanishingFacet, PiecesStayWhatTheyWere)
{
  FreeMasses      scene = strip();
  SurfaceTopology topology;
  topology.update(scene.facets());
  scene.remove_facet(1); // in two now, and still one piece
  EXPECT_EQ(topology.update(scene.facets()), SurfaceTopology::Change::facets);
  EXPECT_EQ(topology.piece(0), topology.piece(1));
  const std::array<double, 4> second_edge{0., 0.5, 0.5, 0.};
  EXPECT_TRUE(topology.is_on_rim(scene.facets(), 0, second_edge)) << "towards the facet that has gone";
}

TEST(VanishingFacet, WhatItsSpringHeldIsBookedAsDissipated)
{
  ContactParameters parameters;
  parameters.damping_scale = 0.;
  FreeMasses scene         = strip();
  scene.add_point({Point3(7.5e-3, 2.5e-3, 1.2e-3)});
  Contact    contact(parameters);
  ThreadPool pool;
  for (const double z : {1.6e-3, 1.1e-3, 1.1e-3})
    {
      scene.place(0, Point3(7.5e-3, 2.5e-3, z));
      scene.compute_contact(contact, dt, pool);
    }
  const double held = contact.report().stored_energy;
  EXPECT_NEAR(held, 0.5 * 1e6 * 0.4e-3 * 0.4e-3, 1e-9);
  EXPECT_EQ(contact.report().dissipated_energy, 0.);
  scene.remove_facet(1);
  scene.compute_contact(contact, dt, pool);
  EXPECT_EQ(contact.report().stored_energy, 0.);
  EXPECT_NEAR(contact.report().dissipated_energy, held, 1e-12);
  scene.remove_facet(1);
  scene.compute_contact(contact, dt, pool);
  EXPECT_NEAR(contact.report().dissipated_energy, held, 1e-12) << "once";
}
