#include <birdstrike/blade/shell_mesh.h>
#include <birdstrike/blade/solid_mesh.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>

namespace birdstrike
{
  namespace
  {
    using Ids = std::vector<unsigned int>;

    const std::string meshes = std::string(BIRDSTRIKE_SOURCE_DIR) + "/meshes/";

    BladeParameters plate(const unsigned int n_span, const unsigned int n_chord, const unsigned int n_layers)
    {
      BladeParameters p;
      p.mesh.n_span   = n_span;
      p.mesh.n_chord  = n_chord;
      p.mesh.n_layers = n_layers;
      return p;
    }

    BladeParameters from_file(const std::string &file)
    {
      BladeParameters p;
      p.mesh.generator = "file";
      p.mesh.file      = file;
      return p;
    }

    /// A mesh file that lives as long as this object.
    class TemporaryFile
    {
    public:
      TemporaryFile(const std::string &ending, const std::string &text)
        : path(std::filesystem::temp_directory_path() / ("birdstrike-solid-" + std::to_string(getpid()) + ending))
      {
        std::ofstream(path) << text;
      }
      ~TemporaryFile()
      {
        std::filesystem::remove(path);
      }
      const std::filesystem::path path;
    };

    using Places = std::vector<std::array<double, 3>>;

    /// Gmsh 2.2 text of hexahedra, or of whatever has as many nodes.
    std::string gmsh(const Places &nodes, const std::vector<std::vector<int>> &cells)
    {
      std::ostringstream out;
      out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << nodes.size() << '\n';
      for (std::size_t n = 0; n < nodes.size(); ++n)
        out << n + 1 << ' ' << nodes[n][0] << ' ' << nodes[n][1] << ' ' << nodes[n][2] << '\n';
      out << "$EndNodes\n$Elements\n" << cells.size() << '\n';
      for (std::size_t c = 0; c < cells.size(); ++c)
        {
          out << c + 1 << (cells[c].size() == 8 ? " 5" : " 4") << " 2 1 1";
          for (const int n : cells[c])
            out << ' ' << n + 1;
          out << '\n';
        }
      out << "$EndElements\n";
      return out.str();
    }

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
      const TemporaryFile file(".msh", gmsh(nodes, cells));
      return message([&] { const SolidMesh mesh(from_file(file.path)); });
    }

    bool says(const std::string &text, const std::string &piece)
    {
      return text.find(piece) != std::string::npos;
    }

    /// Each side of each facet meets its neighbour in the opposite direction; returns how many are cut by the plane.
    unsigned int expect_closed(const SurfaceMesh &skin)
    {
      unsigned int n_cut = 0;
      for (std::size_t f = 0; f < skin.cells.size(); ++f)
        for (unsigned int k = 0; k < 4; ++k)
          {
            const std::int32_t other = skin.neighbors[f][k];
            EXPECT_NE(other, FacetsView::free_edge);
            n_cut += other == FacetsView::symmetry_edge;
            if (other < 0)
              continue;
            bool meets = false;
            for (unsigned int j = 0; j < 4; ++j)
              meets =
                meets || (skin.neighbors[other][j] == int(f) && skin.cells[other][j] == skin.cells[f][(k + 1) % 4] &&
                          skin.cells[other][(j + 1) % 4] == skin.cells[f][k]);
            EXPECT_TRUE(meets) << "facet " << f << " side " << k;
          }
      return n_cut;
    }

    /// Volume enclosed by outward facets: int x . n dA / 3, exact for flat ones.
    double enclosed_volume(const SurfaceMesh &skin)
    {
      double sum = 0.;
      for (std::size_t f = 0; f < skin.cells.size(); ++f)
        sum += skin.centroid(f).dot(skin.area_vector(f)) / 3.;
      return sum;
    }

    double total_volume(const VolumeMesh &mesh)
    {
      double sum = 0.;
      for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        sum += mesh.volume(cell);
      return sum;
    }

