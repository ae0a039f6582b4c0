#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>

#include <gtest/gtest.h>

// The same plate and body in every format that Gmsh itself writes (tests/data/gmsh), groups by their names.
namespace birdstrike::gmsh_exports_test
{
  namespace
  {
    template <int dim>
    BladeMesh<dim> read(const std::string &ending)
    {
      GeometryParameters p;
      p.mesh.generator = MeshGenerator::file;
      p.mesh.file = std::string(BIRDSTRIKE_SOURCE_DIR) + "/tests/data/gmsh/" + (dim == 2 ? "plate" : "body") + ending;
      return BladeMesh<dim>(p);
    }

    struct Export
    {
      std::string ending, root, tip, leading, metal;
    };
    std::vector<Export> exports(const int dim)
    {
      return {{".msh", "root", "tip", "leading_edge", "blade_metal"},
              {"-v2.msh", "root", "tip", "leading_edge", "blade_metal"},
              {"-v2.msh", "1", "2", "3", "5"},
              {".inp", "root", "TIP", "leading_edge", "blade_metal"},
              {".key", "1", "node_set_2", "3", dim == 2 ? "part_2000001" : "3000001"}, // Gmsh's own part ids
              {".vtk", "1", "2", "3", "5"}};
    }

    /// Whether all nodes of a boundary lie at this place along an axis, and how many there are. Gmsh writes twelve
    /// digits into .key and .inp files.
    template <int dim>
    void expect_at(const BladeMesh<dim> &mesh, const std::string &name, const int axis, const double place,
                   const std::size_t n, const std::string &what)
    {
      const auto nodes = mesh.nodes_on(mesh.boundary_names.parse(name, "Blade/Supports/Clamped"));
      EXPECT_EQ(nodes.size(), n) << what;
      for (const std::uint32_t node : nodes)
        EXPECT_NEAR(mesh.nodes[node][axis], place, 1e-11) << what;
    }

    template <int dim>
    void expect_groups()
    {
      const unsigned int layers = dim == 2 ? 1 : 2;
      for (const auto &[ending, root, tip, leading, metal] : exports(dim))
        {
          const auto mesh = read<dim>(ending);
          ASSERT_EQ(mesh.cells.size(), 6u) << ending;
          EXPECT_EQ(mesh.nodes.size(), 12u * layers) << ending;
          expect_at(mesh, root, 0, 0., 3 * layers, ending + " root");
          expect_at(mesh, tip, 0, 0.2, 3 * layers, ending + " tip");
          expect_at(mesh, leading, 1, -0.05, 4 * layers, ending + " leading");
          const auto ids = mesh.material_names.parse(metal, "Blade/Section 1/Material ids");
          for (const unsigned int id : mesh.material_ids)
            EXPECT_TRUE(std::find(ids.begin(), ids.end(), id) != ids.end()) << ending << ": " << id;
        }
    }
  } // namespace

  TEST(GmshExports, GroupsOfAPlateAreKnownByName)
  {
    expect_groups<2>();
  }

  TEST(GmshExports, GroupsOfABodyAreKnownByName)
  {
    expect_groups<3>();
  }

  TEST(GmshExports, AnUnknownNameIsAnsweredWithThoseOfTheFile)
  {
    try
      {
        read<2>(".msh").boundary_names.parse("rot", "Blade/Supports/Clamped");
        FAIL();
      }
    catch (const InputError &error)
      {
        EXPECT_STREQ(error.what(), "Blade/Supports/Clamped: the mesh has no boundary 'rot'.\nNames in this mesh: "
                                   "leading_edge, root, tip, trailing_edge; or give an id, a whole number.");
      }
  }
} // namespace birdstrike::gmsh_exports_test
