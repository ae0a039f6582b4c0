#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>

#include <gtest/gtest.h>

#include <tuple>

#include <algorithm>

#include "temporary_mesh.h"

// The plate and the body of tests/data/gmsh/groups as Gmsh wrote them: 'root', 'tip' and 'rim' overlap, 'root' runs
// against its curve, 'skin' against its surface, which lies in 'all' too. Numbers of nodes are those of 3 x 2 cells.
namespace birdstrike::gmsh_groups_test
{
  namespace
  {
    template <int dim>
    BladeMesh<dim> read(const std::string &name)
    {
      GeometryParameters p;
      p.mesh.generator = MeshGenerator::file;
      p.mesh.file      = std::string(BIRDSTRIKE_SOURCE_DIR) + "/tests/data/gmsh/groups/" + name;
      return BladeMesh<dim>(p);
    }

    BladeMesh<2> read_text(const std::string &text)
    {
      const test::TemporaryMesh file(".msh", text);
      GeometryParameters        p;
      p.mesh = file.parameters();
      return BladeMesh<2>(p);
    }

    template <int dim>
    std::size_t n_nodes(const BladeMesh<dim> &mesh, const std::string &boundary)
    {
      return mesh.nodes_on(mesh.boundary_names.parse(boundary, "Blade/Supports/Clamped")).size();
    }

    template <int dim>
    std::size_t n_cells(const BladeMesh<dim> &mesh, const std::string &material)
    {
      const auto ids = mesh.material_names.parse(material, "Blade/Section 1/Material ids");
      return static_cast<std::size_t>(
        std::count_if(mesh.material_ids.begin(), mesh.material_ids.end(),
                      [&](const auto id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }));
    }

