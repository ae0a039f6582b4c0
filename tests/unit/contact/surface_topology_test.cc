#include "free_masses.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace birdstrike;
using birdstrike::test::FreeMasses;

TEST(SurfaceTopology, RimIsWhereNoNeighbourIs)
{
  FreeMasses scene;
  scene.add_plate(3, 3, 1., 0.);
  SurfaceTopology  topology;
  const FacetsView facets = scene.facets();
  topology.update(facets);
  const std::array<double, 4> inside{0.25, 0.25, 0.25, 0.25}, first_edge{0.5, 0.5, 0., 0.},
    second_edge{0., 0.5, 0.5, 0.};
  const std::array<double, 4> first_node{1., 0., 0., 0.};
  EXPECT_FALSE(topology.is_on_rim(facets, 0, inside));
  EXPECT_TRUE(topology.is_on_rim(facets, 0, first_edge)); // y = 0
  EXPECT_FALSE(topology.is_on_rim(facets, 0, second_edge));
  EXPECT_FALSE(topology.is_on_rim(facets, 4, first_edge)); // the middle facet
  EXPECT_FALSE(topology.is_on_rim(facets, 4, first_node));
  EXPECT_TRUE(topology.is_on_rim(facets, 1, first_node)); // on a shared edge, but on the rim
}

TEST(SurfaceTopology, PiecesAreConnected)
{
  FreeMasses scene;
  scene.add_plate(3, 2, 1., 0.);
  scene.add_plate(2, 2, 1., 0., Point3(0., 0., 1.));
  SurfaceTopology topology;
  EXPECT_EQ(topology.update(scene.facets()), SurfaceTopology::Change::surface);
  EXPECT_EQ(topology.update(scene.facets()), SurfaceTopology::Change::none);
  for (std::uint32_t f = 0; f < 10; ++f)
    EXPECT_EQ(topology.piece(f), f < 6 ? 0 : 1);
}

TEST(SurfaceTopology, PiecesWithACommonCornerStayWhatTheyAre)
{
  FreeMasses scene;
  scene.add_plate(2, 2, 1., 0.);
  scene.add_plate(2, 2, 1., 0., Point3(2., 2., 0.));
  for (auto &nodes : scene.facet) // the upper corner of the first is the lower one of the second
    std::replace(nodes.begin(), nodes.end(), std::uint32_t(9), std::uint32_t(8));
  SurfaceTopology topology;
  topology.update(scene.facets());
  ++scene.facets_revision;
  EXPECT_EQ(topology.update(scene.facets()), SurfaceTopology::Change::facets);
  for (std::uint32_t f = 0; f < 8; ++f)
    EXPECT_EQ(topology.piece(f), f < 4 ? 0 : 1) << f;
}

TEST(SurfaceTopology, ThicknessIsAveragedToNodes)
{
  FreeMasses scene;
  scene.add_plate(2, 1, 1., 0.);
  scene.half_thickness = {1e-3, 3e-3};
  SurfaceTopology topology;
  topology.update(scene.facets());
  EXPECT_DOUBLE_EQ(topology.half_thickness(0), 1e-3);
  EXPECT_DOUBLE_EQ(topology.half_thickness(1), 2e-3);
  EXPECT_DOUBLE_EQ(topology.half_thickness(2), 3e-3);
  EXPECT_DOUBLE_EQ(topology.max_half_thickness(), 3e-3);
}
