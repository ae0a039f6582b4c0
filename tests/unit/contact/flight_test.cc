#include "free_masses.h"

#include <birdstrike/contact/flight.h>

#include <gtest/gtest.h>

#include <numbers>
#include <random>

using namespace birdstrike;
using birdstrike::test::FreeMasses;
using birdstrike::test::g;

namespace
{
  double flight(const Point3 &from, const Point3 &velocity)
  {
    FreeMasses scene;
    scene.add_plate(6, 4, 0.01, 2e-3); // x 0 ... 60 mm, y 0 ... 40 mm
    scene.add_point({from, velocity});
    return time_to_first_touch(scene.points(), scene.facets());
  }
} // namespace

TEST(Flight, AgainstAFaceItIsGapOverNormalSpeed)
{
  EXPECT_NEAR(flight({0.022, 0.013, 0.1}, {0., 0., -177.4}), (0.1 - g) / 177.4, 1e-15);
  const double angle = 36.4 * std::numbers::pi / 180.;
  EXPECT_NEAR(flight({0.022, -0.1, 0.1}, 302.1 * Point3(0., std::cos(angle), -std::sin(angle))),
              (0.1 - g) / (302.1 * std::sin(angle)), 1e-15);
  EXPECT_NEAR(flight({0.022, 0.013, -0.1}, {0., 0., 177.4}), (0.1 - g) / 177.4, 1e-15); // from below
}

// Half a spacing before the edge face, and where the plane at 45 degrees through its edges z = +-1 mm stands nearer,
// there; on the diagonal at a corner likewise.
TEST(Flight, AgainstAFreeEdgeAndACornerItEndsWhereTheEdgeFaceIs)
{
  for (const auto &[height, before] :
       {std::pair{0., 0.5e-3}, {0.6e-3, 0.4e-3}, {0.9e-3, 0.1e-3}, {1.35e-3, -0.35e-3}, {-1.35e-3, -0.35e-3}})
    EXPECT_NEAR(flight({0.02, -0.1, height}, {0., 200., 0.}), (0.1 - before) / 200., 1e-12) << height;
  EXPECT_NEAR(flight({-0.1, -0.1, 0.}, {100., 100., 0.}), (0.1 * std::sqrt(2.) - 0.5e-3) / (100. * std::sqrt(2.)),
              1e-12);
}

TEST(Flight, AMissNeverTouches)
{
  EXPECT_EQ(flight({0.02, -0.1, 1.01 * g}, {0., 200., 0.}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(flight({0.022, 0.013, 0.1}, {0., 0., 100.}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(flight({0.022, 0.013, 0.1}, {0., 0., 0.}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(flight({0.07, 0.013, 0.1}, {0., 0., -100.}), std::numeric_limits<double>::infinity());
}

TEST(Flight, TheFirstOfManyPointsCounts)
{
  FreeMasses scene;
  scene.add_plate(6, 4, 0.01, 2e-3);
  for (unsigned int i = 0; i < 50; ++i)
    scene.add_point({Point3(1e-3 * i, 0.02, 0.05 + 1e-3 * ((i + 30) % 50)), Point3(0., 0., -100.)});
  EXPECT_NEAR(time_to_first_touch(scene.points(), scene.facets()), (0.05 - g) / 100., 1e-15);
}

TEST(Flight, AfterTheFlightTheFirstStepFindsTouchWithoutDepth)
{
  FreeMasses scene;
  scene.add_plate(6, 4, 0.01, 2e-3);
  scene.add_point({Point3(0.0221, 0.0132, 0.1), Point3(0., 10., -177.4)});
  const double time = time_to_first_touch(scene.points(), scene.facets());
  scene.place(0, scene.position(0) + time * scene.velocity(0));
  EXPECT_LT(initial_overlap(scene.points(), scene.facets()).depth, 1e-15);
  EXPECT_NEAR(time_to_first_touch(scene.points(), scene.facets()), 0., 1e-15);
}

TEST(Flight, AnOverlapIsFoundWithItsPlace)
{
  FreeMasses scene;
  scene.add_plate(6, 4, 0.01, 2e-3);
  for (unsigned int i = 0; i < 20; ++i)
    scene.add_point({Point3(0.021, 0.011, 0.01 - 1.05e-3 * i), Point3(0., 0., -100.)});
  const Overlap overlap = initial_overlap(scene.points(), scene.facets());
  EXPECT_NEAR(overlap.depth, g - std::abs(0.01 - 1.05e-3 * 10), 1e-15); // nearest of all: z = -0.5 mm
  EXPECT_EQ(overlap.id, 10u);
  EXPECT_EQ(time_to_first_touch(scene.points(), scene.facets()), 0.);

  FreeMasses clear;
  clear.add_plate(6, 4, 0.01, 2e-3);
  clear.add_point({Point3(0.021, 0.011, 1.001 * g)});
  EXPECT_EQ(initial_overlap(clear.points(), clear.facets()).depth, 0.);
}

// What the edge of one sheet lets past flies on, away from all facets, to another.
TEST(Flight, PastAnEdgeItGoesOnToWhatIsBehind)
{
  for (const double behind : {0.005, 0.1, 2.})
    {
      FreeMasses scene;
      scene.add_plate(8, 8, 2e-3, 2e-3, Point3(-0.016, 0., 0.));
      scene.add_plate(8, 8, 2e-3, 2e-3, Point3(0., 0., -behind));
      scene.add_point({Point3(0.9e-3, 7e-3, 0.1), Point3(0., 0., -100.)}); // within g of the edge, not in its way
      EXPECT_NEAR(time_to_first_touch(scene.points(), scene.facets()), (0.1 + behind - g) / 100., 1e-12) << behind;
    }
}

// A warped facet is four triangles: the gap along a path is no convex function, and Newton's step may land behind the
// first touch. Nothing may overlap before it, whatever the path.
TEST(Flight, NothingOverlapsBeforeTheFirstTouchOfAWarpedSurface)
{
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> draw(-1., 1.);
  unsigned int                           n_touched = 0;
  for (unsigned int path = 0; path < 300; ++path)
    {
      FreeMasses scene;
      scene.add_patch(4, 4, 2e-3, [](const unsigned int i, const unsigned int j) {
        return Point3(2e-3 * i, 2e-3 * j, (i + j) % 2 == 0 ? 1.2e-3 : -1.2e-3);
      });
      const Point3 target(4e-3 + 3e-3 * draw(random), 4e-3 + 3e-3 * draw(random), 0.);
      const Point3 velocity = 100. * Point3(draw(random), draw(random), -0.2).normalized();
      scene.add_point({Point3(target - 2e-4 * velocity), velocity});
      const Point3 start = scene.position(0);
      const double time  = time_to_first_touch(scene.points(), scene.facets());
      if (!std::isfinite(time))
        continue;
      ++n_touched;
      for (unsigned int k = 0; k < 200; ++k)
        {
          scene.place(0, Point3(start + k / 200. * time * velocity));
          ASSERT_EQ(initial_overlap(scene.points(), scene.facets()).depth, 0.) << "path " << path << ", " << k;
        }
    }
  EXPECT_GT(n_touched, 200u);
}
