#include "temporary_mesh.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>

#include <gtest/gtest.h>

// Blade/Mesh/Parts of formats that have groups by number: two squares of group 3 "blade", one square of group 4, one
// triangle of group 5 that hangs on the latter.
namespace birdstrike::mesh_parts_test
{
  namespace
  {
    const std::string gmsh =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 1 \"root\"\n2 3 \"blade\"\n$EndPhysicalNames\n"
      "$Nodes\n11\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n7 0 0 5\n8 1 0 5\n9 1 1 5\n10 0 1 5\n11 2 0 "
      "5\n"
      "$EndNodes\n$Elements\n5\n1 1 2 1 1 1 4\n2 3 2 3 1 1 2 5 4\n3 3 2 3 1 2 3 6 5\n4 3 2 4 2 7 8 9 10\n"
      "5 2 2 5 3 8 11 9\n$EndElements\n";
    const std::string vtk =
      "# vtk DataFile Version 3.0\nparts\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 11 double\n0 0 0\n1 0 0\n2 0 0\n0 1 "
      "0\n1 1 0\n2 1 0\n0 0 5\n1 0 5\n1 1 5\n0 1 5\n2 0 5\nCELLS 5 22\n2 0 3\n4 0 1 4 3\n4 1 2 5 4\n4 6 7 8 9\n3 7 10 "
      "8\nCELL_TYPES 5\n3 9 9 9 5\nCELL_DATA 5\nSCALARS MaterialID int 1\nLOOKUP_TABLE default\n1 3 3 4 5\n";
    const std::string ucd =
      "11 5 0 0 0\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n7 0 0 5\n8 1 0 5\n9 1 1 5\n10 0 1 5\n11 2 0 "
      "5\n1 1 line 1 4\n2 3 quad 1 2 5 4\n3 3 quad 2 3 6 5\n4 4 quad 7 8 9 10\n5 5 tri 8 11 9\n";

    ShellMesh read(const std::string &ending, const std::string &text, const std::string &parts)
    {
      const test::TemporaryMesh file(ending, text);
      MeshParameters            p = file.parameters();
      p.parts                     = parts;
      return ShellMesh({p});
    }

    std::string complaint(const std::string &ending, const std::string &text, const std::string &parts)
    {
      try
        {
          read(ending, text, parts);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }
  } // namespace

  TEST(MeshParts, PickGroupsOfEachFormat)
  {
    for (const auto &[ending, text] : {std::pair<std::string, std::string>{".msh", gmsh}, {".vtk", vtk}, {".inp", ucd}})
      {
        const auto mesh = read(ending, text, "3");
        EXPECT_EQ(mesh.cells.size(), 2u) << ending;
        EXPECT_EQ(mesh.nodes.size(), 6u) << ending;
        EXPECT_EQ(mesh.nodes_on(mesh.boundary_names.parse("1", "Clamped")).size(), 2u) << ending;
        EXPECT_EQ(read(ending, text, "4").cells.size(), 1u) << ending;
        EXPECT_NE(complaint(ending, text, "4, 5").find("type"), std::string::npos) << ending;
        EXPECT_NE(complaint(ending, text, "").find("Blade/Mesh/Parts"), std::string::npos) << ending;
        EXPECT_NE(complaint(ending, text, "6").find("the mesh has no part '6'"), std::string::npos) << ending;
      }
    EXPECT_EQ(read(".msh", gmsh, "Blade").cells.size(), 2u);
    EXPECT_NE(complaint(".msh", gmsh, "hub").find("Names in this mesh: blade."), std::string::npos);
  }
} // namespace birdstrike::mesh_parts_test
