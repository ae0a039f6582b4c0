#include "free_masses.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

using namespace birdstrike;
using birdstrike::test::FreeMasses;
using birdstrike::test::h;
using birdstrike::test::k;
using birdstrike::test::without_damper;

/// The skin of a solid: closed, one-sided, with edges and side faces narrower than a point.
namespace
{
  /// Neighbours across the edges that two facets share.
  void connect(FreeMasses &scene)
  {
    std::map<std::array<std::uint32_t, 2>, std::pair<std::int32_t, unsigned int>> open;
    scene.neighbor.assign(scene.facet.size(), {{-1, -1, -1, -1}});
    for (std::size_t f = 0; f < scene.facet.size(); ++f)
      for (unsigned int side = 0; side < 4; ++side)
        {
          const std::uint32_t a = scene.facet[f][side], b = scene.facet[f][(side + 1) % 4];
          if (const auto other = open.find({{b, a}}); other != open.end())
            {
              scene.neighbor[f][side]                                   = other->second.first;
              scene.neighbor[other->second.first][other->second.second] = static_cast<std::int32_t>(f);
              open.erase(other);
            }
          else
            open[{{a, b}}] = {static_cast<std::int32_t>(f), side};
        }
    ASSERT_TRUE(open.empty()) << "the skin is not closed";
  }

  /// A box [0, length]^2 x [0, thickness] of n x n x 1 bricks: its skin, facets counter-clockwise about the outside.
  FreeMasses box(const double length, const double thickness, const unsigned int n)
  {
    FreeMasses scene;
    scene.two_sided         = false;
    const std::uint32_t top = (n + 1) * (n + 1);
    for (const double z : {0., thickness})
      for (unsigned int j = 0; j <= n; ++j)
        for (unsigned int i = 0; i <= n; ++i)
          scene.node.push_back({Point3(length * i / n, length * j / n, z)});
    const auto at = [n](const unsigned int i, const unsigned int j) { return j * (n + 1) + i; };
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          const std::array<std::uint32_t, 4> q{{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}};
          scene.facet.push_back({{q[0] + top, q[1] + top, q[2] + top, q[3] + top}});
          scene.facet.push_back({{q[0], q[3], q[2], q[1]}});
        }
    const auto wall = [&](const std::uint32_t a, const std::uint32_t b) { // the outside on the right of a -> b
      scene.facet.push_back({{a, b, b + top, a + top}});
    };
    for (unsigned int i = 0; i < n; ++i)
      {
        wall(at(i, 0), at(i + 1, 0));
        wall(at(n, i), at(n, i + 1));
        wall(at(n - i, n), at(n - i - 1, n));
        wall(at(0, n - i), at(0, n - i - 1));
      }
    scene.half_thickness.assign(scene.facet.size(), 0.);
    connect(scene);
    return scene;
  }

  /// Distance from the box, negative inside.
  double distance_from_box(const Point3 &p, const double length, const double thickness)
  {
    const Point3 half(0.5 * length, 0.5 * length, 0.5 * thickness);
    const Point3 q       = (p - half).cwiseAbs() - half;
    const double outside = q.cwiseMax(0.).norm();
    return outside > 0. ? outside : q.maxCoeff();
  }
} // namespace

// Out over an edge from a face, narrower than the point or not: the plane that halves the angle bounds the depth.
TEST(ClosedSkin, OutOverAnEdgeTheForceEndsAtThePlaneThatHalvesIt)
{
  for (const double thickness : {0.2e-3, 0.5e-3, 4e-3})
    for (const double y : {0.0071, 0.01, 0.0133}) // the middle one on a line of nodes
      {
        FreeMasses scene = box(0.02, thickness, 4);
        scene.add_point({Point3(0.019, y, thickness + 2. * h)});
        Contact    contact(without_damper());
        ThreadPool pool;
        scene.compute_contact(contact, 1e-7, pool);
        for (double s = -1e-3; s < h; s += 2e-5)
          {
            scene.place(0, Point3(0.02 + s, y, thickness + 0.8 * h));
            scene.compute_contact(contact, 1e-7, pool);
            const double bevel = std::max(0., -(s + 0.8 * h) * std::sqrt(0.5));
            ASSERT_NEAR(scene.force_on_point(0).norm(), k * std::min(0.2 * h, bevel), 1e-6 * k * h) << s;
          }
      }
}

