#include <birdstrike/core/box.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace birdstrike;

namespace
{
  const Box unit{{{0., 0., 0.}}, {{1., 1., 1.}}};
}

// Numbers without round-off: exact.
TEST(Box, ARayPassesBetweenTheFacesThatItMeets)
{
  const TimeSpan through = unit.passage({-1., 0.5, 0.25}, {2., 0.25, 0.});
  EXPECT_EQ(through.first, 0.5);
  EXPECT_EQ(through.last, 1.);
  const TimeSpan from_inside = unit.passage({0.5, 0.5, 0.5}, {0., -0.25, 0.});
  EXPECT_EQ(from_inside.first, 0.);
  EXPECT_EQ(from_inside.last, 2.);
  EXPECT_TRUE(std::isinf(unit.passage({0., 1., 0.5}, {0., 0., 0.}).last)) << "at rest on an edge: for ever";
  EXPECT_TRUE(unit.passage({-1., 0.5, 0.5}, {-2., 0., 0.}).is_empty()) << "flies away";
  EXPECT_TRUE(unit.passage({-1., 0.5, 1.5}, {2., 0., 0.}).is_empty()) << "passes beside";
  EXPECT_TRUE(unit.passage({-1., 0.5, 0.5}, {1., 1., 0.}).is_empty()) << "passes a corner";
  EXPECT_TRUE(Box().passage({0., 0., 0.}, {1., 0., 0.}).is_empty());
}

TEST(Box, FacesThatMoveAreMetLater)
{
  const Box      faces{{{1., 0., 0.}}, {{3., 0., 0.}}};
  const TimeSpan span = unit.passage({-1., 0.5, 0.5}, {2., 0., 0.}, faces);
  EXPECT_EQ(span.first, 1.);
  EXPECT_TRUE(std::isinf(span.last)) << "the far face is faster";
}

TEST(Box, WidensOnAllSides)
{
  const Box wide = unit.widened(0.5);
  EXPECT_TRUE(wide.contains({-0.5, 1.5, 0.}));
  EXPECT_FALSE(wide.contains({-0.5, 1.75, 0.}));
}

TEST(Box, KnowsHowFarApartTwoAre)
{
  Box          a, b;
  const double origin[3] = {0., 0., 0.}, corner[3] = {1., 1., 1.}, far[3] = {3., 0.5, 1.5};
  EXPECT_TRUE(a.is_empty());
  a.add(origin);
  a.add(corner);
  b.add(far);
  EXPECT_DOUBLE_EQ(a.separation(b), 2.);
  EXPECT_DOUBLE_EQ(b.separation(a), 2.);
  b.add(origin, 0.1);
  EXPECT_LT(a.separation(b), 0.);
  EXPECT_DOUBLE_EQ(b.low[0], -0.1);
}
