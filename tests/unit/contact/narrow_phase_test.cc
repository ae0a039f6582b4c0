#include "free_masses.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace birdstrike;
using birdstrike::test::FreeMasses;
using birdstrike::test::g;
using birdstrike::test::plate_of_four;
using birdstrike::test::without_damper;

namespace
{
  /// Forces along a path of one point at rest; the first place of the path must be out of touch.
  std::vector<Point3> sweep(FreeMasses &scene, const std::vector<Point3> &path)
  {
    Contact    contact(without_damper());
    ThreadPool pool;
    scene.add_point({path.front()});
    std::vector<Point3> forces;
    for (const Point3 &place : path)
      {
        scene.place(0, place);
        scene.compute_contact(contact, 1e-7, pool);
        forces.push_back(scene.force_on_point(0));
      }
    return forces;
  }

  /// F8: from one place to the next no more than 1 % of the largest force.
  void expect_continuous(const std::vector<Point3> &forces, const std::size_t begin)
  {
    double largest = 0.;
    for (const Point3 &force : forces)
      largest = std::max(largest, force.norm());
    ASSERT_GT(largest, 0.);
    for (std::size_t k = begin + 1; k < forces.size(); ++k)
      EXPECT_LT((forces[k] - forces[k - 1]).norm(), 0.01 * largest) << k;
  }

  std::vector<Point3> line(const Point3 &from, const Point3 &to, const unsigned int n)
  {
    std::vector<Point3> path;
    for (unsigned int k = 0; k <= n; ++k)
      path.push_back(from + (to - from) * (double(k) / n));
    return path;
  }
  std::vector<Point3> lowered_then(std::vector<Point3> path, const Point3 &start)
  {
    path.insert(path.begin(), start);
    return path;
  }
} // namespace

TEST(NarrowPhase, SweptAcrossACommonEdgeTheForceIsTheSame)
{
  FreeMasses scene = plate_of_four();
  const auto forces =
    sweep(scene, lowered_then(line({0.005, 0.004, 0.8 * g}, {0.015, 0.0045, 0.8 * g}, 1001), {0.005, 0.004, 2e-3}));
  for (std::size_t k = 1; k < forces.size(); ++k)
    EXPECT_NEAR((forces[k] - Point3(0., 0., 1e6 * 0.2 * g)).norm(), 0., 1e-7); // k d; round-off
}

TEST(NarrowPhase, SweptAcrossAVertexAndAWarpedFoldTheForceIsContinuous)
{
  FreeMasses plate = plate_of_four();
  for (const Point3 &force :
       sweep(plate, lowered_then(line({0.005, 0.005, 0.8 * g}, {0.015, 0.015, 0.8 * g}, 1000), {0.005, 0.005, 2e-3})))
    EXPECT_TRUE(force[2] == 0. || std::abs(force[2] - 1e6 * 0.2 * g) < 1e-7);

  // a roof of 20 degrees, convex towards the point
  const auto roof = [](const double twist) {
    FreeMasses scene;
    scene.add_patch(2, 2, 2e-3, [&](const unsigned int i, const unsigned int j) {
      return Point3(0.01 * i, 0.01 * j, (i == 1 ? 0.00176 : 0.) - (i == 2 && j == 2 ? twist : 0.));
    });
    return scene;
  };
  const auto path  = lowered_then(line({0.004, 0.008, 2.3e-3}, {0.016, 0.0125, 2.3e-3}, 3000), {0.004, 0.008, 8e-3});
  FreeMasses plane = roof(0.), warped = roof(3e-4);
  expect_continuous(sweep(plane, path), 1);

  // in a hollow kink the direction turns by the kink's angle, here below 0.03; the magnitude is continuous
  auto forces = sweep(warped, path);
  for (std::size_t k = 2; k < forces.size(); ++k)
    EXPECT_LT((forces[k] - forces[k - 1]).norm(), 0.03 * forces[k].norm() + 10.) << k;
  for (Point3 &force : forces)
    force = Point3(0., 0., force.norm());
  expect_continuous(forces, 1);
}

TEST(NarrowPhase, OverAFreeEdgeTheForceEndsWithoutAJump)
{
  // straight out over the edge x = 0.02: the plane through the edge bounds the depth, and beyond it there is nothing
  FreeMasses scene = plate_of_four();
  const auto forces =
    sweep(scene, lowered_then(line({0.018, 0.004, 0.8 * g}, {0.022, 0.004, 0.8 * g}, 2000), {0.018, 0.004, 2e-3}));
  for (std::size_t k = 1; k < forces.size(); ++k)
    {
      const double s = 0.018 + 2e-6 * (static_cast<double>(k) - 1.) - 0.02, z = 0.8 * g - 1e-3;
      const double bevel = std::max(0., -(s + z) * std::sqrt(0.5));
      EXPECT_NEAR(forces[k].norm(), 1e6 * std::min(0.2 * g, bevel), 1e-6) << s; // round-off of 1e6 N/m
    }
}

