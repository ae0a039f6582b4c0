#include "solid_mesh_harness.h"
#include "temporary_mesh.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>

namespace birdstrike::solid_mesh_file_test
{
  using namespace solid_mesh_harness;
  using test::TemporaryMesh;

  namespace
  {
    const std::string meshes = std::string(BIRDSTRIKE_SOURCE_DIR) + "/meshes/";

    BladeParameters from_file(const std::string &file)
    {
      BladeParameters p;
      p.mesh.generator = MeshGenerator::file;
      p.mesh.file      = file;
      return p;
    }

    using Places = TemporaryMesh::Places;

    const Places           cube{{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}},
                      {{0, 0, 1}}, {{1, 0, 1}}, {{1, 1, 1}}, {{0, 1, 1}}};
    const std::vector<int> whole{0, 1, 2, 3, 4, 5, 6, 7};

    /// What the user is told, empty if nothing.
    template <typename Make>
    std::string message(const Make &make)
    {
      try
        {
          make();
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    /// The same of reading these cells.
    std::string complaint(const Places &nodes, const std::vector<std::vector<int>> &cells)
    {
      const TemporaryMesh file(nodes, cells, 3);
      return message([&] { const SolidMesh mesh(from_file(file.path)); });
    }

    bool says(const std::string &text, const std::string &piece)
    {
      return text.find(piece) != std::string::npos;
    }

    TEST(SolidMeshFile, FileGivesThePlateOfTheGenerator)
    {
      SolidMesh         file(from_file(meshes + "plate-28x8x1.msh"));
      const SolidMesh   built(plate(28, 8, 1));
      const VolumeMesh &a = file, &b = built;
      EXPECT_EQ(a.nodes.size(), b.nodes.size());
      EXPECT_EQ(a.n_skin_nodes, b.n_skin_nodes);
      EXPECT_EQ(a.boundary_ids, (Ids{1, 2, 3, 4, 5, 6}));
      EXPECT_EQ(a.layers, 0u);
      EXPECT_EQ(a.material_ids[7], 1u);
      for (const auto &[of_file, of_plate] : {std::pair(1u, 0u), {2u, 1u}, {3u, 2u}, {4u, 3u}, {5u, 5u}, {6u, 6u}})
        EXPECT_EQ(a.nodes_on({of_file}).size(), b.nodes_on({of_plate}).size());
      for (const auto n : a.nodes_on({6}))
        EXPECT_NEAR(a.nodes[n][2], 0.5 * 0.00427, 1e-12);
      EXPECT_EQ(expect_closed(a.skin), 0u);
      EXPECT_NEAR(file.compute_mass(4430.).total / (4430. * 0.3112 * 0.0889 * 0.00427), 1., 1e-9) << "ten digits";
    }

    // The sign of a volume that is measured from the origin drowns in round-off: 1e9 cubed times 1e-16 against 1.
    TEST(SolidMeshFile, BricksInsideOutAreTurnedWhereverTheyStand)
    {
      for (const double far : {0., 1e3, 1e6})
        for (const bool is_turned : {false, true})
          {
            Places places = cube;
            for (auto &place : places)
              place = {{1e-3 * place[0] + far, 1e-3 * place[1] - far, 1e-3 * place[2] + 0.5 * far}};
            const std::vector<int> upside_down{4, 5, 6, 7, 0, 1, 2, 3};
            const TemporaryMesh    file(places, {is_turned ? upside_down : whole}, 3);
            EXPECT_NEAR(SolidMesh(from_file(file.path)).compute_mass(1e9).total, 1., 1e-6) << far;
          }
    }

    TEST(SolidMeshFile, ReadsTheSameCubeFromEveryFormat)
    {
      const std::string gmsh4  = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
                                 "$Entities\n0 0 1 1\n1 0 0 0 0 1 1 1 7 0\n1 0 0 0 1 1 1 1 3 0\n$EndEntities\n"
                                 "$Nodes\n1 8 1 8\n3 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n"
                                 "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n$EndNodes\n"
                                 "$Elements\n2 2 1 2\n2 1 3 1\n1 1 5 8 4\n3 1 5 1\n2 1 2 3 4 5 6 7 8\n$EndElements\n";
      const std::string ucd    = "8 2 0 0 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n"
                                 "1 3 hex 1 2 3 4 5 6 7 8\n2 7 quad 1 5 8 4\n";
      const std::string vtk    = "# vtk DataFile Version 3.0\ncube\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n"
                                 "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                                 "CELLS 2 14\n8 0 1 2 3 4 5 6 7\n4 0 4 7 3\nCELL_TYPES 2\n12\n9\n"
                                 "POINT_DATA 8\nSCALARS height double 1\nLOOKUP_TABLE default\n0 0 0 0 .5 .5 .5 .5\n"
                                 "CELL_DATA 2\nSCALARS MaterialID int 1\nLOOKUP_TABLE default\n3\n7\n";
      const std::string abaqus = "*HEADING\ncube\n*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n"
                                 "6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1\n*ELEMENT, TYPE=C3D8R, ELSET=EB3\n"
                                 "1, 1, 2, 3, 4, 5, 6, 7, 8\n*ELSET, ELSET=SS7_S6\n1\n"
                                 "*SURFACE, NAME=SS7\nSS7_S6, S6\n";
      for (const auto &[ending, text] :
           {std::pair(".msh", gmsh4), {".inp", ucd}, {".vtk", vtk}, {"-abaqus.inp", abaqus}})
        {
          const TemporaryMesh file(ending, text);
          BladeParameters     p = from_file(file.path);
          p.mesh.file_scale     = 1e-3;
          const SolidMesh   solid(p);
          const VolumeMesh &mesh = solid;
          ASSERT_EQ(mesh.cells.size(), 1u) << ending;
          EXPECT_EQ(mesh.n_skin_nodes, 8u) << ending;
          EXPECT_NEAR(solid.compute_mass(1.).total, 1e-9, 1e-21) << ending;
          EXPECT_EQ(mesh.material_ids[0], 3u) << ending;
          EXPECT_EQ(mesh.boundary_ids, (Ids{0, 7})) << ending;
          for (const auto n : mesh.nodes_on({7}))
            EXPECT_EQ(mesh.nodes[n][0], 0.) << ending;
          EXPECT_EQ(mesh.nodes_on({7}).size(), 4u) << ending;
        }
    }

    TEST(SolidMeshFile, NamesTheDimensionThatIsWrong)
    {
      const auto solid = message([] { const SolidMesh mesh(from_file(meshes + "plate-28x8.msh")); });
      EXPECT_TRUE(says(solid, "holds 224 quadrilaterals, but hexahedra are needed")) << solid;
      EXPECT_TRUE(says(solid, "Set Blade/Kind = shell")) << solid;
      const auto shell = message([] { const ShellMesh mesh(from_file(meshes + "plate-28x8x1.msh")); });
      EXPECT_TRUE(says(shell, "holds 224 hexahedra, but quadrilaterals of the mid-surface are needed")) << shell;
      EXPECT_TRUE(says(shell, "Set Blade/Kind = solid")) << shell;
    }

    TEST(SolidMeshFile, TellsAbaqusElementsApart)
    {
      const std::string   nodes = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n"
                                  "7, 1, 1, 1\n8, 0, 1, 1\n";
      const std::string   brick = "*ELEMENT, TYPE=C3D8, ELSET=EB1\n1, 1, 2, 3, 4, 5, 6, 7, 8\n";
      const std::string   shell = "*ELEMENT, type=S4R, ELSET=EB1\n1, 1, 2, 3, 4\n";
      const TemporaryMesh bricks(".inp", "*HEADING\n" + nodes + brick);
      EXPECT_NO_THROW(SolidMesh{from_file(bricks.path)});
      const auto of_bricks = message([&] { const ShellMesh mesh(from_file(bricks.path)); });
      EXPECT_TRUE(says(of_bricks, "holds 1 hexahedra")) << of_bricks;
      const TemporaryMesh shells("-s.inp", "*HEADING\n" + nodes.substr(0, nodes.find("5, 0")) + shell);
      EXPECT_NO_THROW(ShellMesh{from_file(shells.path)});
      const auto of_shells = message([&] { const SolidMesh mesh(from_file(shells.path)); });
      EXPECT_TRUE(says(of_shells, "holds 1 quadrilaterals")) << of_shells;
      // bricks make a body, and a shell on one of their faces names it
      const TemporaryMesh both("-b.inp",
                               "*HEADING\n" + nodes + "*ELEMENT, TYPE=S4, ELSET=SS7\n2, 1, 2, 3, 4\n" + brick);
      EXPECT_EQ(SolidMesh(from_file(both.path)).boundary_ids, (Ids{0, 7}));
      EXPECT_TRUE(says(message([&] { const ShellMesh mesh(from_file(both.path)); }), "holds 1 hexahedra"));
    }

    TEST(SolidMeshFile, RefusesBadFiles)
    {
      EXPECT_THROW(SolidMesh{from_file("no-such.msh")}, InputError);
      EXPECT_THROW(SolidMesh{from_file("no-such.inp")}, InputError);
      EXPECT_THROW(SolidMesh{from_file("plate.stl")}, InputError);
      EXPECT_THROW(SolidMesh{from_file(meshes + "README.md")}, InputError);
      const TemporaryMesh nonsense(".msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\nmany\n");
      EXPECT_THROW(SolidMesh{from_file(nonsense.path)}, InputError);
    }

    TEST(SolidMeshFile, RefusesBadCells)
    {
      EXPECT_EQ(complaint(cube, {whole}), "");
      EXPECT_TRUE(says(complaint(cube, {{0, 1, 2, 4}}), "type 4, a tetrahedron. Allowed: hexahedra"));
      EXPECT_TRUE(says(complaint(cube, {{0, 1, 2, 3, 4, 5, 5, 4}}), "element 1 has the node 5 more than once"));
      EXPECT_TRUE(says(complaint(cube, {whole, whole}), "elements 1 and 2 have the same nodes"));
      auto three = cube; // on the face z = 1: the cube, and two that lie in one another
      for (const double z : {2., 3.})
        three.insert(three.end(), {{{0, 0, z}}, {{1, 0, z}}, {{1, 1, z}}, {{0, 1, z}}});
      const std::string text = complaint(three, {whole, {4, 5, 6, 7, 8, 9, 10, 11}, {4, 5, 6, 7, 12, 13, 14, 15}});
      EXPECT_TRUE(says(text, "elements 1, 2 and 3 share a face, between the nodes 5 and 8")) << text;
      auto folded = cube;
      folded[6]   = {{0.2, 0.2, 0.2}};
      EXPECT_TRUE(says(complaint(folded, {whole}), "cell 0 at")) << complaint(folded, {whole});
      auto flat = cube;
      for (unsigned int k = 4; k < 8; ++k)
        flat[k][2] = 0.;
      EXPECT_TRUE(says(complaint(flat, {whole}), "without volume")) << complaint(flat, {whole});
    }

    TEST(SolidMeshFile, RefusesLoosePieces)
    {
      const auto with_a_second = [](const double x, const double y) {
        Places both = cube;
        for (const auto &node : cube)
          both.push_back({{node[0] + x, node[1] + y, node[2]}});
        return both;
      };
      const std::string apart = complaint(with_a_second(5, 0), {whole, {8, 9, 10, 11, 12, 13, 14, 15}});
      EXPECT_TRUE(says(apart, "falls into pieces")) << apart;
      const std::string by_an_edge = complaint(with_a_second(1, 1), {whole, {2, 9, 10, 11, 6, 13, 14, 15}});
      EXPECT_TRUE(says(by_an_edge, "falls into pieces")) << by_an_edge;
    }

    TEST(SolidMeshFile, RefusesCellsThatTouchAlongAnEdgeOnly)
    {
      Places     nodes;
      const auto at = [](const int i, const int j, const int k) { return (i * 3 + j) * 3 + k; };
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for (int k = 0; k < 3; ++k)
            nodes.push_back({{double(i), double(j), double(k)}});
      const auto cell = [&](const int i, const int j, const int k) {
        return std::vector<int>{at(i, j, k),     at(i + 1, j, k),     at(i + 1, j + 1, k),     at(i, j + 1, k),
                                at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)};
      };
      std::vector<std::vector<int>> two_legs{cell(0, 0, 1), cell(0, 1, 1), cell(1, 0, 1),
                                             cell(1, 1, 1), cell(0, 0, 0), cell(1, 1, 0)};
      EXPECT_TRUE(says(complaint(nodes, two_legs), "share an edge only")) << complaint(nodes, two_legs);
      two_legs.push_back(cell(0, 1, 0));
      EXPECT_EQ(complaint(nodes, two_legs), "");
    }
  } // namespace
} // namespace birdstrike::solid_mesh_file_test
