#include "oriented_file.h"

#include <birdstrike/structure/surface_map.h>

#include <gtest/gtest.h>

namespace surface_map_test
{
  using namespace birdstrike;
  using namespace birdstrike::test;

  namespace
  {
    Point3 plate_point(const BladeParameters &plate, const double span, const double chord)
    {
      return {span * plate.mesh.length, (chord - 0.5) * plate.mesh.chord, 0.};
    }

    void expect_near(const Point3 &found, const Point3 &expected, const double tolerance, const std::string &what)
    {
      EXPECT_LT((found - expected).norm(), tolerance)
        << what << ": " << found.transpose() << ", not " << expected.transpose();
    }
  } // namespace

  TEST(SurfaceMap, OfThePlateIsThePlateToTheLastBit)
  {
    const BladeParameters plate = elastic_plate(4, 2);
    const auto            map   = make_surface_map(plate);
    EXPECT_EQ(map->chord_direction(0.7), Point3(0., 1., 0.));
    EXPECT_EQ(map->normal(0.7, 0.5), Point3(0., 0., 1.));
    EXPECT_EQ(map->position(0.5, 0.), Point3(0.5 * plate.mesh.length, -0.5 * plate.mesh.chord, 0.));
  }

  TEST(SurfaceMap, TheChordOfAStaggeredBladeStandsAtItsStagger)
  {
    BladeParameters blade      = elastic_plate(4, 2);
    blade.mesh.generator       = MeshGenerator::blade;
    blade.mesh.profile.stagger = "30+20*s";
    const auto   map           = make_surface_map(blade);
    const double angle         = 40. * M_PI / 180.;
    expect_near(map->chord_direction(0.5), {0., std::cos(angle), std::sin(angle)}, 1e-15, "chord");
  }

  /// A plate from a file, turned in space: shell and solid, whose two faces give the surface between them.
  TEST(SurfaceMap, OfAFileIsThatOfItsMidSurfaceHoweverItStands)
  {
    for (const unsigned int n_layers : {0u, 2u})
      for (const double turn : {0., 40.})
        {
          Listing listing;
          listing.seed   = 5;
          listing.turned = Eigen::AngleAxisd(turn * M_PI / 180., Point3::UnitX()).toRotationMatrix();
          if (n_layers > 0)
            listing.corners = [] { return rotations_of_a_cube()[0]; };
          else
            listing.corners = [] { return std::vector<unsigned int>{0, 1, 2, 3}; };
          const PlateFile       file({7, 4, n_layers}, listing);
          const BladeParameters plate = file.parameters();
          const auto            map   = make_surface_map(plate);
          ASSERT_TRUE(map);
          const std::string what = std::to_string(n_layers) + " layers at " + std::to_string(turn);
          for (const auto &[span, chord] : {std::array{0.7, 0.5}, {0.7, 0.}, {0.33, 1.}, {1., 0.25}})
            {
              const Point3 there = listing.turned * plate_point(plate, span, chord);
              // cuts at the very ends are taken a millionth beside them; the file has 17 digits
              expect_near(map->position(span, chord), there, 3e-6 * plate.mesh.length, what);
              const auto shares = map->shares(there);
              EXPECT_NEAR(shares[0], span, 1e-12) << what;
              EXPECT_NEAR(shares[1], chord, 1e-5) << what;
            }
          expect_near(map->chord_direction(0.5), listing.turned * Point3(0., 1., 0.), 1e-2, what);
          expect_near(map->normal(0.5, 0.5), listing.turned * Point3(0., 0., 1.), 1e-10, what);
        }
  }

  // A file of a blade that turns from 70 degrees to y to 110: an eighth of the chord from the edge at which it begins
  // at the root is on the same side all along. Facets are cut as two triangles, whose common edge lies off the helicoid
  // by a quarter of the twist of a row times the width of a cell, 0.05/4 * chord/4 = 3e-3 of the chord.
  TEST(SurfaceMap, OfAFileGoesFromTheSameEdgeAllAlong)
  {
    for (const unsigned int n_layers : {0u, 2u})
      {
        Listing listing;
        listing.seed    = 5;
        listing.corners = [n_layers] {
          return n_layers > 0 ? rotations_of_a_cube()[0] : std::vector<unsigned int>{0, 1, 2, 3};
        };
        const auto angle = [](const double s) { return (70. + 40. * s) * M_PI / 180.; };
        listing.shape    = [&](const Point3 &x) {
          const double a = angle(x[0] / 0.3112);
          return Point3(x[0], x[1] * std::cos(a) - x[2] * std::sin(a), x[1] * std::sin(a) + x[2] * std::cos(a));
        };
        const PlateFile       file({14, 4, n_layers}, listing);
        const BladeParameters plate = file.parameters();
        const auto            map   = make_surface_map(plate);
        ASSERT_TRUE(map);
        for (const double s : {0.05, 0.45, 0.55, 0.95})
          {
            const double y = -0.375 * plate.mesh.chord;
            const Point3 there(s * plate.mesh.length, y * std::cos(angle(s)), y * std::sin(angle(s)));
            const double tolerance = 4e-3 * plate.mesh.chord;
            expect_near(map->position(s, 0.125), there, tolerance, std::to_string(n_layers));
            EXPECT_NEAR(map->shares(there)[1], 0.125, 1e-3);
            EXPECT_GT(map->chord_direction(s).dot(Point3(0., std::cos(angle(s)), std::sin(angle(s)))), 0.99);
          }
      }
  }

  TEST(SurfaceMap, NeedsRootAndTip)
  {
    Listing listing;
    listing.corners = [] { return std::vector<unsigned int>{0, 1, 2, 3}; };
    const PlateFile file({4, 2, 0}, listing);
    BladeParameters plate  = file.parameters();
    plate.supports.clamped = "10, 11, 12, 13";
    EXPECT_FALSE(make_surface_map(plate));
    plate.kind = BladeKind::none;
    EXPECT_FALSE(make_surface_map(plate));
  }
} // namespace surface_map_test
