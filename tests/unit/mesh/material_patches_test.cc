#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/mesh/blade_shape.h>
#include <birdstrike/structure/parameters.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

namespace birdstrike::material_patches_test
{
  namespace
  {
    BladeParameters plate(const unsigned int n_span, const unsigned int n_chord, const std::string &patches)
    {
      BladeParameters p;
      p.mesh.length           = 0.3;
      p.mesh.chord            = 0.09;
      p.mesh.n_span           = n_span;
      p.mesh.n_chord          = n_chord;
      p.mesh.material_patches = patches;
      return p;
    }

    /// m^2 or m^3, of the cells of each material.
    template <int dim>
    std::map<unsigned int, double> sizes(const BladeParameters &p)
    {
      const BladeMesh<dim>           mesh(p);
      std::map<unsigned int, double> sum;
      for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        if constexpr (dim == 2)
          sum[mesh.material_ids[cell]] += mesh.area_vector(cell).norm();
        else
          {
            const Point3 o = mesh.node(mesh.cells[cell][0]);
            const auto   e = [&](const unsigned int k) { return Point3(mesh.node(mesh.cells[cell][k]) - o); };
            sum[mesh.material_ids[cell]] += e(1).cross(e(2)).dot(e(4)); // of parallelepipeds
          }
      return sum;
    }

    TEST(MaterialPatches, KeepTheirSizeOnAnyMesh)
    {
      const double plate_area = 0.3 * 0.09;
      for (const unsigned int n_chord : {5u, 8u, 10u, 12u, 14u, 17u, 31u})
        for (const double grading : {1., 0.2, 6.})
          {
            BladeParameters p    = plate(9 + n_chord, n_chord, "0 1 0 0.15: 1; 0.4 0.75 0.6 1: 2; 0.4 0.5 0 0.15: 3");
            p.mesh.chord_grading = grading;
            p.mesh.span_grading  = 1. / grading;
            auto area            = sizes<2>(p);
            EXPECT_NEAR(area[1], (0.15 - 0.1 * 0.15) * plate_area, 1e-15) << n_chord << ", " << grading;
            EXPECT_NEAR(area[2], 0.35 * 0.4 * plate_area, 1e-15) << n_chord << ", " << grading;
            EXPECT_NEAR(area[3], 0.1 * 0.15 * plate_area, 1e-15) << n_chord << ", " << grading;
            p.mesh.n_layers = 2;
            auto volume     = sizes<3>(p);
            for (const auto &[id, of_id] : area)
              EXPECT_NEAR(volume[id], of_id * 0.00427, 1e-16) << n_chord << ", " << grading;
          }
    }

    TEST(MaterialPatches, MoveTheNearestLineAndStretchTheOthers)
    {
      BladeParameters p    = plate(4, 10, "0 1 0 0.12: 1"); // among lines at 0, 0.1, 0.2 ...
      const ShellMesh mesh = ShellMesh(p);
      for (unsigned int j = 0; j < 10; ++j)
        {
          const double left = mesh.node(mesh.cells[j][0])[1] / 0.09 + 0.5;
          EXPECT_NEAR(left, j == 0 ? 0. : 0.12 + (j - 1) * 0.88 / 9., 1e-14) << j;
          EXPECT_EQ(mesh.material_ids[j], j == 0);
        }
      p.mesh.material_patches = "0 1 0 0.2: 1"; // on a line
      const ShellMesh on(p);
      p.mesh.material_patches = "";
      const ShellMesh without(p);
      for (std::size_t n = 0; n < on.nodes.size(); ++n)
        EXPECT_LT((on.node(n) - without.node(n)).norm(), 1e-16);
    }

