#include "temporary_mesh.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/nodal_thickness.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

// Thickness of shells from a file: by the profile along the chord, by a table, by the file itself.
namespace birdstrike::nodal_thickness_test
{
  namespace
  {
    GeometryParameters plate()
    {
      GeometryParameters p;
      p.mesh.n_span               = 7;
      p.mesh.n_chord              = 5;
      p.mesh.span_grading         = 2.;
      p.thickness.maximum         = "0.006 - 0.002*s^2";
      p.thickness.leading_edge    = "0.3";
      p.thickness.trailing_edge   = "0.4 + 0.1*s";
      p.thickness.maximum_station = 0.35;
      return p;
    }

    /// The fan blade of prm/fan-blade.prm: it turns by 50 degrees, its chord grows by a third.
    GeometryParameters fan_blade()
    {
      GeometryParameters p     = plate();
      p.mesh.generator         = MeshGenerator::blade;
      p.mesh.length            = 0.45;
      p.mesh.chord             = 0.15;
      p.mesh.n_span            = 22;
      p.mesh.n_chord           = 9;
      p.mesh.profile.chord     = "1 + s/3";
      p.mesh.profile.stagger   = "12 + 75*s - 25*s^2";
      p.mesh.profile.camber    = "0.10 - 0.15*s + 0.06*s^2";
      p.thickness.maximum      = "0.013 - 0.0085*s";
      p.thickness.leading_edge = p.thickness.trailing_edge = "0.25";
      p.thickness.maximum_station                          = 0.5;
      return p;
    }

    /// A built-in part as a file for LS-DYNA, with root and tip as node sets 1 and 2. `corners`: a thickness card of
    /// each element.
    std::string written(const ShellMesh &mesh, const std::string &corners = "")
    {
      std::ostringstream out;
      out.precision(17);
      out << "*KEYWORD\n*NODE\n";
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        out << 10 * n + 7 << ',' << mesh.nodes[n][0] << ',' << mesh.nodes[n][1] << ',' << mesh.nodes[n][2] << '\n';
      out << (corners.empty() ? "*ELEMENT_SHELL\n" : "*ELEMENT_SHELL_THICKNESS\n");
      for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        {
          out << cell + 1 << ",4";
          for (const auto n : mesh.cells[cell])
            out << ',' << 10 * n + 7;
          out << '\n' << corners;
        }
      for (const unsigned int id : {0u, 1u})
        {
          out << "*SET_NODE_LIST\n" << id + 1 << '\n';
          for (const auto n : mesh.nodes_on({id}))
            out << 10 * n + 7 << '\n';
        }
      return out.str();
    }

    std::vector<double> thickness_of(const GeometryParameters &p, const std::vector<unsigned int> &root = {1},
                                     const std::vector<unsigned int> &tip = {2})
    {
      const ShellMesh mesh(p);
      return mesh
        .compute_mass(4430., make_thickness_law(p, mesh.material_names), find_nodal_thickness(p, mesh, root, tip))
        .element_thickness;
    }

    GeometryParameters from_file(GeometryParameters p, const test::TemporaryMesh &file)
    {
      p.mesh = file.parameters();
      return p;
    }

    double largest_difference(const std::vector<double> &a, const std::vector<double> &b)
    {
      double largest = 0.;
      EXPECT_EQ(a.size(), b.size());
      for (std::size_t e = 0; e < a.size(); ++e)
        largest = std::max(largest, std::abs(a[e] / b[e] - 1.));
      return largest;
    }

    std::string complaint(const GeometryParameters &p, const std::vector<unsigned int> &tip = {2})
    {
      try
        {
          thickness_of(p, {1}, tip);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }
  } // namespace

  // s and c of a rectangle are its own coordinates, and linear in an element: round-off remains.
  TEST(NodalThickness, ProfileOnAFlatPlateFromAFileIsThatOfTheGenerator)
  {
    const test::TemporaryMesh file(".k", written(ShellMesh(plate())));
    EXPECT_LT(largest_difference(thickness_of(from_file(plate(), file)), thickness_of(plate())), 1e-12);
  }

  // The generator's s is the share of the radius, that of a file a share of distances, and a bilinear element takes s
  // and c between its nodes where the generator projects each point.
  TEST(NodalThickness, ProfileOnAFanBladeFromAFileIsThatOfTheGeneratorWithinTheMeaningOfS)
  {
    const test::TemporaryMesh file(".k", written(ShellMesh(fan_blade())));
    const double difference = largest_difference(thickness_of(from_file(fan_blade(), file)), thickness_of(fan_blade()));
    EXPECT_LT(difference, 0.004);
  }

  TEST(NodalThickness, ProfileWantsRootTipAndTwoEdges)
  {
    const test::TemporaryMesh file(".k", written(ShellMesh(plate())));
    EXPECT_NE(complaint(from_file(plate(), file), {}).find("the blade has no tip"), std::string::npos);
    GeometryParameters closed = from_file(plate(), file);
    EXPECT_NE(complaint(closed, {2, 0}).find("Thickness/Maximum"), std::string::npos) << "no free edges";
  }

