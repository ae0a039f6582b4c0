#include "solid_mesh_harness.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace birdstrike::solid_mesh_test
{
  using namespace solid_mesh_harness;

  namespace
  {
    /// Volume enclosed by outward facets: int x . n dA / 3, exact for flat ones.
    double enclosed_volume(const SurfaceMesh &skin)
    {
      double sum = 0.;
      for (std::size_t f = 0; f < skin.cells.size(); ++f)
        sum += skin.centroid(f).dot(skin.area_vector(f)) / 3.;
      return sum;
    }

    double volume(const SolidMesh &mesh, const std::size_t cell)
    {
      return mesh.compute_mass(1.).element[cell];
    }

    double total_volume(const SolidMesh &mesh)
    {
      return mesh.compute_mass(1.).total;
    }

    TEST(SolidMesh, PlateHasTheFacesOfItsShell)
    {
      const BladeParameters p = plate(28, 8, 2);
      const SolidMesh       solid(p);
      const ShellMesh       shell({p.mesh});
      const VolumeMesh     &mesh = solid;
      EXPECT_EQ(mesh.nodes.size(), 29u * 9u * 3u);
      EXPECT_EQ(mesh.n_skin_nodes, mesh.nodes.size() - 27u * 7u);
      EXPECT_EQ(mesh.cells.size(), 28u * 8u * 2u);
      EXPECT_EQ(mesh.boundary.size(), 2u * (28u * 8u + 28u * 2u + 8u * 2u));
      EXPECT_EQ(mesh.boundary_ids, (Ids{0, 1, 2, 3, 5, 6}));
      EXPECT_EQ(mesh.layers, 2u);

      // Root, tip, edges and mid-surface are those of the shell, to the last bit.
      std::set<std::array<double, 3>> places(mesh.nodes.begin(), mesh.nodes.end());
      for (const auto &node : shell.nodes)
        EXPECT_EQ(places.count(node), 1u);
      const std::vector<std::pair<unsigned int, unsigned int>> lines{{0, 9}, {1, 9}, {2, 29}, {3, 29}};
      for (const auto &[id, n] : lines)
        {
          const auto row = mesh.nodes_on({id}), of_shell = shell.nodes_on({id});
          ASSERT_EQ(row.size(), 3u * n);
          const unsigned int d = id < 2 ? 0 : 1;
          for (const auto k : row)
            EXPECT_EQ(mesh.nodes[k][d], shell.nodes[of_shell[0]][d]);
        }
      for (const auto &[id, z] : {std::pair(5u, -0.5 * 0.00427), {6u, 0.5 * 0.00427}})
        for (const auto k : mesh.nodes_on({id}))
          EXPECT_EQ(mesh.nodes[k][2], z);
      EXPECT_EQ(mesh.nodes_on({5}).size(), 29u * 9u);
      EXPECT_FALSE(mesh.has_boundary_id(4));
      EXPECT_NEAR(mesh.smallest_edge(0), 0.00427 / 2., 1e-17);
    }

    // Round-off of some hundred facets: 1e-13.
    TEST(SolidMesh, SkinIsClosedAndFirst)
    {
      BladeParameters p = plate(6, 4, 3);
      p.thickness.value = "0.01 + 0.02*x";
      const SolidMesh    solid(p);
      const VolumeMesh  &mesh = solid;
      const SurfaceMesh &skin = mesh.skin;
      EXPECT_EQ(expect_closed(skin), 0u);
      Point3 area = Point3::Zero();
      for (std::size_t f = 0; f < skin.cells.size(); ++f)
        {
          area += skin.area_vector(f);
          EXPECT_EQ(skin.cells[f], mesh.boundary[f].nodes);
          EXPECT_GT(skin.area_vector(f).dot(skin.centroid(f) - mesh.centroid(mesh.boundary[f].cell)), 0.);
          for (const auto n : skin.cells[f])
            EXPECT_LT(n, mesh.n_skin_nodes);
        }
      EXPECT_LT(area.norm(), 1e-15);
      EXPECT_NEAR(enclosed_volume(skin) / total_volume(solid), 1., 1e-13);
      EXPECT_NEAR(total_volume(solid) / (p.mesh.chord * (0.01 * p.mesh.length + 0.01 * std::pow(p.mesh.length, 2))), 1.,
                  1e-13);
      ASSERT_EQ(skin.nodes.size(), mesh.n_skin_nodes);
      EXPECT_EQ(solid.nearest_node(mesh.node(mesh.n_skin_nodes + 1)), mesh.n_skin_nodes + 1) << "inner nodes count too";
    }

    // Row sums of a graded box: each node carries its tributary lengths along the three axes.
    TEST(SolidMesh, LumpsTheExactMass)
    {
      BladeParameters p    = plate(5, 3, 4);
      p.mesh.span_grading  = 4.;
      p.mesh.chord_grading = 0.5;
      p.mesh.layer_grading = 2.;
      SolidMesh             solid(p);
      const SolidMesh::Mass mass  = solid.compute_mass(4430.);
      const VolumeMesh     &mesh  = solid;
      const double          exact = 4430. * p.mesh.length * p.mesh.chord * 0.00427;
      EXPECT_NEAR(mass.total / exact, 1., 1e-14);
      EXPECT_NEAR(std::accumulate(mass.node.begin(), mass.node.end(), 0.) / exact, 1., 1e-14);
      std::set<double> lines[3];
      for (const auto &x : mesh.nodes)
        for (unsigned int d = 0; d < 3; ++d)
          lines[d].insert(x[d]);
      EXPECT_EQ(lines[0].size() * lines[1].size() * lines[2].size(), mesh.nodes.size());
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        {
          double share = 4430.;
          for (unsigned int d = 0; d < 3; ++d)
            {
              const auto at = lines[d].find(mesh.nodes[n][d]), last = std::prev(lines[d].end());
              share *= 0.5 * ((at == last ? *at : *std::next(at)) - (at == lines[d].begin() ? *at : *std::prev(at)));
            }
          EXPECT_NEAR(mass.node[n] / share, 1., 1e-12);
        }
      for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        EXPECT_NEAR(mass.element[cell] / (4430. * volume(solid, cell)), 1., 1e-13);
    }

    TEST(SolidMesh, LayersGrowFromTheFacesToTheMiddle)
    {
      BladeParameters p    = plate(1, 1, 5);
      p.mesh.layer_grading = 4.;
      p.thickness.value    = "0.01";
      const SolidMesh solid(p);
      const auto     &mesh        = solid;
      double          expected[5] = {1., 2., 4., 2., 1.};
      for (unsigned int k = 0; k < 5; ++k)
        EXPECT_NEAR(volume(solid, k) / volume(solid, 0), expected[k], 1e-12);
      for (unsigned int k = 0; k < 5; ++k)
        EXPECT_LT(mesh.node(mesh.cells[k][0])[2], mesh.node(mesh.cells[k][4])[2]) << "third axis along the normal";
    }

    TEST(SolidMesh, ThicknessFollowsMaterialAndIsPositive)
    {
      BladeParameters p       = plate(2, 2, 1);
      p.thickness.by_material = "0: 0.01";
      EXPECT_NEAR(total_volume(SolidMesh(p)), 0.01 * p.mesh.length * p.mesh.chord, 1e-17);
      p.thickness.by_material = "";
      p.thickness.value       = "0.01*(x-0.2)";
      EXPECT_THROW(SolidMesh{p}, InputError);
    }

    TEST(SolidMesh, HalfAPlateIsCutAtThePlane)
    {
      BladeParameters p = plate(6, 4, 2);
      p.is_halved       = true;
      SolidMesh         solid(p);
      const VolumeMesh &mesh = solid;
      EXPECT_EQ(mesh.boundary_ids, (Ids{0, 1, 3, 4, 5, 6}));
      EXPECT_EQ(mesh.mirrored_ids, (Ids{2}));
      EXPECT_EQ(mesh.symmetry_sides.size(), 6u * 2u);
      EXPECT_EQ(mesh.symmetry_nodes.size(), 7u * 3u);
      EXPECT_EQ(mesh.nodes_on({4}), mesh.symmetry_nodes);
      for (const auto n : mesh.symmetry_nodes)
        EXPECT_EQ(mesh.nodes[n][1], 0.);
      EXPECT_EQ(expect_closed(mesh.skin), 2u * 6u + 2u * 2u);
      for (const auto &face : mesh.boundary)
        EXPECT_NE(face.id, 4u);
      EXPECT_NEAR(solid.compute_mass(1.).total / (0.5 * p.mesh.length * p.mesh.chord * 0.00427), 1., 1e-14);
      p.mesh.n_chord = 3;
      EXPECT_THROW(SolidMesh{p}, InputError);
    }

    // One cube in millimetres with boundary 7 at x = 0 and material 3, in each format.
    // deal.II's Abaqus reader takes the nodes of any element type as they come; quadrilaterals beside bricks confuse
    // it.
    // Four cells on two legs that stand across the corner: the legs are joined above, but share an edge below.
  } // namespace
} // namespace birdstrike::solid_mesh_test
