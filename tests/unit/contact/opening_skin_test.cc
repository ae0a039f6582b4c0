#include "free_masses.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

using namespace birdstrike;
using birdstrike::test::FreeMasses;
using birdstrike::test::h;
using birdstrike::test::k;

/// The skin of a solid of which cells fail: faces vanish under points, and others appear on nodes that were inside.
namespace
{
  constexpr double step = 1e-7, side = 2e-3;

  using Cell = std::array<unsigned int, 3>;

  /// Bricks of 2 mm, 3 x 3 in two layers, the upper one from z = 0 to 2 mm; all nodes are there from the first.
  struct Body
  {
    FreeMasses     scene;
    std::set<Cell> cells;
    Contact        contact;
    ThreadPool     pool;

    Body() : contact(make_parameters())
    {
      scene.two_sided = false;
      for (unsigned int z = 0; z <= 2; ++z)
        for (unsigned int y = 0; y <= 3; ++y)
          for (unsigned int x = 0; x <= 3; ++x)
            scene.node.push_back({Point3(side * x, side * y, side * z - side)});
      for (unsigned int z = 0; z < 2; ++z)
        for (unsigned int y = 0; y < 3; ++y)
          for (unsigned int x = 0; x < 3; ++x)
            cells.insert({x, y, z});
      make_skin();
    }

    static ContactParameters make_parameters()
    {
      ContactParameters parameters;
      parameters.damping_scale = 0.;
      return parameters;
    }

    void fail(const Cell &cell)
    {
      cells.erase(cell);
      make_skin();
      ++scene.facets_revision;
    }

    /// Faces of which the cell on the other side is not there; two facets at every edge (cells here share faces).
    void make_skin()
    {
      scene.facet.clear();
      for (const Cell &cell : cells)
        for (unsigned int d = 0; d < 3; ++d)
          for (const unsigned int end : {0u, 1u})
            {
              Cell other = cell;
              other[d] += end == 1 ? 1 : -1;
              if (cells.contains(other))
                continue;
              const unsigned int           i = (d + 1) % 3, j = (d + 2) % 3;
              std::array<std::uint32_t, 4> nodes;
              for (unsigned int n = 0; n < 4; ++n)
                {
                  Cell x = cell;
                  x[d] += end;
                  x[end == 1 ? i : j] += n == 1 || n == 2;
                  x[end == 1 ? j : i] += n >= 2;
                  nodes[n] = x[0] + 4 * (x[1] + 4 * x[2]);
                }
              scene.facet.push_back(nodes);
            }
      scene.half_thickness.assign(scene.facet.size(), 0.);
      scene.neighbor.assign(scene.facet.size(), {{-1, -1, -1, -1}});
      std::map<std::array<std::uint32_t, 2>, std::pair<std::int32_t, unsigned int>> side_of;
      for (std::size_t f = 0; f < scene.facet.size(); ++f)
        for (unsigned int side = 0; side < 4; ++side)
          side_of[{{scene.facet[f][side], scene.facet[f][(side + 1) % 4]}}] = {static_cast<std::int32_t>(f), side};
      for (const auto &[nodes, side] : side_of)
        scene.neighbor[side.first][side.second] = side_of.at({{nodes[1], nodes[0]}}).first;
    }

    Point3 force_at(const Point3 &position)
    {
      scene.fly_to(0, position, step);
      scene.compute_contact(contact, step, pool);
      return scene.force_on_point(0);
    }

    /// Of a point that has come down from 1 mm above z = 2 mm there.
    Point3 come_down_to(const Point3 &position)
    {
      if (scene.id.empty())
        scene.add_point({position});
      for (double z = 2e-3 + 2. * h; z > position[2]; z -= 0.05e-3)
        force_at({position[0], position[1], z});
      return force_at(position);
    }
  };

  const Cell middle{1, 1, 1}; // of the upper layer: x and y from 2 to 4 mm, z from 0 to 2 mm
} // namespace