    TEST(SolidMesh, PlateHasTheFacesOfItsShell)
    {
      const BladeParameters p = plate(28, 8, 2);
      const SolidMesh       solid(p);
      const ShellMesh       shell(p.mesh);
      const VolumeMesh     &mesh = solid.volume();
      EXPECT_EQ(mesh.nodes.size(), 29u * 9u * 3u);
      EXPECT_EQ(mesh.n_skin_nodes, mesh.nodes.size() - 27u * 7u);
      EXPECT_EQ(mesh.cells.size(), 28u * 8u * 2u);
      EXPECT_EQ(mesh.faces.size(), 2u * (28u * 8u + 28u * 2u + 8u * 2u));
      EXPECT_EQ(mesh.boundary_ids(), (Ids{0, 1, 2, 3, 5, 6}));
      EXPECT_EQ(mesh.layers, 2u);

      // Root, tip, edges and mid-surface are those of the shell, to the last bit.
      std::set<std::array<double, 3>> places(mesh.nodes.begin(), mesh.nodes.end());
      for (const auto &node : shell.surface().nodes)
        EXPECT_EQ(places.count(node), 1u);
      const std::vector<std::pair<unsigned int, unsigned int>> lines{{0, 9}, {1, 9}, {2, 29}, {3, 29}};
      for (const auto &[id, n] : lines)
        {
          const auto row = mesh.nodes_on({id}), of_shell = shell.surface().rim_nodes({id});
          ASSERT_EQ(row.size(), 3u * n);
          const unsigned int d = id < 2 ? 0 : 1;
          for (const auto k : row)
            EXPECT_EQ(mesh.nodes[k][d], shell.surface().nodes[of_shell[0]][d]);
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
      const VolumeMesh  &mesh = solid.volume();
      const SurfaceMesh &skin = mesh.skin;
      EXPECT_EQ(expect_closed(skin), 0u);
      Point3 area = Point3::Zero();
      for (std::size_t f = 0; f < skin.cells.size(); ++f)
        {
          area += skin.area_vector(f);
          EXPECT_EQ(skin.cells[f], mesh.faces[f].nodes);
          EXPECT_GT(skin.area_vector(f).dot(skin.centroid(f) - mesh.centroid(mesh.faces[f].cell)), 0.);
          for (const auto n : skin.cells[f])
            EXPECT_LT(n, mesh.n_skin_nodes);
        }
      EXPECT_LT(area.norm(), 1e-15);
      EXPECT_NEAR(enclosed_volume(skin) / total_volume(mesh), 1., 1e-13);
      EXPECT_NEAR(total_volume(mesh) / (p.mesh.chord * (0.01 * p.mesh.length + 0.01 * std::pow(p.mesh.length, 2))), 1.,
                  1e-13);
      ASSERT_EQ(skin.nodes.size(), mesh.n_skin_nodes);
      EXPECT_EQ(mesh.nearest_node(mesh.node(mesh.n_skin_nodes + 1)), mesh.n_skin_nodes + 1) << "inner nodes count too";
    }

    // Row sums of a graded box: each node carries its tributary lengths along the three axes.
    TEST(SolidMesh, LumpsTheExactMass)
    {
      BladeParameters p    = plate(5, 3, 4);
      p.mesh.span_grading  = 4.;
      p.mesh.chord_grading = 0.5;
      p.mesh.layer_grading = 2.;
      SolidMesh solid(p);
      solid.distribute_dofs();
      const SolidMesh::Mass mass  = solid.compute_mass(4430.);
      const VolumeMesh     &mesh  = solid.volume();
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
        EXPECT_NEAR(mass.element[cell] / (4430. * mesh.volume(cell)), 1., 1e-13);
    }

    TEST(SolidMesh, LayersGrowFromTheFacesToTheMiddle)
    {
      BladeParameters p    = plate(1, 1, 5);
      p.mesh.layer_grading = 4.;
      p.thickness.value    = "0.01";
      const SolidMesh solid(p);
      const auto     &mesh        = solid.volume();
      double          expected[5] = {1., 2., 4., 2., 1.};
      for (unsigned int k = 0; k < 5; ++k)
        EXPECT_NEAR(mesh.volume(k) / mesh.volume(0), expected[k], 1e-12);
      for (unsigned int k = 0; k < 5; ++k)
        EXPECT_LT(mesh.node(mesh.cells[k][0])[2], mesh.node(mesh.cells[k][4])[2]) << "third axis along the normal";
    }

    TEST(SolidMesh, ThicknessFollowsMaterialAndIsPositive)
    {
      BladeParameters p       = plate(2, 2, 1);
      p.thickness.by_material = "0: 0.01";
      EXPECT_NEAR(total_volume(SolidMesh(p).volume()), 0.01 * p.mesh.length * p.mesh.chord, 1e-17);
      p.thickness.by_material = "";
      p.thickness.value       = "0.01*(x-0.2)";
      EXPECT_THROW(SolidMesh{p}, InputError);
    }

    TEST(SolidMesh, HalfAPlateIsCutAtThePlane)
    {
      BladeParameters p = plate(6, 4, 2);
      p.is_halved       = true;
      SolidMesh solid(p);
      solid.distribute_dofs();
      const VolumeMesh &mesh = solid.volume();
      EXPECT_EQ(mesh.boundary_ids(), (Ids{0, 1, 3, 4, 5, 6}));
      EXPECT_EQ(mesh.mirrored_ids, (Ids{2}));
      EXPECT_EQ(mesh.symmetry_faces.size(), 6u * 2u);
      EXPECT_EQ(mesh.symmetry_nodes.size(), 7u * 3u);
      EXPECT_EQ(mesh.nodes_on({4}), mesh.symmetry_nodes);
      for (const auto n : mesh.symmetry_nodes)
        EXPECT_EQ(mesh.nodes[n][1], 0.);
      EXPECT_EQ(mesh.skin.symmetry_nodes.size(), 2u * 7u + 2u) << "the rim of the cut; its inside is no skin";
      EXPECT_EQ(expect_closed(mesh.skin), 2u * 6u + 2u * 2u);
      for (const auto &face : mesh.faces)
        EXPECT_NE(face.id, 4u);
      EXPECT_NEAR(solid.compute_mass(1.).total / (0.5 * p.mesh.length * p.mesh.chord * 0.00427), 1., 1e-14);
      p.mesh.n_chord = 3;
      EXPECT_THROW(SolidMesh{p}, InputError);
    }

    TEST(SolidMesh, FileGivesThePlateOfTheGenerator)
    {
      SolidMesh         file(from_file(meshes + "plate-14x4x2.msh"));
      const SolidMesh   built(plate(14, 4, 2));
      const VolumeMesh &a = file.volume(), &b = built.volume();
      EXPECT_EQ(a.nodes.size(), b.nodes.size());
      EXPECT_EQ(a.n_skin_nodes, b.n_skin_nodes);
      EXPECT_EQ(a.boundary_ids(), (Ids{1, 2, 3, 4, 5, 6}));
      EXPECT_EQ(a.layers, 0u);
      EXPECT_EQ(a.material_ids[7], 1u);
      for (const auto &[of_file, of_plate] : {std::pair(1u, 0u), {2u, 1u}, {3u, 2u}, {4u, 3u}, {5u, 5u}, {6u, 6u}})
        EXPECT_EQ(a.nodes_on({of_file}).size(), b.nodes_on({of_plate}).size());
      for (const auto n : a.nodes_on({6}))
        EXPECT_NEAR(a.nodes[n][2], 0.5 * 0.00427, 1e-12);
      EXPECT_EQ(expect_closed(a.skin), 0u);
      file.distribute_dofs();
      EXPECT_NEAR(file.compute_mass(4430.).total / (4430. * 0.3112 * 0.0889 * 0.00427), 1., 1e-9) << "ten digits";
    }

    // One cube in millimetres with boundary 7 at x = 0 and material 3, in each format.
    TEST(SolidMesh, ReadsTheSameCubeFromEveryFormat)
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
                                 "CELL_DATA 2\nSCALARS MaterialID int 1\nLOOKUP_TABLE default\n3\n7\n";
      const std::string abaqus = "*HEADING\ncube\n*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n"
                                 "6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1\n*ELEMENT, TYPE=C3D8R, ELSET=EB3\n"
                                 "1, 1, 2, 3, 4, 5, 6, 7, 8\n*ELSET, ELSET=SS7_S6\n1\n"
                                 "*SURFACE, NAME=SS7\nSS7_S6, S6\n";
      for (const auto &[ending, text] :
           {std::pair(".msh", gmsh4), {".inp", ucd}, {".vtk", vtk}, {"-abaqus.inp", abaqus}})
        {
          const TemporaryFile file(ending, text);
          BladeParameters     p = from_file(file.path);
          p.mesh.file_scale     = 1e-3;
          const SolidMesh   solid(p);
          const VolumeMesh &mesh = solid.volume();
          ASSERT_EQ(mesh.cells.size(), 1u) << ending;
          EXPECT_EQ(mesh.n_skin_nodes, 8u) << ending;
          EXPECT_NEAR(mesh.volume(0), 1e-9, 1e-21) << ending;
          EXPECT_EQ(mesh.material_ids[0], 3u) << ending;
          EXPECT_EQ(mesh.boundary_ids(), (Ids{0, 7})) << ending;
          for (const auto n : mesh.nodes_on({7}))
            EXPECT_EQ(mesh.nodes[n][0], 0.) << ending;
          EXPECT_EQ(mesh.nodes_on({7}).size(), 4u) << ending;
        }
    }

