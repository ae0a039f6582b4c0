#include "temporary_mesh.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/structure/parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <numeric>

namespace birdstrike::shell_mesh_test
{
  namespace
  {
    const std::string plate_file = std::string(BIRDSTRIKE_SOURCE_DIR) + "/meshes/plate-28x8.msh";

    ShellMesh::Mass mass_of(const BladeParameters::Mesh &parameters, const ThicknessLaw &thickness)
    {
      ShellMesh mesh({parameters});
      return mesh.compute_mass(4430., thickness);
    }

    ShellMesh read(const test::TemporaryMesh::Places &nodes, const test::TemporaryMesh::Cells &cells)
    {
      return ShellMesh({test::TemporaryMesh(nodes, cells).parameters()});
    }

    // Round-off of some hundred additions: 1e-14.
    TEST(ShellMesh, LumpsTheExactMassOfAPlate)
    {
      const BladeParameters::Mesh p;
      const auto                  mass  = mass_of(p, [](const SurfacePlace &) { return 0.00427; });
      const double                exact = 4430. * p.length * p.chord * 0.00427;
      EXPECT_NEAR(mass.total / exact, 1., 1e-14);
      EXPECT_NEAR(std::accumulate(mass.node.begin(), mass.node.end(), 0.) / exact, 1., 1e-14);
      EXPECT_NEAR(exact, 0.52333, 5e-6); // benchmark A4
    }

    // A linear thickness times a bilinear map is integrated exactly by 2x2 points.
    TEST(ShellMesh, LumpsTheExactMassOfATaperedGradedPlate)
    {
      BladeParameters::Mesh p;
      p.span_grading   = 5.;
      p.chord_grading  = 0.5;
      const auto   law = [](const SurfacePlace &at) { return 0.006 - 0.01 * at.position[0]; };
      const double l   = p.length;
      EXPECT_NEAR(mass_of(p, law).total / (4430. * p.chord * (0.006 * l - 0.005 * l * l)), 1., 1e-14);
    }

    // m max(t^2/12, A/8): thin elements carry A/8, thick ones t^2/12.
    TEST(ShellMesh, ScalesRotaryInertia)
    {
      BladeParameters::Mesh p;
      p.n_span = p.n_chord = 1;
      const double area    = p.length * p.chord;
      const auto   thin    = mass_of(p, [](const SurfacePlace &) { return 0.001; });
      const auto   thick   = mass_of(p, [](const SurfacePlace &) { return 1.; });
      EXPECT_NEAR(thin.rotary[0] / thin.node[0], area / 8., 1e-15);
      EXPECT_NEAR(thick.rotary[0] / thick.node[0], 1. / 12., 1e-15);
    }

    TEST(ShellMesh, GradesBetweenFirstAndLast)
    {
      BladeParameters::Mesh p;
      p.n_span       = 10;
      p.n_chord      = 1;
      p.span_grading = 10.;
      const ShellMesh mesh({p});
      const auto     &s     = mesh;
      const double    first = s.area_vector(0).norm(), last = s.area_vector(9).norm();
      EXPECT_NEAR(last / first, 10., 1e-9);
    }

    TEST(ShellMesh, FileGivesThePlateOfTheGenerator)
    {
      BladeParameters::Mesh from_file;
      from_file.generator = MeshGenerator::file;
      from_file.file      = plate_file;
      ShellMesh file({from_file}), built({BladeParameters::Mesh()});
      EXPECT_EQ(file.nodes.size(), built.nodes.size());
      EXPECT_EQ(file.boundary_ids, (std::vector<unsigned int>{1, 2, 3, 4}));
      EXPECT_EQ(built.boundary_ids, (std::vector<unsigned int>{0, 1, 2, 3}));
      EXPECT_EQ(file.nodes_on({1}).size(), 9u);
      EXPECT_EQ(file.nodes_on({4}).size(), 29u);
      EXPECT_GT(file.area_vector(0)[2], 0.);
      EXPECT_EQ(file.material_ids[5], 1u);
    }

    // As editors on Windows leave it: a mark of UTF-8 first, lines that end in \r\n, a capital ending.
    TEST(ShellMesh, ReadsWhatWindowsMakesOfAFile)
    {
      std::ifstream in(plate_file);
      std::string   text = "\xEF\xBB\xBF";
      for (std::string line; std::getline(in, line);)
        text += line + "\r\n";
      const test::TemporaryMesh file(".MSH", text);
      BladeParameters::Mesh     as_it_is;
      as_it_is.generator = MeshGenerator::file;
      as_it_is.file      = plate_file;
      EXPECT_EQ(ShellMesh({file.parameters()}).nodes, ShellMesh({as_it_is}).nodes);
    }