TEST(NarrowPhase, AFastPointIsPushedBackToItsOwnSide)
{
  for (const double z : {0.9, 0.3, 1e-12, 0., -1e-12, -0.3, -0.9})
    {
      FreeMasses scene = plate_of_four();
      scene.add_point({Point3(0.0133, 0.0071, 1.2 * g), Point3(0., 0., -500.)});
      Contact    contact(without_damper());
      ThreadPool pool;
      scene.compute_contact(contact, 5e-6, pool);
      scene.place(0, Point3(0.0133, 0.0071, z * g));
      scene.compute_contact(contact, 5e-6, pool);
      EXPECT_GT(scene.force_on_point(0)[2], 0.) << z;
      EXPECT_NEAR(contact.report().penetration, (1. - z) * g, 1e-12);
    }
}

TEST(NarrowPhase, ASideIsForgottenWhenThePointHasLeft)
{
  FreeMasses scene = plate_of_four();
  scene.add_point({Point3(0.01, 0.01, 0.9 * g)});
  Contact    contact(without_damper());
  ThreadPool pool;
  for (const double z : {2., 0.9, 2., 10.})
    {
      scene.place(0, Point3(0.0133, 0.0071, z * g));
      scene.compute_contact(contact, 1e-7, pool);
    }
  for (const double z : {-10., -1.5, -0.9}) // it flew round and comes from below
    {
      scene.place(0, Point3(0.0133, 0.0071, z * g));
      scene.compute_contact(contact, 1e-7, pool);
    }
  EXPECT_LT(scene.force_on_point(0)[2], 0.);
  EXPECT_NEAR(contact.report().penetration, 0.1 * g, 1e-12);
}

TEST(NarrowPhase, SidesFollowTheIdentityThroughASort)
{
  FreeMasses scene = plate_of_four();
  scene.add_point({Point3(0.004, 0.004, 1.2 * g), Point3(0., 0., -500.)});
  scene.add_point({Point3(0.016, 0.004, -1.2 * g), Point3(0., 0., 500.)});
  Contact    contact(without_damper());
  ThreadPool pool;
  scene.compute_contact(contact, 5e-6, pool);
  // both pass the middle surface in the step in which they are sorted
  std::swap(scene.id[0], scene.id[1]);
  std::swap(scene.v[2][0], scene.v[2][1]);
  scene.place(0, Point3(0.016, 0.004, 0.2 * g));
  scene.place(1, Point3(0.004, 0.004, -0.2 * g));
  ++scene.points_revision;
  scene.compute_contact(contact, 5e-6, pool);
  EXPECT_LT(scene.force_on_point(0)[2], 0.);
  EXPECT_GT(scene.force_on_point(1)[2], 0.);
}

TEST(NarrowPhase, PointsExactlyOnEdgeAndVertexAndNearTheRimAreStopped)
{
  // D5: fast points, flown at a facet's middle, a common edge, a vertex of a thin shell, 500 m/s. Half of one that is
  // flown at a free edge is in the way: it may go by
  FreeMasses scene;
  scene.add_plate(2, 2, 0.01, 1e-4);
  for (const auto &[x, y] : {std::pair{0.005, 0.005},
                             {0.01, 0.005},
                             {0.01, 0.01},
                             {0.019, 0.01},
                             {0.019, 0.005},
                             {0.019, 0.019},
                             {0.001, 0.001}})
    for (const double side : {1., -1.})
      scene.add_point({Point3(x, y, 1.5e-3 * side), Point3(0., 0., -500. * side)});
  Contact      contact{ContactParameters()};
  ThreadPool   pool;
  const double step = 0.5 * 1.3e-3 / (1000. + 1.2 * 500.);
  scene.compute_contact(contact, step, pool);
  for (unsigned int n = 0; n < 400; ++n)
    scene.advance(contact, step, pool);
  EXPECT_LT(contact.report().max_penetration_over_spacing, 0.25);
  for (std::size_t i = 0; i < scene.id.size(); ++i)
    EXPECT_GT(scene.x[2][i] * (i % 2 == 0 ? 1. : -1.), 0.45e-3) << i;
}

TEST(NarrowPhase, PointsOnTheSurfaceItselfAreSentBack)
{
  // no distance, no direction: the facet's normal takes its place, against the velocity
  for (const auto &[x, y] : {std::pair{0.005, 0.005}, {0.01, 0.005}, {0.01, 0.01}, {0.02, 0.005}, {0.02, 0.02}})
    {
      FreeMasses scene = plate_of_four();
      scene.add_point({Point3(0.2, 0.2, 0.2)}); // keeps the first call from making a reference
      scene.add_point({Point3(x, y, 3e-3), Point3(0., 0., -500.)});
      Contact    contact{ContactParameters()};
      ThreadPool pool;
      scene.compute_contact(contact, 1e-7, pool);
      scene.place(1, Point3(x, y, 0.));
      scene.compute_contact(contact, 1e-7, pool);
      const bool   is_on_rim = x == 0.02; // there the edge face stands in the way, and its direction is outwards
      const Point3 force     = scene.force_on_point(1);
      EXPECT_GT(force[is_on_rim ? 0 : 2], 0.) << x << ' ' << y;
      EXPECT_NEAR(force[is_on_rim ? 2 : 0], 0., 1e-9 * force.norm());
    }
}