    TEST(SolidMesh, NamesTheDimensionThatIsWrong)
    {
      const auto solid = message([] { const SolidMesh mesh(from_file(meshes + "plate-28x8.msh")); });
      EXPECT_TRUE(says(solid, "holds 224 quadrilaterals, but hexahedra are needed")) << solid;
      EXPECT_TRUE(says(solid, "Set Blade/Kind = shell")) << solid;
      const auto shell = message([] { const ShellMesh mesh(from_file(meshes + "plate-14x4x2.msh").mesh); });
      EXPECT_TRUE(says(shell, "holds 112 hexahedra, but quadrilaterals of the mid-surface are needed")) << shell;
      EXPECT_TRUE(says(shell, "Set Blade/Kind = solid")) << shell;
    }

    // deal.II's Abaqus reader takes the nodes of any element type as they come; quadrilaterals beside bricks confuse
    // it.
    TEST(SolidMesh, TellsAbaqusElementsApart)
    {
      const std::string   nodes = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n"
                                  "7, 1, 1, 1\n8, 0, 1, 1\n";
      const std::string   brick = "*ELEMENT, TYPE=C3D8, ELSET=EB1\n1, 1, 2, 3, 4, 5, 6, 7, 8\n";
      const std::string   shell = "*ELEMENT, type=S4R, ELSET=EB1\n1, 1, 2, 3, 4\n";
      const TemporaryFile bricks(".inp", "*HEADING\n" + nodes + brick);
      EXPECT_NO_THROW(SolidMesh{from_file(bricks.path)});
      const auto of_bricks = message([&] { const ShellMesh mesh(from_file(bricks.path).mesh); });
      EXPECT_TRUE(says(of_bricks, "holds 1 hexahedra")) << of_bricks;
      const TemporaryFile shells("-s.inp", "*HEADING\n" + nodes.substr(0, nodes.find("5, 0")) + shell);
      EXPECT_NO_THROW(ShellMesh{from_file(shells.path).mesh});
      const auto of_shells = message([&] { const SolidMesh mesh(from_file(shells.path)); });
      EXPECT_TRUE(says(of_shells, "holds 1 quadrilaterals")) << of_shells;
      const TemporaryFile both("-b.inp", "*HEADING\n" + nodes + shell + brick);
      EXPECT_TRUE(says(message([&] { const SolidMesh mesh(from_file(both.path)); }), "is not a mesh of hexahedra"));
    }