    // Gmsh 4.1 names boundary ids by the physical tags of its entities; 'File scale' turns millimetres into metres.
    TEST(ShellMesh, ReadsGmshFour)
    {
      const test::TemporaryMesh file(
        ".msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
                "$Entities\n0 1 1 0\n1 0 0 0 0 1 0 1 7 0\n1 0 0 0 2 1 0 1 3 0\n$EndEntities\n"
                "$Nodes\n1 6 1 6\n2 1 0 6\n1\n2\n3\n4\n5\n6\n"
                "0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n$EndNodes\n"
                "$Elements\n2 3 1 3\n1 1 1 1\n1 1 4\n2 1 3 2\n2 1 2 5 4\n3 2 3 6 5\n$EndElements\n");
      auto p       = file.parameters();
      p.file_scale = 1e-3;
      const ShellMesh mesh({p});
      EXPECT_EQ(mesh.boundary_ids, (std::vector<unsigned int>{0, 7}));
      EXPECT_EQ(mesh.nodes_on({7}).size(), 2u);
      EXPECT_EQ(mesh.material_ids[0], 3u);
      EXPECT_NEAR(mesh.area_vector(0)[2], 1e-6, 1e-18);
    }

    TEST(ShellMesh, KnowsNeighboursAcrossEdges)
    {
      BladeParameters::Mesh p;
      p.n_span  = 3;
      p.n_chord = 2;
      const ShellMesh mesh({p});
      const auto     &s      = mesh;
      unsigned int    n_free = 0;
      for (std::size_t cell = 0; cell < s.cells.size(); ++cell)
        for (unsigned int side = 0; side < 4; ++side)
          {
            const int other = s.neighbors[cell][side];
            n_free += other < 0;
            if (other < 0)
              continue;
            const auto back = std::find(s.neighbors[other].begin(), s.neighbors[other].end(), int(cell));
            ASSERT_NE(back, s.neighbors[other].end());
            const unsigned int k = back - s.neighbors[other].begin();
            EXPECT_EQ(s.cells[cell][side], s.cells[other][(k + 1) % 4]);
            EXPECT_EQ(s.cells[cell][(side + 1) % 4], s.cells[other][k]);
          }
      EXPECT_EQ(n_free, 10u);
    }

    TEST(ShellMesh, RefusesBadFiles)
    {
      BladeParameters::Mesh p;
      p.generator = MeshGenerator::file;
      p.file      = "no-such.msh";
      EXPECT_THROW(ShellMesh({p}), InputError);
      p.file = "plate.stl";
      EXPECT_THROW(ShellMesh({p}), InputError);
      p.file = std::string(BIRDSTRIKE_SOURCE_DIR) + "/meshes/README.md";
      EXPECT_THROW(ShellMesh({p}), InputError);
      for (const std::string ending : {".msh", ".vtk", ".inp", ".k"})
        try
          {
            ShellMesh({test::TemporaryMesh(ending, "").parameters()});
            ADD_FAILURE() << ending;
          }
        catch (const InputError &error)
          {
            EXPECT_NE(std::string(error.what()).find("is empty"), std::string::npos) << error.what();
          }
    }

    TEST(ShellMesh, RefusesBadCells)
    {
      const std::vector<std::array<double, 3>> square{{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}}};
      EXPECT_NO_THROW(read(square, {{0, 1, 2, 3}}));
      EXPECT_THROW(read(square, {{0, 1, 2}, {0, 2, 3}}), InputError);
      EXPECT_THROW(read(square, {{0, 2, 1, 3}}), InputError); // crossed
      auto folded = square;
      folded[2]   = {{0.2, 0.2, 0.}};
      EXPECT_THROW(read(folded, {{0, 1, 2, 3}}), InputError); // re-entrant corner
      auto flat = square;
      flat[2]   = flat[1];
      EXPECT_THROW(read(flat, {{0, 1, 2, 3}}), InputError); // edge without length
    }

    TEST(ShellMesh, RefusesALoosePieceAndABranch)
    {
      std::vector<std::array<double, 3>> two{{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}},
                                             {{5, 0, 0}}, {{6, 0, 0}}, {{6, 1, 0}}, {{5, 1, 0}}};
      EXPECT_THROW(read(two, {{0, 1, 2, 3}, {4, 5, 6, 7}}), InputError);
      std::vector<std::array<double, 3>> branch{{{0, 0, 0}},  {{1, 0, 0}},  {{1, 1, 0}}, {{0, 1, 0}},
                                                {{-1, 0, 0}}, {{-1, 1, 0}}, {{0, 0, 1}}, {{0, 1, 1}}};
      EXPECT_THROW(read(branch, {{0, 1, 2, 3}, {0, 3, 5, 4}, {0, 3, 7, 6}}), InputError);
    }

    // A cell numbered the other way round is turned, not refused: neighbours then agree on the normal.
    TEST(ShellMesh, TurnsCellsThatDisagree)
    {
      const ShellMesh mesh = read({{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}, {{0, 1, 0}}, {{1, 1, 0}}, {{2, 1, 0}}},
                                  {{0, 1, 4, 3}, {1, 4, 5, 2}});
      EXPECT_GT(mesh.area_vector(0)[2], 0.);
      EXPECT_GT(mesh.area_vector(1)[2], 0.);
      EXPECT_EQ(std::count(mesh.neighbors[1].begin(), mesh.neighbors[1].end(), 0), 1);
    }
  } // namespace
} // namespace birdstrike::shell_mesh_test