TEST(OpeningSkin, WhereACellFailsTheForceIsNoLargerThanBefore)
{
  for (const double x : {2.05e-3, 2.3e-3, 3e-3, 3.9e-3})
    for (const double y : {2.1e-3, 3e-3})
      for (const double z : {2.4e-3, 2.1e-3, 1.9e-3}) // the last has come through the skin
        {
          Body         body;
          const Point3 before = body.come_down_to({x, y, z});
          EXPECT_NEAR(before[2], k * (2e-3 + h - z), 1e-6 * k * h);
          body.fail(middle);
          const Point3 after = body.force_at({x, y, z});
          for (unsigned int d = 0; d < 3; ++d) // of two walls each pushes no more than the skin did
            EXPECT_LE(std::abs(after[d]), before.norm() * (1. + 1e-9)) << x << ' ' << y << ' ' << z;
          const double from_wall = std::hypot(std::min(x - 2e-3, 4e-3 - x), std::max(z - 2e-3, 0.));
          const double from_next = std::hypot(std::min(y - 2e-3, 4e-3 - y), std::max(z - 2e-3, 0.));
          EXPECT_TRUE(after.norm() == 0. || std::min(from_wall, from_next) < h)
            << "floor out of reach: walls alone push";
        }
}

TEST(OpeningSkin, FloorAndWallsOfTheHoleAreSkin)
{
  Body body;
  body.come_down_to({3e-3, 3e-3, 2.2e-3});
  body.fail(middle);
  EXPECT_EQ(body.force_at({3e-3, 3e-3, 1.8e-3}).norm(), 0.);
  for (double z = 1.8e-3; z > 0.3e-3; z -= 0.05e-3)
    body.force_at({3e-3, 3e-3, z});
  const Point3 floor = body.force_at({3e-3, 3e-3, 0.3e-3});
  EXPECT_LT((floor - Point3(0., 0., k * 0.2e-3)).norm(), 1e-6 * k * h) << "all of its nodes were inside";
  for (double x = 3e-3; x > 2.4e-3; x -= 0.05e-3)
    body.force_at({x, 3e-3, 1e-3});
  const Point3 wall = body.force_at({2.4e-3, 3e-3, 1e-3});
  EXPECT_LT((wall - Point3(k * 0.1e-3, 0., 0.)).norm(), 1e-6 * k * h);
  // and on through the floor, when that fails too
  body.fail({1, 1, 0});
  for (double z = 1e-3; z > -2e-3 - 2. * h; z -= 0.05e-3)
    EXPECT_EQ(body.force_at({3e-3, 3e-3, z}).norm(), 0.) << z;
}

// What sat inside the body, never seen outside (a particle packed into the blade), is not shot out of the hole: what a
// new face overlaps of it is its reference.
TEST(OpeningSkin, NothingIsPushedByAFaceThatFindsItInside)
{
  Body         body;
  const Point3 inside(2.3e-3, 3e-3, 0.9e-3);
  body.scene.add_point({inside});
  EXPECT_EQ(body.force_at(inside).norm(), 0.);
  EXPECT_EQ(body.force_at(inside).norm(), 0.);
  body.fail(middle);
  EXPECT_EQ(body.force_at(inside).norm(), 0.) << "0.2 mm into the wall's reach";
  EXPECT_EQ(body.force_at(inside).norm(), 0.);
  EXPECT_NEAR(body.force_at({2.2e-3, 3e-3, 0.9e-3})[0], k * 0.1e-3, 1.) << "what it comes deeper does";
  EXPECT_EQ(body.force_at({2.6e-3, 3e-3, 0.9e-3}).norm(), 0.);
  body.force_at({2.3e-3, 3e-3, 0.9e-3});
  EXPECT_NEAR(body.force_at({2.3e-3, 3e-3, 0.9e-3})[0], k * 0.2e-3, 1.) << "once out it is an ordinary point";
}
