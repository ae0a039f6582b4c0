#include "free_masses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

using namespace birdstrike;
using birdstrike::test::FreeMasses;

TEST(FacetGrid, ACellListsEveryFacetWhoseBoxHoldsThePoint)
{
  FreeMasses scene; // sizes 1 : 10
  scene.add_patch(20, 6, 0., [](const unsigned int i, const unsigned int j) {
    return Point3(1e-3 * i + 4.5e-4 * i * i, 8e-3 * j, 0.02 * std::sin(0.3 * i));
  });
  FacetGrid        grid;
  const FacetsView facets = scene.facets();
  grid.update(facets, 2e-3);
  std::mt19937                           random(5);
  std::uniform_real_distribution<double> uniform(0., 1.);
  std::size_t                            n_listed = 0;
  for (unsigned int trial = 0; trial < 5000; ++trial)
    {
      Point3 p;
      for (unsigned int d = 0; d < 3; ++d)
        p[d] = grid.box().low[d] + uniform(random) * (grid.box().high[d] - grid.box().low[d]);
      Box at_point;
      at_point.add(p.data());
      std::vector<std::uint32_t> near;
      grid.visit_near(at_point, [&](const std::uint32_t f) { near.push_back(f); });
      EXPECT_EQ(grid.count_cells(at_point), 1u);
      n_listed += near.size();
      EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
      for (std::uint32_t f = 0; f < facets.n_facets; ++f)
        if (grid.box(f).contains(p))
          {
            EXPECT_TRUE(std::binary_search(near.begin(), near.end(), f));
          }
    }
  EXPECT_LT(n_listed, 5000u * facets.n_facets / 5); // it does select
}

TEST(FacetGrid, OnlyFacetsThatMeetTheRegionAreEntered)
{
  FreeMasses scene;
  scene.add_plate(10, 10, 0.01, 0.);
  Box          region;
  const double low[3] = {0.021, 0.021, 0.}, high[3] = {0.029, 0.039, 0.};
  region.add(low);
  region.add(high);
  FacetGrid grid;
  grid.update(scene.facets(), 5e-4, region);
  std::set<std::uint32_t> seen;
  grid.visit_near(region, [&](const std::uint32_t f) { seen.insert(f); });
  EXPECT_EQ(seen, (std::set<std::uint32_t>{22, 32})); // the cells [0.02, 0.03] x [0.02, 0.04] of 1 cm
  const double away[3] = {5., 5., 5.};
  Box          nowhere;
  nowhere.add(away);
  grid.update(scene.facets(), 1e-3, nowhere);
  EXPECT_TRUE(grid.box().is_empty());
}
