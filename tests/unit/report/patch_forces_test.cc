#include <birdstrike/core/closest_point.h>
#include <birdstrike/report/patch_forces.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace birdstrike::patch_forces_test
{
  /// A surface and forces on its nodes.
  struct PressedSurface
  {
    using Nodes = std::array<std::uint32_t, 4>;

    std::vector<double> x, forces;
    std::vector<Nodes>  facets;
    bool                two_sided = true;

    std::uint32_t node(const double x0, const double y, const double z)
    {
      x.insert(x.end(), {x0, y, z});
      forces.resize(x.size(), 0.);
      return static_cast<std::uint32_t>(x.size() / 3 - 1);
    }

    /// p (Pa) against the facets first to last: a quarter of a facet's force to each of its nodes.
    void press(const double p, const std::size_t first, const std::size_t last)
    {
      for (std::size_t f = first; f < last; ++f)
        {
          std::array<Point3, 4> corner;
          for (unsigned int k = 0; k < 4; ++k)
            corner[k] = Point3(&x[3 * facets[f][k]]);
          const Point3 area = compute_area_vector(corner);
          for (const std::uint32_t n : facets[f])
            for (unsigned int d = 0; d < 3; ++d)
              forces[3 * n + d] -= 0.25 * p * area[d];
        }
    }

    double pressure(const std::string &place)
    {
      FacetsView view;
      view.n_nodes   = x.size() / 3;
      view.position  = x.data();
      view.n_facets  = facets.size();
      view.nodes     = facets.data();
      view.two_sided = two_sided;
      PatchForces patches("p: " + place, view);
      patches.update({forces.data(), 3}, 0.);
      std::array<double, 8> row{};
      patches.fill(row);
      return row[4];
    }
  };

  constexpr unsigned int n_along = 8, n_across = 4; // elements of 10 x 10 mm, 4 mm thick
  constexpr double       side = 0.01, thickness = 0.004;

  /// Facets of the upper face come first, looking up, then those of the lower one, looking down, then the rims.
  PressedSurface make_plate(const bool of_bricks)
  {
    PressedSurface plate;
    plate.two_sided = !of_bricks;
    const auto at   = [](const unsigned int i, const unsigned int j) { return j * (n_along + 1) + i; };
    const auto n    = static_cast<std::uint32_t>((n_along + 1) * (n_across + 1));
    for (unsigned int face = 0; face < (of_bricks ? 2 : 1); ++face)
      for (unsigned int j = 0; j <= n_across; ++j)
        for (unsigned int i = 0; i <= n_along; ++i)
          plate.node(side * i, side * j, -thickness * face);
    for (unsigned int j = 0; j < n_across; ++j)
      for (unsigned int i = 0; i < n_along; ++i)
        plate.facets.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    if (!of_bricks)
      return plate;
    for (std::size_t f = 0; f < n_along * n_across; ++f)
      {
        const auto top = plate.facets[f];
        plate.facets.push_back({n + top[3], n + top[2], n + top[1], n + top[0]});
      }
    const auto rim = [&](const std::uint32_t a, const std::uint32_t b) {
      plate.facets.push_back({a, n + a, n + b, b});
    };
    for (unsigned int i = 0; i < n_along; ++i)
      {
        rim(at(i, 0), at(i + 1, 0));
        rim(at(i + 1, n_across), at(i, n_across));
      }
    for (unsigned int j = 0; j < n_across; ++j)
      {
        rim(at(0, j + 1), at(0, j));
        rim(at(n_along, j), at(n_along, j + 1));
      }
    return plate;
  }

  constexpr std::size_t n_of_face = n_along * n_across;
  const char *const middle = "0.04 0.02 0 0.021", *const whole = "-1 -1 -1 1 1 1";

  // A node between two layers is on no facet until bricks fail above it.
  TEST(PatchForces, NodesThatErosionBaresCountWhereTheyLie)
  {
    PressedSurface plate = make_plate(true);
    for (const double x : {0.04, 0.07})
      plate.forces[3 * plate.node(x, 0.02, -0.5 * thickness) + 2] = 100.;
    FacetsView view;
    view.n_nodes  = plate.x.size() / 3;
    view.position = plate.x.data();
    view.n_facets = plate.facets.size();
    view.nodes    = plate.facets.data();
    PatchForces patches(std::string("m: ") + middle + "; w: " + whole, view);
    patches.update({plate.forces.data(), 3}, 0.);
    std::array<double, 16> row{};
    patches.fill(row);
    EXPECT_EQ(row[2], 100.) << "one of both";
    EXPECT_EQ(row[10], 200.) << "all of the force";
    EXPECT_EQ(row[4], 0.) << "pressure is that of the facets";
  }

  // 5 MPa on one face is 5 MPa, on shells and on bricks, whose patches hold both faces and of the whole blade its rims:
  // node forces of a uniform pressure on equal facets are p times the area that the facets within have of each node, so
  // that the sum is exact.
  TEST(PatchForces, PressureIsThatOfTheStruckSide)
  {
    for (const bool of_bricks : {false, true})
      for (const char *place : {middle, whole})
        {
          PressedSurface plate = make_plate(of_bricks);
          plate.press(5e6, 0, n_of_face);
          EXPECT_NEAR(plate.pressure(place), 5e6, 1e-12 * 5e6) << of_bricks << " " << place;
        }
    PressedSurface below = make_plate(true);
    below.press(5e6, n_of_face, 2 * n_of_face);
    EXPECT_NEAR(below.pressure(whole), 5e6, 1e-12 * 5e6);
  }

  // What a shell's nodes cannot tell apart bricks do not count otherwise: 5 MPa above and 3 below leave 2, and a
  // squeeze leaves none.
  TEST(PatchForces, FromBothSidesItIsTheDifference)
  {
    PressedSurface bricks = make_plate(true), shells = make_plate(false);
    bricks.press(5e6, 0, n_of_face);
    bricks.press(3e6, n_of_face, 2 * n_of_face);
    shells.press(5e6 - 3e6, 0, n_of_face);
    for (const char *place : {middle, whole})
      {
        EXPECT_NEAR(bricks.pressure(place), 2e6, 1e-12 * 5e6) << place;
        EXPECT_NEAR(shells.pressure(place), 2e6, 1e-12 * 5e6) << place;
      }
    bricks.press(2e6, n_of_face, 2 * n_of_face);
    EXPECT_LT(bricks.pressure(whole), 1e-12 * 5e6);
  }

  // Along the rim nothing is pressed upon that a face has: nodes there share their force, by area, with the rim's
  // facets, and all of it counts where the patch holds both. A force along the face is none of the pressure.
  TEST(PatchForces, ForcesAlongTheFacesAreNoPressure)
  {
    PressedSurface bricks = make_plate(true);
    bricks.press(7e6, 2 * n_of_face, bricks.facets.size());
    EXPECT_LT(bricks.pressure(whole), 1e-12 * 7e6);
  }

  // A half tube under uniform pressure: the sum of the normal forces of its nodes over the area. A node takes half of
  // two facets that are turned by pi/16, of which cos(pi/32) = 0.995 lies along its normal; the mean normal of the
  // patch would give 2/pi.
  TEST(PatchForces, BentPatchesHaveThePressureOfTheirFacets)
  {
    PressedSurface tube;
    constexpr int  n = 16;
    for (int k = 0; k <= n; ++k)
      for (const double y : {0., 0.01})
        tube.node(-0.05 * std::cos(std::numbers::pi * k / n), y, 0.05 * std::sin(std::numbers::pi * k / n));
    for (std::uint32_t k = 0; k < n; ++k)
      tube.facets.push_back({2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1});
    tube.press(5e6, 0, n);
    EXPECT_NEAR(tube.pressure(whole), 5e6, (1. - std::cos(std::numbers::pi / 32.)) * 5e6);
  }
} // namespace birdstrike::patch_forces_test