  TEST(NodalThickness, TableGivesEveryNodeItsThickness)
  {
    GeometryParameters p = plate();
    p.thickness          = {};
    const ShellMesh mesh(p);
    std::string     by_place = "# x y z thickness\n", by_id;
    for (std::size_t n = mesh.nodes.size(); n-- > 0;) // in any order
      {
        const auto       &x = mesh.nodes[n];
        const std::string t = std::to_string(0.004 + 0.01 * x[0]);
        by_place += std::to_string(x[0]) + ", " + std::to_string(x[1]) + " " + std::to_string(x[2]) + "\t" + t + "\n";
        by_id += std::to_string(10 * n + 7) + " " + t + " # node\n";
      }
    std::vector<double> expected;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      expected.push_back(0.004 + 0.01 * mesh.centroid(cell)[0]);
    const test::TemporaryMesh file("-table.k", written(mesh)), places("-places.txt", by_place), ids("-ids.txt", by_id);
    GeometryParameters        of_file = from_file(p, file);
    for (const auto &[where, table] : {std::pair{&p, &places}, {&of_file, &places}, {&of_file, &ids}})
      {
        where->thickness.table = table->path;
        EXPECT_LT(largest_difference(thickness_of(*where), expected), 2e-4) << "six digits, on 4 mm";
      }
    p.thickness.table = ids.path;
    EXPECT_NE(complaint(p).find("given by its id, but this mesh has none"), std::string::npos);
    const test::TemporaryMesh short_one("-short.txt", by_id.substr(0, by_id.rfind("7 ")));
    of_file.thickness.table = short_one.path;
    EXPECT_NE(complaint(of_file).find("no row for the node 7 at (0, -0.04445, 0) m"), std::string::npos)
      << complaint(of_file);
    const test::TemporaryMesh bad("-bad.txt", "7 0.0\n");
    of_file.thickness.table = bad.path;
    EXPECT_NE(complaint(of_file).find("line 1: the thickness is 0.0 m"), std::string::npos);
  }

  TEST(NodalThickness, TablesOfSpreadsheetsAreRead)
  {
    GeometryParameters p = plate();
    p.thickness          = {};
    const ShellMesh mesh(p);
    std::string     rows;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      rows += std::to_string(10 * n + 7) + ";0.005\r\n";
    const test::TemporaryMesh file("-table.k", written(mesh));
    GeometryParameters        of_file = from_file(p, file);
    const auto                answer  = [&](const std::string &text) {
      const test::TemporaryMesh table("-sheet.csv", text);
      of_file.thickness.table = table.path;
      return complaint(of_file);
    };
    std::string utf16 = "\xFF\xFE";
    for (const char letter : rows)
      utf16 += {letter, '\0'};
    const test::TemporaryMesh table("-sheet.csv", "sep=;\r\nNode;Thickness [m]\r\n" + rows);
    of_file.thickness.table = table.path;
    EXPECT_LT(largest_difference(thickness_of(of_file), std::vector<double>(mesh.cells.size(), 0.005)), 1e-15);
    const test::TemporaryMesh wide("-wide.csv", utf16);
    of_file.thickness.table = wide.path;
    EXPECT_LT(largest_difference(thickness_of(of_file), std::vector<double>(mesh.cells.size(), 0.005)), 1e-15);
    EXPECT_NE(answer("node;thickness [mm]\n" + rows).find("line 1: there are 3 numbers"), std::string::npos)
      << "no metres";
    EXPECT_NE(answer(rows + "17;0.006\n").find("has a second thickness, 0.006 m"), std::string::npos);
    EXPECT_NE(answer(std::string("PK\x03\x04\0\0", 6)).find("save the sheet"), std::string::npos);
  }

  // LS-DYNA's *ELEMENT_SHELL_THICKNESS goes before Value, not before what is asked for by name; zeros leave it to
  // Value.
  TEST(NodalThickness, AFileMayGiveItAtTheCornersOfElements)
  {
    GeometryParameters p = plate();
    p.thickness          = {};
    const ShellMesh           mesh(p);
    const test::TemporaryMesh given("-given.k", written(mesh, "0.001,0.002,0.004,0.003\n")),
      zero("-zero.k", written(mesh, "0.,0.,0.,0.,45.\n")), some("-some.k", written(mesh, "0.,0.,0.,0.002\n"));
    p = from_file(p, given);
    for (const double t : thickness_of(p))
      EXPECT_NEAR(t, 0.0025, 1e-15) << "rectangles";
    p.mesh.file_scale = 2.;
    for (const double t : thickness_of(p))
      EXPECT_NEAR(t, 0.005, 1e-15) << "in units of the file";
    p.thickness.by_material = "part_4: 0.007";
    EXPECT_NEAR(thickness_of(p)[3], 0.007, 1e-15);
    for (const double t : thickness_of(from_file(GeometryParameters(), zero)))
      EXPECT_NEAR(t, 0.00427, 1e-15);
    EXPECT_NE(complaint(from_file(p, some)).find("element 1 has a thickness at some corners only"), std::string::npos);
  }
} // namespace birdstrike::nodal_thickness_test
