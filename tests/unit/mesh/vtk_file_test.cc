#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>

#include "temporary_mesh.h"

namespace birdstrike::vtk_file_test
{
  namespace
  {
    BladeMesh<2> read(const MeshParameters &mesh)
    {
      GeometryParameters p;
      p.mesh = mesh;
      return BladeMesh<2>(p);
    }

    BladeMesh<2> read_data(const std::string &name)
    {
      MeshParameters p;
      p.generator = MeshGenerator::file;
      p.file      = std::string(BIRDSTRIKE_SOURCE_DIR) + "/tests/data/vtk/" + name;
      return read(p);
    }

    const std::string grid = "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
                             "0 0 0\n0.3 0 0\n0.3 0.1 0\n0 0.1 0\nCELLS 2 8\n4 0 1 2 3\n2 0 3\nCELL_TYPES 2\n9\n3\n";

    BladeMesh<2> read_grid(const std::string &attributes)
    {
      const test::TemporaryMesh file(".vtk", grid + attributes);
      return read(file.parameters());
    }

    std::string refusal(const std::string &attributes)
    {
      try
        {
          read_grid(attributes);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    std::size_t n_nodes(const BladeMesh<2> &mesh, const std::string &boundary)
    {
      return mesh.nodes_on(mesh.boundary_names.parse(boundary, "Blade/Supports/Clamped")).size();
    }
  } // namespace

  // What VTK itself writes of all kinds of attributes: only MaterialID is wanted, 11 at x = 0, 12 at x = 0.2.
  TEST(VtkFile, AttributesThatNobodyWantsArePassedOver)
  {
    for (const char *file : {"attributes-5.1.vtk", "attributes-4.2.vtk", "colors-5.1.vtk", "lookup-table-5.1.vtk"})
      {
        const auto mesh = read_data(file);
        EXPECT_EQ(mesh.cells.size(), 6u) << file;
        for (const auto &[name, x] : {std::pair("11", 0.), std::pair("12", 0.2)})
          {
            const auto on = mesh.nodes_on(mesh.boundary_names.parse(name, ""));
            EXPECT_EQ(on.size(), 3u) << file;
            for (const auto node : on)
              EXPECT_EQ(mesh.nodes[node][0], x) << file;
          }
        EXPECT_EQ(std::count(mesh.material_ids.begin(), mesh.material_ids.end(), 2u), 2) << file;
      }
  }

  TEST(VtkFile, KindsOfOtherProgramsArePassedOver)
  {
    const std::string wanted = "SCALARS MaterialID int 1\nLOOKUP_TABLE default\n1 11\n";
    for (const std::string other :
         {"SCALARS t float\n0.5 nan\n", "SCALARS t float 2\nLOOKUP_TABLE default\n0.5 1 2 3\n",
          "scalars t Double\n1e300 -1\n", "TENSORS6 s double\n1 2 3 4 5 6 1 2 3 4 5 6\n",
          "EDGE_FLAGS e unsigned_char\n0 1\n", "LOOKUP_TABLE mine 2\n0 0 0 1\n1 1 1 1\n",
          "COLOR_SCALARS c 1\n0.5 0.25\n", "TEXTURE_COORDINATES u 1 float\n0.5 1\n",
          "GLOBAL_IDS g vtkIdType\n9000000000000000000 2\n", "PEDIGREE_IDS p string\n\nname\n",
          "FIELD f 2\nnames 1 2 string\n\nMETADATA\nMETADATA\nINFORMATION 0\n\nhuge 2 2 long\n1 2 9e300 4\n",
          "FIELD f 1\nempty 1 0 int\n",
          "METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n\n"})
      for (const std::string &text : {"CELL_DATA 2\n" + other + wanted, "CELL_DATA 2\n" + wanted + other})
        {
          ASSERT_EQ(refusal(text), "") << text;
          EXPECT_EQ(n_nodes(read_grid(text), "11"), 2u) << text;
        }
  }

  TEST(VtkFile, NumbersOfGroupsMustBeWhole)
  {
    EXPECT_EQ(n_nodes(read_grid("CELL_DATA 2\nSCALARS MaterialID float\nLOOKUP_TABLE default\n1.0 1.1e1\n"), "11"), 2u);
    EXPECT_NE(refusal("CELL_DATA 2\nSCALARS MaterialID float\nLOOKUP_TABLE default\n1 11.5\n").find("line 19: '11.5'"),
              std::string::npos);
    EXPECT_NE(refusal("CELL_DATA 2\nFIELD f 1\nMaterialID 2 2 int\n1 2 3 4\n").find("line 18: the array 'MaterialID'"),
              std::string::npos);
    EXPECT_NE(refusal("CELL_DATA 3\nSCALARS MaterialID int\n1 2 3\n").find("CELL_DATA is of 3, but there are 2 cells"),
              std::string::npos);
  }

  // -1 is deal.II's mark of what has no number; Gmsh's are groups that run against their entity.
  TEST(VtkFile, NegativeNumbersAreGroupsOfGmsh)
  {
    EXPECT_EQ(n_nodes(read_grid("CELL_DATA 2\nSCALARS CellEntityIds int 1\nLOOKUP_TABLE default\n5 -11\n"), "11"), 2u);
    EXPECT_EQ(n_nodes(read_grid("CELL_DATA 2\nFIELD f 1\ngmsh:physical 1 2 int\n5 -11\n"), "11"), 2u);
    EXPECT_FALSE(
      read_grid("CELL_DATA 2\nSCALARS MaterialID int 1\nLOOKUP_TABLE default\n5 -1\n").boundary_names.names(1));
  }

  TEST(VtkFile, WordsThatNoKeywordIsAreRefusedAtTheirLine)
  {
    EXPECT_NE(refusal("CELL_DATA 2\nSCALARS t float\nLOOKUP_TABLE default\n1 2 3\n")
                .find("line 19: '3' stands where a keyword"),
              std::string::npos);
    EXPECT_NE(refusal("CELL_DATA 2\nSCALARS t float\nLOOKUP_TABLE default\n1\n").find("ends too early"),
              std::string::npos);
  }

  // VTK's numbering of pixels and voxels: "VTK User's Guide", figure of the linear cell types.
  TEST(VtkFile, PixelsAreQuadrilateralsInAnotherOrder)
  {
    std::string text = grid;
    text.replace(text.find("4 0 1 2 3"), 9, "4 0 1 3 2");
    text.replace(text.find("\n9\n"), 3, "\n8\n");
    const test::TemporaryMesh file(".vtk", text);
    const auto                mesh = read(file.parameters());
    EXPECT_NEAR(mesh.area_vector(0).norm(), 0.03, 1e-12);
  }

  TEST(VtkFile, PointsThatAreNoPlacesAreRefusedAtTheirLine)
  {
    for (const char *bad : {"nan", "inf", "-Infinity", "1e999"})
      {
        std::string text = grid;
        text.replace(text.find("0.3 0.1 0"), 3, bad);
        const test::TemporaryMesh file(".vtk", text);
        try
          {
            read(file.parameters());
            FAIL() << bad;
          }
        catch (const InputError &error)
          {
            EXPECT_NE(std::string(error.what()).find("line 8: cannot read '" + std::string(bad) + "'"),
                      std::string::npos)
              << error.what();
          }
      }
  }
} // namespace birdstrike::vtk_file_test
