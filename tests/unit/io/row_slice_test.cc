#include <birdstrike/bird/shape.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/structure/surface_map.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "expect_parts.h"
#include "refusal.h"
#include "scratch_folder.h"

using namespace birdstrike;

// Bird/Slice/Number of blades.

namespace
{
  const std::string spin  = BIRDSTRIKE_SOURCE_DIR "/prm/fan-blade-spin.prm";
  const std::string flock = BIRDSTRIKE_SOURCE_DIR "/prm/certification/flock.prm";

  constexpr double speed = 600., flight = 102.9, pitch = 2. * std::numbers::pi / 22.;

  template <class Numbers>
  Point3 point(const Numbers &x)
  {
    return Point3(x.data());
  }

  /// Of a place about the axis y: its radius, and how far it is ahead in the rotation (rad).
  std::array<double, 2> polar(const Point3 &x)
  {
    return {{std::hypot(x[0], x[2]), std::atan2(-x[2], x[0])}};
  }

  /// Where the leading edge, as it lies undeformed, has a radius: how far it is ahead (rad), and along the axis (m).
  std::array<double, 2> edge_at(const SurfaceMap &map, const double radius)
  {
    double low = 0., high = 1.;
    for (int k = 0; k < 25; ++k)
      (polar(map.position(0.5 * (low + high), 0.))[0] < radius ? low : high) = 0.5 * (low + high);
    const Point3 x = map.position(low, 0.);
    return {{polar(x)[1], x[1]}};
  }

  struct Shares
  {
    double over_own = 0., over_other = 0., left_out = 0.; ///< of the slice's volume
  };

  /// What each piece of the whole bird does that flies on undeformed: when it is abreast of the edge it lies ahead of
  /// it by less than a pitch, or passes over the edge of this blade or of the one before it. On helices, by no plane.
  Shares fly_by(const CaseParameters &parameters, const double turned)
  {
    const BirdParameters &bird = parameters.bird;
    BirdParameters        all  = bird;
    all.slice_between.clear();
    all.slice_normal.clear();
    const Shape             whole(all);
    const auto              map = make_surface_map(parameters.blade);
    const Eigen::AngleAxisd back(-turned, Point3::UnitY());
    const Point3            normal = back * point(bird.slice_normal).normalized();
    const double            step = 0.003, R = 0.5 * whole.whole_diameter(), L = 0.5 * whole.whole_length();
    double                  n_slice = 0., n_own = 0., n_other = 0., n_out = 0.;
    for (double x = -R + 0.5 * step; x < R; x += step)
      for (double z = -R + 0.5 * step; z < R; z += step)
        for (double y = -L + 0.5 * step; y < L && x * x + z * z < R * R; y += step)
          {
            const Point3 place         = point(bird.aim_point) + Point3(x, y, z);
            const auto [radius, ahead] = polar(place);
            if (radius > 0.64)
              continue; // over the tip
            const auto   edge     = edge_at(*map, radius);
            const double share    = (ahead - edge[0] - speed * (edge[1] - place[1]) / flight) / pitch;
            const double distance = normal.dot(Point3(x, y, z));
            const bool   is_in    = distance > bird.slice_between[0] && distance < bird.slice_between[1];
            n_slice += is_in;
            n_own += is_in && share < 0.;
            n_other += is_in && share > 1.;
            n_out += !is_in && share > 0. && share < 1.;
          }
    return {n_own / n_slice, n_other / n_slice, n_out / n_slice};
  }
} // namespace

TEST(RowSlice, IsWhatLiesBetweenThePathsOfTwoEdges)
{
  for (const char *span : {"0.4", "0.7", "0.9"})
    {
      SCOPED_TRACE(span);
      CaseParameters parameters;
      parameters.read(spin, {"Bird/Aim span fraction=" + std::string(span)});
      const Shares shares = fly_by(parameters, 0.);
      EXPECT_LT(shares.over_own, 0.01);
      EXPECT_LT(shares.over_other, 0.01);
      EXPECT_NEAR(shares.left_out, shares.over_own + shares.over_other, 0.004) << "as much as should not be there";
    }
  // aimed at the leading edge instead, half of it passes over; with planes across the bird's axis a fifth
  CaseParameters at_edge, across;
  at_edge.read(spin, {"Bird/Aim chord fraction=0"});
  EXPECT_NEAR(fly_by(at_edge, 0.).over_own, 0.5, 0.02);
  across.read(spin, {"Bird/Slice/Number of blades=0", "Bird/Slice/Normal=0, 1, 0",
                     "Bird/Slice/Between=-24.5 mm, 24.5 mm", "Bird/Aim chord fraction=0.08"});
  EXPECT_GT(fly_by(across, 0.).over_own, 0.1);
}

// 2 pi r/22 wide across the rotation.
TEST(RowSlice, HasTheThicknessOfTheTriangleOfVelocities)
{
  CaseParameters parameters;
  parameters.read(spin, {"Bird/Aim span fraction=default", "Bird/Aim point=0.515, 0, 0"});
  const double relative = std::hypot(flight, speed * 0.515);
  const Point3 expected(0., speed * 0.515 / relative, -flight / relative);
  EXPECT_NEAR((point(parameters.bird.slice_normal) - expected).norm(), 0., 1e-14);
  EXPECT_NEAR(parameters.bird.slice_between[1], 0.5 * pitch * 0.515 * flight / relative, 1e-15);
  EXPECT_EQ(parameters.bird.slice_between[0], -parameters.bird.slice_between[1]);
  EXPECT_EQ(parameters.bird.aim_point, (std::array<double, 3>{{0.515, 0., 0.}})) << "stays as it is given";
}