    TEST(SolidMesh, RefusesBadFiles)
    {
      EXPECT_THROW(SolidMesh{from_file("no-such.msh")}, InputError);
      EXPECT_THROW(SolidMesh{from_file("no-such.inp")}, InputError);
      EXPECT_THROW(SolidMesh{from_file("plate.stl")}, InputError);
      EXPECT_THROW(SolidMesh{from_file(meshes + "README.md")}, InputError);
      const TemporaryFile nonsense(".msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\nmany\n");
      EXPECT_THROW(SolidMesh{from_file(nonsense.path)}, InputError);
    }

    TEST(SolidMesh, RefusesBadCells)
    {
      EXPECT_EQ(complaint(cube, {whole}), "");
      EXPECT_TRUE(says(complaint(cube, {{0, 1, 2, 4}}), "not hexahedra"));
      auto folded = cube;
      folded[6]   = {{0.2, 0.2, 0.2}};
      EXPECT_TRUE(says(complaint(folded, {whole}), "cell 0 at")) << complaint(folded, {whole});
      auto flat = cube;
      for (unsigned int k = 4; k < 8; ++k)
        flat[k][2] = 0.;
      EXPECT_TRUE(says(complaint(flat, {whole}), "without volume")) << complaint(flat, {whole});
    }

    TEST(SolidMesh, RefusesLoosePieces)
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

    // Four cells on two legs that stand across the corner: the legs are joined above, but share an edge below.
    TEST(SolidMesh, RefusesCellsThatTouchAlongAnEdgeOnly)
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
      EXPECT_TRUE(says(complaint(nodes, two_legs), "along an edge only")) << complaint(nodes, two_legs);
      two_legs.push_back(cell(0, 1, 0));
      EXPECT_EQ(complaint(nodes, two_legs), "");
    }
  } // namespace
} // namespace birdstrike