    std::string refusal(const std::string &text)
    {
      try
        {
          read_text(text);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    constexpr const char *nodes =
      "$Nodes\n6\n1 0 0 0\n2 0.1 0 0\n3 0.2 0 0\n4 0 0.1 0\n5 0.1 0.1 0\n6 0.2 0.1 0\n$EndNodes\n";

    std::string of_format_2(const std::string &names, const std::string &elements)
    {
      return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names + nodes + "$Elements\n" +
             std::to_string(std::count(elements.begin(), elements.end(), '\n')) + "\n" + elements + "$EndElements\n";
    }
  } // namespace

  TEST(GmshGroups, OverlapAndRunBackwardsInEachFormat)
  {
    for (const char *file : {"plate.msh", "plate-v40.msh", "plate-v2.msh", "plate-parametric-v2.msh", "plate-parts.msh",
                             "plate-parts-v40.msh", "plate-parts-v2.msh"})
      {
        const auto mesh = read<2>(file);
        EXPECT_EQ(mesh.cells.size(), 6u) << file;
        EXPECT_EQ(mesh.nodes.size(), 12u) << file;
        for (const char *root : {"root", "11"})
          EXPECT_EQ(n_nodes(mesh, root), 3u) << file;
        EXPECT_EQ(n_nodes(mesh, "tip"), 3u) << file;
        EXPECT_EQ(n_nodes(mesh, "rim"), 10u) << file;
        for (const char *whole : {"skin", "all", "21", "22"})
          EXPECT_EQ(n_cells(mesh, whole), 6u) << file << ": " << whole;
        EXPECT_EQ(mesh.boundary_names.list(), "rim, root, tip") << file << ": what parts have between them is no side";
      }
  }

  TEST(GmshGroups, OfABodyOverlapAndRunBackwards)
  {
    for (const char *file : {"body.msh", "body-v2.msh"})
      {
        const auto mesh = read<3>(file);
        EXPECT_EQ(mesh.cells.size(), 6u) << file;
        EXPECT_EQ(n_nodes(mesh, "root"), 6u) << file;
        EXPECT_EQ(n_nodes(mesh, "tip"), 6u) << file;
        EXPECT_EQ(n_cells(mesh, "metal"), 6u) << file;
        EXPECT_EQ(n_cells(mesh, "all"), 6u) << file;
      }
  }

  // Gmsh writes an element's first group alone there, with its sign.
  TEST(GmshGroups, OfVtkKeepTheirNumberWithoutItsSign)
  {
    const auto mesh = read<2>("plate.vtk");
    EXPECT_EQ(n_nodes(mesh, "11"), 3u);
    EXPECT_EQ(n_nodes(mesh, "12"), 3u);
    EXPECT_EQ(n_cells(mesh, "21"), 6u);
  }

  // With Mesh.SaveAll = 1 format 2 has group 0 for all elements: a number is that of an entity then. Curve 1 lies at
  // y = -0.05, curve 4 at the root.
  TEST(GmshGroups, WhereThereIsNoneTheEntityHasItsNumber)
  {
    const auto mesh = read<2>("plate-all-v2.msh");
    EXPECT_EQ(n_nodes(mesh, "1"), 4u);
    EXPECT_EQ(n_nodes(mesh, "4"), 3u);
    EXPECT_EQ(n_cells(mesh, "1"), 6u);
    EXPECT_THROW(n_nodes(mesh, "root"), InputError) << "a group without elements";
    EXPECT_THROW(n_nodes(mesh, "11"), InputError);
  }

  // Curve 4 lies in no group; the number of curve 1 is that of the group of curve 2.
  TEST(GmshGroups, TheNumberOfAGroupIsNoEntity)
  {
    const auto mesh =
      read_text(of_format_2("", "1 1 2 0 4 1 4\n2 1 2 0 1 1 2\n3 1 2 1 2 3 6\n4 3 2 7 1 1 2 5 4\n5 3 2 0 9 2 3 6 5\n"));
    EXPECT_EQ(n_nodes(mesh, "4"), 2u);
    EXPECT_EQ(mesh.nodes[mesh.nodes_on(mesh.boundary_names.parse("1", ""))[0]][0], 0.2);
    EXPECT_EQ(n_cells(mesh, "7"), 1u);
    EXPECT_EQ(n_cells(mesh, "9"), 1u);
  }

  TEST(GmshGroups, CellsTwiceInOneGroupOrOnTwoSurfacesAreRefused)
  {
    const std::string twice = "the elements 2 and 3 have the same nodes";
    EXPECT_NE(refusal(of_format_2("", "1 3 2 7 1 1 2 5 4\n2 3 2 7 1 2 3 6 5\n3 3 2 7 1 2 3 6 5\n")).find(twice),
              std::string::npos);
    EXPECT_NE(refusal(of_format_2("", "1 3 2 7 1 1 2 5 4\n2 3 2 7 1 2 3 6 5\n3 3 2 8 2 5 2 3 6\n")).find(twice),
              std::string::npos);
    EXPECT_EQ(refusal(of_format_2("", "1 3 2 7 1 1 2 5 4\n2 3 2 7 1 2 3 6 5\n3 3 2 8 1 5 2 3 6\n")), "");
  }

  TEST(GmshGroups, APartOfAPartitionedMeshIsRefused)
  {
    try
      {
        read<2>("plate-split-1.msh");
        FAIL();
      }
    catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find("the elements of 1 of 2 partitions"), std::string::npos)
          << error.what();
      }
    EXPECT_NE(refusal(of_format_2("", "1 3 4 7 1 1 2 1 2 5 4\n2 3 4 7 1 1 2 2 3 6 5\n")).find("1 of 2 partitions"),
              std::string::npos);
  }

  TEST(GmshGroups, CellsThatAreNotOfferedAreNamed)
  {
    const std::string wedge = "1 2 5 4 3 6";
    for (const auto &[type, n_nodes, name] :
         {std::tuple("2", 3, "a triangle"), std::tuple("4", 4, "a tetrahedron"), std::tuple("6", 6, "a wedge"),
          std::tuple("10", 6, "of a higher order"), std::tuple("16", 6, "of a higher order")})
      {
        const std::string nodes = wedge.substr(0, static_cast<std::size_t>(2 * n_nodes - 1));
        const std::string said  = refusal(of_format_2("", "1 " + std::string(type) + " 2 7 1 " + nodes + "\n"));
        EXPECT_NE(said.find("line 15"), std::string::npos) << said;
        EXPECT_NE(said.find(name), std::string::npos) << said;
      }
    EXPECT_NE(refusal("$Nodes\n1\n1 0 0 0\n$EndNodes\n").find("'$MeshFormat' is missing"), std::string::npos);
  }
} // namespace birdstrike::gmsh_groups_test