// The flow comes from the other side of the chord: what the blade's back meets, before the blade after it does.
TEST(RowSlice, OfABladeBehindThePathOfItsEdgeLiesBehindIt)
{
  for (const auto &[speed, side] : {std::pair("600", 1.), std::pair("200", -1.)})
    {
      CaseParameters parameters;
      parameters.read(spin, {"Blade/Spin/Speed=" + std::string(speed)});
      const BirdParameters &bird = parameters.bird;
      EXPECT_NEAR(point(bird.slice_normal).dot(point(bird.aim_point) - point(*bird.aimed_place)),
                  side * bird.slice_between[1], 1e-12)
        << speed;
    }
}

// By 600 rad/s 1.5 ms: the second bird of the flock meets a blade that has turned.
TEST(RowSlice, OfALaterBirdIsTurnedWithTheBlade)
{
  CaseParameters parameters, first;
  parameters.read(flock);
  first.read(flock, {"Bird/Aim span fraction=0.55", "Bird 2/Enabled=false"});
  const BirdParameters   &second = parameters.further_birds[0].bird;
  const Eigen::AngleAxisd turn(speed * 1.5e-3, Point3::UnitY());
  EXPECT_NEAR((turn * point(first.bird.slice_normal) - point(second.slice_normal)).norm(), 0., 1e-12);
  EXPECT_NEAR(second.slice_between[1], first.bird.slice_between[1], 1e-15);
  EXPECT_NEAR((point(first.bird.aim_point) - point(second.aim_point)).norm(), 0., 1e-12)
    << "as the blade lies at the start";
}

TEST(RowSlice, ThePrintedFileRunsToTheSameBits)
{
  const ScratchFolder scratch;
  CaseParameters      first, again;
  first.read(flock);
  again.read(scratch.write("parameters.prm", first.file.as_prm()));
  for (const auto &[one, other] :
       {std::pair(&first.bird, &again.bird), std::pair(&first.further_birds[0].bird, &again.further_birds[0].bird)})
    {
      EXPECT_EQ(one->slice_normal, other->slice_normal);
      EXPECT_EQ(one->slice_between, other->slice_between);
      EXPECT_EQ(one->aim_point, other->aim_point);
      EXPECT_EQ(one->aimed_place, other->aimed_place);
    }
}

TEST(RowSlice, AnotherBirdMayBeWholeOrHaveItsOwnPlanes)
{
  CaseParameters whole, planes, by_edge;
  by_edge.read(flock, {"Bird/Aim chord fraction=0.3", "Bird 2/Slice/Number of blades=22"});
  EXPECT_EQ(by_edge.bird.aimed_place, by_edge.bird.aim_point) << "on the surface";
  EXPECT_NE(by_edge.further_birds[0].bird.aimed_place, by_edge.further_birds[0].bird.aim_point)
    << "beside the edge: a chord is not inherited then";
  whole.read(flock, {"Bird 2/Slice/Number of blades=0", "Bird 2/Aim chord fraction=0.3"});
  EXPECT_FALSE(whole.further_birds[0].bird.is_slice());
  EXPECT_TRUE(whole.bird.is_slice());
  planes.read(flock,
              {"Bird 2/Slice/Between=-10 mm, 10 mm", "Bird 2/Slice/Normal=0, 1, 0", "Bird 2/Aim chord fraction=0.3"});
  EXPECT_EQ(planes.further_birds[0].bird.slice_between, (std::vector<double>{-0.01, 0.01}));
}

TEST(RowSlice, WhatContradictsOrCutsNothingIsRefused)
{
  expect_parts(refusal(spin, {"Bird/Slice/Between=-20 mm, 20 mm"}),
               {"Bird/Slice/Between = -0.02, 0.02 m", "Number of blades", "0.02319"});
  expect_parts(refusal(spin, {"Bird/Slice/Normal=0, 1, 0"}), {"Bird/Slice/Normal", "Number of blades"});
  expect_parts(refusal(spin, {"Bird/Aim point=0.515, 0, 0"}), {"Bird/Aim point", "Slice/Number of blades"});
  expect_parts(refusal(spin, {"Blade/Spin/Speed=0"}), {"Number of blades", "does not turn", "Blade/Spin/Speed"});
  expect_parts(refusal(spin, {"Blade/Kind=none", "Bird/Aim span fraction=default"}),
               {"Number of blades", "does not turn"});
  expect_parts(refusal(spin, {"Blade/Mesh/Row/Blades=2"}), {"Number of blades", "Blade/Mesh/Row"});
  expect_parts(refusal(spin, {"Bird/Slice/Number of blades=1"}), {"Number of blades", "one blade has none before it"});
  expect_parts(refusal(spin, {"Bird/Velocity=0, 0, 50"}), {"Number of blades", "along the axis"});
  expect_parts(refusal(spin, {"Bird/Shape=slab", "Bird/Slab lengths=0.1, 0.1, 0.1"}), {"slab"});
  expect_parts(refusal(spin, {"Bird/Slice/Number of blades=0"}), {"Aim chord fraction", "not given"});
}