TEST(NarrowPhase, BothFacesOfAThinShellAtOnceCancel)
{
  FreeMasses scene;
  scene.add_plate(2, 2, 0.01, 1e-4);
  for (auto &node : scene.node)
    node.inverse_mass = 1e5;
  for (unsigned int i = 1; i < 10; ++i)
    for (unsigned int j = 1; j < 10; ++j)
      for (const double side : {1., -1.})
        scene.add_point({Point3(2e-3 * i, 2e-3 * j, 6e-4 * side), Point3(0., 0., -200. * side)});
  Contact    contact{ContactParameters()};
  ThreadPool pool;
  scene.compute_contact(contact, 2e-7, pool);
  double impulse = 0.;
  for (unsigned int n = 0; n < 100; ++n)
    {
      scene.advance(contact, 2e-7, pool);
      EXPECT_LT(Point3(contact.report().force.data()).norm(), 1e-10 * (1. + std::abs(scene.point_force[2][0]) * 162));
      impulse += 2e-7 * scene.point_force[2][0];
    }
  EXPECT_GT(impulse, 1e-6 * 200.); // F9: each point is thrown back, the shell stays
  for (const auto &node : scene.node)
    EXPECT_NEAR(node.velocity[2], 0., 1e-10 * 200.);
}

TEST(NarrowPhase, BetweenTwoShellsBothPush)
{
  FreeMasses scene;
  scene.add_plate(2, 2, 0.01, 2e-3, Point3(0., 0., 0.));
  scene.add_plate(2, 2, 0.01, 2e-3, Point3(0., 0., 2. * g - 4e-4)); // 0.2 mm too narrow on either side
  scene.add_point({Point3(0.005, 0.004, g - 2e-4)});
  Contact    contact(without_damper());
  ThreadPool pool;
  scene.place(0, Point3(0.1, 0.1, 0.1));
  scene.compute_contact(contact, 1e-7, pool);
  double last = 0.;
  for (const double shift : {-1e-4, -5e-5, 0., 5e-5, 1e-4})
    {
      scene.place(0, Point3(0.005, 0.004, g - 2e-4 + shift));
      scene.compute_contact(contact, 1e-7, pool);
      EXPECT_EQ(contact.report().n_touching, 2u);
      EXPECT_NEAR(scene.force_on_point(0)[2], -2e6 * shift, 1e-6); // two springs
      last = contact.report().stored_energy;
    }
  EXPECT_NEAR(last, 0.5e6 * (1e-8 + 9e-8), 1e-9);
}

TEST(NarrowPhase, ANotchPushesWithBothFlanksAndASlightFoldWithOne)
{
  for (const double angle : {0.5 * std::numbers::pi, 0.1})
    {
      FreeMasses scene;
      scene.add_patch(2, 1, 2e-3, [&](const unsigned int i, const unsigned int j) {
        const double along = 0.01 * i - 0.01;
        return Point3(i < 2 ? along : 0.01 * std::cos(angle), 0.01 * j, i < 2 ? 0. : 0.01 * std::sin(angle));
      });
      // fast enough to have come that deep within the step: a second sheet of one surface is met as it is reached
      scene.add_point({Point3(0.2, 0.2, 0.2), Point3(1500., 0., -1500.)});
      Contact    contact(without_damper());
      ThreadPool pool;
      scene.compute_contact(contact, 1e-7, pool);
      // on the bisector, 0.1 mm deep in either flank
      const double depth = (g - 1e-4) / std::cos(0.5 * angle);
      scene.place(0, Point3(-depth * std::sin(0.5 * angle), 0.005, depth * std::cos(0.5 * angle)));
      scene.compute_contact(contact, 1e-7, pool);
      EXPECT_EQ(contact.report().n_touching, angle > 1. ? 2u : 1u);
      const double share = 0.5 * (1. + 1e-4 / (1500. * 1e-7)); // it touches within the step
      EXPECT_NEAR(scene.force_on_point(0).norm(), share * 1e6 * 1e-4 * (angle > 1. ? std::sqrt(2.) : 1.), 1e-6);
    }
}

TEST(NarrowPhase, AOneSidedSurfaceIsSeenFromOutsideOnly)
{
  FreeMasses scene = plate_of_four();
  scene.two_sided  = false;
  scene.add_point({Point3(0.005, 0.005, -0.5 * g)});
  scene.add_point({Point3(0.015, 0.005, 0.9 * g), Point3(0., 0., -100.)});
  Contact    contact(without_damper());
  ThreadPool pool;
  scene.compute_contact(contact, 1e-7, pool);
  scene.fly_to(0, Point3(0.005, 0.005, -0.4 * g), 1e-7);
  scene.fly_to(1, Point3(0.015, 0.005, -0.1 * g), 1e-7);
  scene.compute_contact(contact, 1e-7, pool);
  EXPECT_EQ(scene.force_on_point(0).norm(), 0.);
  EXPECT_NEAR(scene.force_on_point(1)[2], 1e6 * 1. * g, 1e-6); // from 0.9 g, its reference, to -0.1 g
}
