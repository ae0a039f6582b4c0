#include "free_masses.h"

#include <birdstrike/contact/mass_in_the_way.h>

#include <gtest/gtest.h>

#include <array>
#include <numbers>

using namespace birdstrike;
using birdstrike::test::FreeMasses;

/// Points that fly one by one, evenly spread, at an edge: as many lose half of their normal speed, or more, as
/// are in the way of the true outline.
namespace
{
  constexpr double size = 1e-3, gap = 1e-4, speed = 20.; // m, m, m/s: d = L u/c is a fiftieth of a point's size

  /// Width of the beam, points of spacing `gap` about `centre` across the direction, that loses half of its normal
  /// speed or more.
  double stopped_width(FreeMasses scene, const Point3 &centre, const Point3 &direction, const Point3 &across,
                       const Point3 &normal, const double step = 4e-7)
  {
    constexpr int n = 40;
    for (int i = -n; i < n; ++i)
      scene.add_point({centre + (i + 0.5) * gap * across - 6e-3 * direction, speed * direction});
    scene.mass.assign(scene.id.size(), size * size * size * 1000.);
    Contact    contact{ContactParameters()};
    ThreadPool pool;
    scene.compute_contact(contact, step, pool);
    for (double time = 0.; time < 6.3e-4; time += step)
      scene.advance(contact, step, pool);
    int stopped = 0;
    for (std::size_t i = 0; i < scene.id.size(); ++i)
      stopped += -scene.velocity(i).dot(normal) < -0.5 * speed * direction.dot(normal);
    return stopped * gap - n * gap; // beyond `centre`
  }

  FreeMasses shell(const double thickness) // x 0 ... 20 mm, y 0 ... 20 mm
  {
    FreeMasses scene;
    scene.add_plate(4, 4, 5e-3, thickness);
    return scene;
  }
  const Point3 edge(0.02, 0.0077, 0.);

  /// Of paths at an angle to the normal of the face, outwards, m beyond the upper corner of the edge, which is what is
  /// seen along the path if the edge face is not in sight.
  double stopped_beyond_corner(const double thickness, const double degrees, const double step)
  {
    const double angle = degrees * std::numbers::pi / 180.;
    const Point3 direction(std::sin(angle), 0., -std::cos(angle)), across(std::cos(angle), 0., std::sin(angle));
    const Point3 corner = edge + Point3(0., 0., 0.5 * thickness);
    return stopped_width(shell(thickness), corner, direction, across, Point3::UnitZ(), step);
  }
} // namespace

TEST(Capture, OnTheFaceItEndsAtTheEdgeForAnyThickness)
{
  for (const double thickness : {0., 0.2e-3, 1e-3, 4e-3})
    for (const double degrees : {-60., -30., 0., 15.})
      EXPECT_NEAR(stopped_beyond_corner(thickness, degrees, 4e-7), 0., 0.12 * size) // spacing of the beam, and d
        << thickness << ' ' << degrees;
}

// What flies outwards the edge's plane sends on over the edge: up to a third of a size more than the outline lets pass,
// the same in any step.
TEST(Capture, OutwardsThePlaneLetsALittleMorePass)
{
  const std::array<std::array<double, 2>, 3> sizes_short{
    {{20., 0.3}, {30., 0.18}, {40., 0.06}}}; // by the angle, degrees
  for (const double thickness : {0., 0.2e-3, 1e-3, 4e-3})
    for (const auto &[degrees, sizes] : sizes_short)
      EXPECT_NEAR(stopped_beyond_corner(thickness, degrees, 4e-7), -sizes * size, 0.12 * size)
        << thickness << ' ' << degrees;
}

// The stand-off of what comes in through the plane is the height that it had there, not where a step ended.
TEST(Capture, IsTheSameInShorterSteps)
{
  for (const double degrees : {-60., -30., 0., 15., 20., 30., 40.})
    {
      const double width = stopped_beyond_corner(1e-3, degrees, 4e-7);
      for (const double step : {1e-7, 2.5e-8})
        EXPECT_NEAR(stopped_beyond_corner(1e-3, degrees, step), width, 0.5 * gap) << degrees << ' ' << step;
    }
}

TEST(Capture, OnTheEdgeFaceItIsTheThickness)
{
  for (const double thickness : {0.2e-3, 0.5e-3, 1e-3, 4e-3})
    {
      const double width =
        stopped_width(shell(thickness), edge, -Point3::UnitX(), Point3::UnitZ(), Point3::UnitX()) + 40 * gap;
      EXPECT_NEAR(width, thickness, 0.25 * size) << thickness; // some slip off it: d and a spacing on either side
    }
}

