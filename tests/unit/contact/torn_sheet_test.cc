#include "self_masses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace birdstrike;
using birdstrike::test::SelfMasses;

// A hole in a flat sheet that closes in the sheet's own plane: its rims, round and half a thickness ahead of their
// edges, meet at a distance of one thickness, wherever they lie in the lists.
namespace torn_sheet
{
  constexpr double cell = 5e-3, thickness = 2e-3, step = 1e-7;
  constexpr int    nx = 16, ny = 10, hole_from = 6, hole_to = 10, row_from = 3, row_to = 7;

  /// A plate without the cells of the hole; `is_reversed`: the list of facets backwards.
  SelfMasses make(const bool is_reversed, const bool has_hole)
  {
    SelfMasses scene;
    scene.masses.add_plate(nx, ny, cell, thickness);
    scene.close_body(1., Point3(0., 0., 0.), true);
    auto &facet = scene.masses.facet;
    if (is_reversed)
      {
        std::reverse(facet.begin(), facet.end());
        std::reverse(scene.masses.neighbor.begin(), scene.masses.neighbor.end());
        for (auto &neighbors : scene.masses.neighbor)
          for (std::int32_t &other : neighbors)
            other = other < 0 ? other : nx * ny - 1 - other;
      }
    scene.compute(step); // whole
    for (std::size_t f = facet.size(); has_hole && f-- > 0;)
      {
        const int column = static_cast<int>(facet[f][0]) % (nx + 1), row = static_cast<int>(facet[f][0]) / (nx + 1);
        if (column >= hole_from && column < hole_to && row >= row_from && row < row_to)
          scene.masses.remove_facet(static_cast<std::int32_t>(f));
      }
    return scene;
  }

  /// The rims but for their ends move towards one another by u/2 each, and what lies beside them is stretched.
  void close(SelfMasses &scene, const double u)
  {
    for (std::size_t n = 0; n < scene.masses.node.size(); ++n)
      {
        const int column = static_cast<int>(n) % (nx + 1), row = static_cast<int>(n) / (nx + 1);
        if (row <= row_from || row >= row_to)
          continue;
        const double left                = std::min(1., static_cast<double>(column) / hole_from),
                     right               = std::min(1., static_cast<double>(nx - column) / (nx - hole_to)),
                     share               = column <= hole_from ? left
                                           : column >= hole_to ? -right
                                                               : 0.;
        scene.masses.node[n].position[0] = column * cell + share * 0.5 * u;
      }
    scene.compute(step);
  }

  /// The displacement at which the first nodes touch, to `by`.
  double first_touch(SelfMasses &scene, const double by)
  {
    double u = 0.;
    while (u < (hole_to - hole_from) * cell - 0.5 * thickness && scene.contact.report().n_touching == 0)
      close(scene, u += by);
    return u;
  }

  std::map<std::uint32_t, Point3> forces(const SelfMasses &scene)
  {
    std::map<std::uint32_t, Point3> of_node;
    for (const NodalForce &f : scene.contact.forces())
      of_node.emplace(f.node, Point3(f.force.data()));
    return of_node;
  }
} // namespace torn_sheet

TEST(TornSheet, RimsOfAHoleThatClosesInItsPlaneMeetAtAThickness)
{
  const double by          = 0.05e-3,
               until_touch = (torn_sheet::hole_to - torn_sheet::hole_from) * torn_sheet::cell - torn_sheet::thickness;
  for (const bool is_reversed : {false, true})
    {
      SelfMasses scene = torn_sheet::make(is_reversed, true);
      EXPECT_NEAR(torn_sheet::first_touch(scene, by), until_touch + 0.5 * by, 0.5 * by + 1e-9);
      // the nodes of both rims but for their ends, each against the other
      EXPECT_EQ(scene.contact.report().n_touching, 2U * (torn_sheet::row_to - torn_sheet::row_from - 1));
    }
}

TEST(TornSheet, TheOrderOfTheFacetsDoesNotMatter)
{
  SelfMasses one = torn_sheet::make(false, true), other = torn_sheet::make(true, true);
  for (double u = 0.; u < 18.9e-3; u += 0.1e-3)
    {
      torn_sheet::close(one, u);
      torn_sheet::close(other, u);
      const auto a = torn_sheet::forces(one), b = torn_sheet::forces(other);
      ASSERT_EQ(a.size(), b.size()) << "u = " << u;
      for (const auto &[node, force] : a)
        EXPECT_LE((force - b.at(node)).norm(), 1e-12 * one.largest_force());
    }
  EXPECT_FALSE(torn_sheet::forces(one).empty());
}

TEST(TornSheet, AWholeOnePaysNothing)
{
  SelfMasses scene = torn_sheet::make(false, false);
  for (auto &node : scene.masses.node) // cells of 3.5 mm, farther than a thickness
    node.position[0] *= 0.7;
  scene.compute(torn_sheet::step);
  EXPECT_GE(scene.contact.report().looks, 2U);
  EXPECT_EQ(scene.contact.report().pairs_tested, 0U);
}