TEST(ClosedSkin, BeyondACornerNothingIsInTheWay)
{
  FreeMasses scene = box(0.02, 0.5e-3, 4);
  scene.add_point({Point3(0.021, 0.021, 2e-3)});
  Contact    contact(without_damper());
  ThreadPool pool;
  scene.compute_contact(contact, 1e-7, pool);
  for (double a = 0.05; a < 0.5 * std::numbers::pi; a += 0.05)
    for (double b = 0.05; b < 0.5 * std::numbers::pi; b += 0.05)
      {
        const Point3 direction(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
        scene.place(0, Point3(0.02, 0.02, 0.5e-3) + 0.7 * h * direction);
        scene.compute_contact(contact, 1e-7, pool);
        ASSERT_EQ(scene.force_on_point(0).norm(), 0.) << direction;
      }
}

// D5 on a skin: fast points at faces, beside edges and corners, and at the side face, 0.5 mm wide: none gets in. What
// is flown past an edge by less than half a spacing slides on, as near to the face as it came.
TEST(ClosedSkin, FastPointsAreStoppedOutside)
{
  constexpr double length = 0.02, thickness = 0.5e-3, speed = 400.;
  FreeMasses       scene = box(length, thickness, 4);
  const Point3     centre(0.5 * length, 0.5 * length, 0.5 * thickness);
  for (const double x : {0., 0.005, 0.0071, 0.02})
    for (const double y : {0., 0.01, 0.0133, 0.02})
      for (const double side : {1., -1.})
        scene.add_point(
          {Point3(x, y, 0.5 * thickness + (0.5 * thickness + 1.05 * h) * side), Point3(0., 0., -speed * side)});
  for (const double y : {-1e-4, 0., 0.003, 0.005, 0.011, 0.02})
    for (const double z : {-0.2e-3, 0., 0.1e-3, 0.25e-3, 0.5e-3, 0.7e-3})
      for (const double side : {1., -1.})
        scene.add_point({Point3(0.5 * length + (0.5 * length + 1.05 * h) * side, y, z), Point3(-speed * side, 0., 0.)});
  Contact      contact{ContactParameters()};
  ThreadPool   pool;
  const double step = 0.4 * 1.3e-3 / (1000. + 1.2 * speed);
  scene.compute_contact(contact, step, pool);
  for (unsigned int n = 0; n < 300; ++n)
    {
      scene.advance(contact, step, pool);
      for (std::size_t i = 0; i < scene.id.size(); ++i)
        ASSERT_GT(distance_from_box(scene.position(i), length, thickness), -0.1e-3) << i << ", step " << n;
    }
  EXPECT_LT(contact.report().max_penetration_over_spacing, 0.3);
  EXPECT_GT(contact.report().max_penetration_over_spacing, 0.05);
  EXPECT_GE(contact.report().touches, scene.id.size() / 2); // some pass beside the corners
  EXPECT_EQ(contact.report().n_touching, 0u);
}

// Passing points give back what the spring took: the law has a potential all around the skin.
TEST(ClosedSkin, PassingPointsGainNoEnergy)
{
  constexpr double thickness = 0.5e-3;
  FreeMasses       scene     = box(0.02, thickness, 4);
  for (unsigned int n = 0; n < 200; ++n)
    {
      const double      up = n % 2 == 0 ? 1. : -1.;
      FreeMasses::Point point;
      point.position = Point3(0.02 + (1.45 + 0.002 * n) * h, 0.0012 + 8e-5 * n, 0.5 * thickness - 2.5 * h * up);
      point.velocity = Point3(-100., 20., 200. * up);
      scene.add_point(point);
    }
  Contact    contact(without_damper());
  ThreadPool pool;
  scene.compute_contact(contact, 5e-9, pool);
  for (unsigned int n = 0; n < 6000; ++n)
    scene.advance(contact, 5e-9, pool);
  EXPECT_GT(contact.report().max_penetration, 0.05e-3);
  EXPECT_EQ(contact.report().n_touching, 0u);
  const double speed = std::sqrt(100. * 100. + 20. * 20. + 200. * 200.);
  for (std::size_t i = 0; i < scene.id.size(); ++i)
    EXPECT_NEAR(scene.velocity(i).norm() / speed, 1., 2e-3) << i; // as at a shell's free edge
}

// Pushed through the skin, and nearer to the face behind than to the one it came through: it is pushed back, not out
// at the back, and by one face only.
TEST(ClosedSkin, APointThatCameThroughIsPushedBackToWhereItCameFrom)
{
  constexpr double thickness = 0.5e-3;
  for (const double side : {1., -1.})
    for (const double depth : {0.1e-3, 0.24e-3, 0.26e-3, 0.4e-3}) // of the centre, below the skin
      {
        FreeMasses scene = box(0.02, thickness, 4);
        const auto at    = [&](const double d) {
          return Point3(0.0071, 0.0133, 0.5 * thickness + (0.5 * thickness - d) * side);
        };
        scene.add_point({at(-2. * h), Point3(0., 0., -100. * side)});
        Contact    contact(without_damper());
        ThreadPool pool;
        scene.compute_contact(contact, 1e-7, pool);
        for (const double d : {-0.5 * h, depth, depth})
          {
            scene.fly_to(0, at(d), 1e-7);
            scene.compute_contact(contact, 1e-7, pool);
            EXPECT_EQ(contact.report().n_touching, 1u);
            const double share = d < 0. ? 0.5 * (1. + 0.5 / 1.5) : 1.; // the touch begins within the step
            EXPECT_NEAR(scene.force_on_point(0)[2] * side, share * k * (h + d), 1e-9 * k) << depth;
          }
      }
}

TEST(ClosedSkin, APointNeverSeenOutsideIsLeftAlone)
{
  FreeMasses scene = box(0.02, 4e-3, 4);
  scene.add_point({Point3(0.01, 0.0071, 1e-3)});
  Contact    contact(without_damper());
  ThreadPool pool;
  for (const double z : {0.3e-3, 0.2e-3, 3.9e-3})
    {
      scene.place(0, Point3(0.01, 0.0071, z));
      scene.compute_contact(contact, 1e-7, pool);
      EXPECT_EQ(scene.force_on_point(0).norm(), 0.);
    }
}

// Points on a ridge between faces whose normals part by 63 degrees, all nodes free: the depth is bounded by a plane
// that turns with both faces and moves as they open, and each pays for its part. Without their couples a fifteenth of
// what the spring holds came from nowhere.
TEST(ClosedSkin, ARidgeThatTurnsAndOpensMakesNoEnergy)
{
  for (const double s : {-0.2e-3, -0.4e-3, -0.6e-3})
    {
      FreeMasses scene = box(3e-3, 2e-3, 1);
      for (std::size_t n = 0; n < scene.node.size(); ++n)
        {
          scene.node[n].inverse_mass = 1. / 1e-5;
          if (n >= 4)
            scene.node[n].position[0] -= 1e-3;
        }
      scene.add_point({Point3(2e-3 + s, 1.2e-3, 2.55e-3), Point3(100., 0., -200.)});
      Contact    contact(without_damper());
      ThreadPool pool;
      scene.compute_contact(contact, 1e-8, pool);
      double stored = 0., made = 0.;
      for (unsigned int n = 0; n < 3000; ++n)
        {
          scene.advance(contact, 1e-8, pool);
          stored = std::max(stored, contact.report().stored_energy);
          made   = std::max(made, std::abs(scene.contact_work + contact.report().stored_energy));
        }
      EXPECT_GT(stored, 0.02 * k * h * h) << s;
      EXPECT_LT(made, 0.02 * stored) << s;
    }
}

// A plate of a fifth of a point: those that come down on its rim are through before the edge's plane has turned them
// out, and come to the face behind. What the springs held by then is lost, and told.
TEST(ClosedSkin, WhatSpringsLoseWherePointsComeThroughARimIsTold)
{
  constexpr double length = 0.02, thickness = 0.2e-3, speed = 500.;
  FreeMasses       scene = box(length, thickness, 4);
  for (unsigned int i = 0; i < 8; ++i)
    scene.add_point({Point3(length - 0.1 * h * i, 0.0011 * (i + 4), thickness + 1.02 * h), Point3(0., 0., -speed)});
  Contact    contact(without_damper());
  ThreadPool pool;
  scene.compute_contact(contact, 1e-9, pool);
  const auto kinetic = [&] {
    double sum = 0.;
    for (std::size_t i = 0; i < scene.id.size(); ++i)
      sum += 0.5 * scene.mass[i] * scene.velocity(i).squaredNorm();
    return sum;
  };
  const double before = kinetic();
  for (unsigned int n = 0; n < 6000; ++n)
    scene.advance(contact, 1e-9, pool);
  const ContactReport &report = contact.report();
  EXPECT_EQ(report.n_touching, 0u);
  EXPECT_GT(report.released_energy, 0.02 * before);
  EXPECT_EQ(report.dissipated_energy, report.released_energy);
  // a thousandth of the size each time a depth changes carrier is taken for the point's way: 0.2 % of it
  EXPECT_NEAR(kinetic() + report.released_energy, before, 5e-3 * before);
}