// A solid has a facet there; a shell's middle surface must not take the point for one that comes through a face.
TEST(Capture, BehindAShellsEdgeFaceItIsStillTheEdgeFaceThatHolds)
{
  FreeMasses   scene   = shell(4e-3);
  const Point3 corner  = edge + Point3(0., 0., 2e-3);
  const Point3 outside = corner + size * Point3(0.4, 0., 0.1);
  scene.add_point({outside});
  ContactParameters springs_alone;
  springs_alone.damping_scale = 0.;
  Contact          contact{springs_alone};
  ThreadPool       pool;
  constexpr double step     = 1e-7;
  const auto       force_at = [&](const Point3 &p) { // where it has flown to in this step
    const Point3 velocity = (p - scene.position(0)) / step;
    for (unsigned int d = 0; d < 3; ++d)
      scene.v[d][0] = velocity[d];
    scene.place(0, p);
    scene.compute_contact(contact, step, pool);
    return scene.force_on_point(0);
  };
  force_at(outside);
  double before = 0.;
  for (const double s : {0.3, 0.2, 0.1, 0.01, -0.01, -0.1, -0.2})
    {
      const Point3 force = force_at(corner + size * Point3(s, 0., -1.));
      EXPECT_GT(force[0], before) << s;
      EXPECT_LT(std::hypot(force[1], force[2]), 1e-12 * force[0]) << s;
      before = force[0];
    }
}

TEST(Capture, APlaneOfSymmetryIsNoEdge)
{
  FreeMasses scene = shell(1e-3);
  for (auto &neighbors : scene.neighbor)
    for (std::int32_t &neighbor : neighbors)
      neighbor = neighbor == FacetsView::free_edge ? FacetsView::symmetry_edge : neighbor;
  scene.add_point({Point3(0.01999, 0.0077, 0.95e-3)});
  scene.add_point({Point3(0.0111, 1e-5, 0.95e-3)});
  Contact    contact{ContactParameters()};
  ThreadPool pool;
  for (const double z : {1.1e-3, 0.95e-3})
    {
      for (std::size_t i = 0; i < 2; ++i)
        scene.place(i, Point3(scene.x[0][i], scene.x[1][i], z));
      scene.compute_contact(contact, 1e-7, pool);
    }
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_LT((scene.force_on_point(i) - Point3(0., 0., 1e6 * 0.05e-3)).norm(), 1e-6) << i;
}

TEST(Capture, TheShareInTheWayIsThatOfTheOutline)
{
  FreeMasses scene = shell(2e-3);
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 20; ++j)
      scene.add_point({Point3(0.02 + 1e-4 * (i - 49.5), 0.001 + 9e-4 * j, 0.1), Point3(0., 0., -50.)});
  EXPECT_NEAR(compute_share_in_the_way(scene.points(), scene.facets(), {0., 0., -50.}), 0.5,
              1e-12); // centres half a gap off the edge
  for (std::size_t i = 0; i < scene.id.size(); ++i)
    {
      scene.place(i, Point3(0.1, scene.x[1][i], 1e-4 * (static_cast<double>(i / 20) - 49.5)));
    }
  EXPECT_NEAR(compute_share_in_the_way(scene.points(), scene.facets(), {-50., 0., 0.}), 0.2, 1e-12); // 2 mm of 10
  EXPECT_EQ(compute_share_in_the_way(scene.points(), scene.facets(), {50., 0., 0.}), 0.);            // flying away
  EXPECT_EQ(compute_share_in_the_way(scene.points(), scene.facets(), {0., 0., 0.}), 0.);
}

// When points are sorted anew the search does not know how far they have come since the last call. Nor may it matter:
// the same points fly in over an edge, once sorted anew before every call, while the plate's far corner moves fast.
TEST(Capture, WhatTheSearchHasSeenMoveDecidesNothing)
{
  std::array<FreeMasses, 2> scenes;
  for (unsigned int k = 0; k < 2; ++k)
    {
      FreeMasses &scene = scenes[k];
      scene.add_plate(4, 4, 5e-3, 2e-4);
      scene.node.back().velocity = Point3(0., 0., 1500.);
      for (unsigned int n = 0; n < 40; ++n)
        scene.add_point({Point3(-1e-4 + 1e-5 * n, 6e-3 + 2e-4 * n, 2e-3 + 5e-5 * n), Point3(40., 0., -600.)});
      Contact    contact((ContactParameters()));
      ThreadPool pool;
      scene.compute_contact(contact, 1e-7, pool);
      for (unsigned int n = 0; n < 60; ++n)
        {
          scene.points_revision += k;
          scene.advance(contact, 1e-7, pool);
        }
    }
  for (std::size_t i = 0; i < scenes[0].id.size(); ++i)
    EXPECT_EQ(scenes[0].velocity(i), scenes[1].velocity(i)) << i;
}