    // Half way between two lines the choice is the same from both edges.
    TEST(MaterialPatches, AHalfIsThatOfTheWhole)
    {
      BladeParameters p = plate(6, 18, "0 1 0 0.0833333333333: 1; 0 1 0.9166666666667 1: 1; 0.3 0.6 0.4 0.6: 2");
      const ShellMesh whole(p);
      p.is_halved = true;
      const ShellMesh half(p);
      ASSERT_EQ(2 * half.cells.size(), whole.cells.size());
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 9; ++j)
          {
            const unsigned int right = 18 * i + 9 + j, left = 18 * i + 8 - j;
            EXPECT_LT((half.centroid(9 * i + j) - whole.centroid(right)).norm(), 1e-12);
            EXPECT_EQ(half.material_ids[9 * i + j], whole.material_ids[right]);
            EXPECT_EQ(whole.material_ids[left], whole.material_ids[right]);
            EXPECT_NEAR(whole.centroid(left)[1], -whole.centroid(right)[1], 1e-12);
          }
      EXPECT_EQ(std::count(half.material_ids.begin(), half.material_ids.end(), 1), 2 * 6);
    }

    TEST(MaterialPatches, FollowTheChordOfABladeAndAreInEachOfARow)
    {
      BladeParameters p          = plate(14, 11, "0.2 1 0 0.0833: 1");
      p.mesh.generator           = MeshGenerator::blade;
      p.mesh.profile.root_radius = 0.2;
      p.mesh.profile.chord       = "1 + 0.3*s";
      p.mesh.profile.stagger     = "20 + 40*s";
      p.mesh.profile.camber      = "0.1 - 0.08*s";
      p.mesh.profile.sweep       = "0.03*s^2";
      p.mesh.row.n_blades        = 2;
      p.mesh.row.axis            = {{0., 1., 0.}};
      p.mesh.row.pitch           = 20.;
      const ShellMesh   mesh     = ShellMesh(p);
      const BladeShape  shape(p.mesh);
      std::size_t       n_border = 0;
      const std::size_t n_blade  = mesh.cells.size() / 2;
      for (std::size_t cell = 0; cell < n_blade; ++cell)
        {
          EXPECT_EQ(mesh.material_ids[cell], mesh.material_ids[n_blade + cell]);
          for (unsigned int side = 0; side < 4; ++side)
            if (const auto other = mesh.neighbors[cell][side];
                other >= 0 && mesh.material_ids[cell] != mesh.material_ids[other])
              for (const std::uint32_t n : mesh.side_nodes(cell, side))
                {
                  const Point3 x  = mesh.node(n);
                  const auto   at = shape.coordinates(x.data());
                  EXPECT_TRUE(std::abs(at[0] - 0.2) < 1e-9 || std::abs(at[1] - 0.0833) < 1e-9) << at[0] << ' ' << at[1];
                  ++n_border;
                }
        }
      EXPECT_GE(n_border, 4u * 10);
    }

    TEST(MaterialPatches, RefuseInWords)
    {
      const std::vector<std::pair<std::string, std::string>> refused = {
        {"0 1 0: 1", "cannot read '0 1 0'"},
        {"0 1 0.2 0.1: 1", "cannot read '0 1 0.2 0.1'"},
        {"0 1.2 0 0.1: 1", "shares of the span"},
        {"0 1 nan 0.1: 1", "cannot read 'nan'"},
        {"0 1 0 0.1: 1 2", "has the ids '1 2'"},
        {"0 1 0.3 0.3: 1", "cannot read '0 1 0.3 0.3'"},
        {"0 1 0.1 0.2: 1; 0 1 0.3 0.4: 2", "4 borders cross the blade"}};
      const auto expect = [](const BladeParameters &p, const std::string &words) {
        try
          {
            p.check_geometry();
            ShellMesh mesh(p);
            ADD_FAILURE() << "no refusal: " << words;
          }
        catch (const InputError &error)
          {
            EXPECT_NE(std::string(error.what()).find("Blade/Mesh/Material patches"), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
          }
      };
      for (const auto &[patches, words] : refused)
        expect(plate(6, 4, patches), words);
      BladeParameters p = plate(6, 4, "0 1 0 0.25: 1");
      p.is_halved       = true;
      expect(p, "not symmetric");
      p.is_halved      = false;
      p.mesh.generator = MeshGenerator::file;
      p.mesh.file      = "none.msh";
      expect(p, "a mesh from a file");
    }
  } // namespace
} // namespace birdstrike::material_patches_test
