#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>

#include <gtest/gtest.h>

#include "temporary_mesh.h"

// What a mesh file holds, whatever its ending says, and how its letters and lines are written.
namespace birdstrike::mesh_content_test
{
  namespace
  {
    std::size_t read(const std::string &ending, const std::string &text)
    {
      const test::TemporaryMesh file(ending, text);
      GeometryParameters        p;
      p.mesh = file.parameters();
      return BladeMesh<2>(p).cells.size();
    }

    std::string refusal(const std::string &ending, const std::string &text)
    {
      try
        {
          read(ending, text);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    const std::string ls_dyna =
      "$ of a program\n*KEYWORD\n*NODE\n1,0.,0.,0.\n2,.1,0.,0.\n3,.1,.1,0.\n4,0.,.1,0.\n*ELEMENT_SHELL\n"
      "1,1,1,2,3,4\n*SET_NODE_LIST\n1\n1,4\n*END\n";
    const std::string abaqus = "*Heading\n** of a program\n*Node\n1,0.,0.,0.\n2,.1,0.,0.\n3,.1,.1,0.\n4,0.,.1,0.\n"
                               "*Element, type=S4R\n1,1,2,3,4\n";
    const std::string gmsh =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 0.1 0 0\n3 0.1 0.1 0\n4 0 0.1 0\n"
      "$EndNodes\n$Elements\n1\n1 3 2 1 1 1 2 3 4\n$EndElements\n";
    const std::string vtk =
      "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0\n0.1 0 0\n"
      "0.1 0.1 0\n0 0.1 0\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n9\n";
    const std::string ucd = "# of a program\n4 1 0 0 0\n1 0 0 0\n2 0.1 0 0\n3 0.1 0.1 0\n4 0 0.1 0\n1 1 quad 1 2 3 4\n";

    struct Sample
    {
      std::string name, ending, text;
    };
    const std::vector<Sample> samples{{"LS-DYNA", ".k", ls_dyna},
                                      {"Abaqus", ".inp", abaqus},
                                      {"Gmsh", ".msh", gmsh},
                                      {"VTK", ".vtk", vtk},
                                      {"UCD", ".inp", ucd}};

    std::string utf16(const std::string &text, const std::string &mark)
    {
      std::string bytes = mark;
      for (const char letter : text)
        bytes += {letter, '\0'};
      return bytes;
    }

    std::string with_line_ends(std::string text, const std::string &end)
    {
      for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size())
        text.replace(at, 1, end);
      return text;
    }
  } // namespace

  TEST(MeshContent, EachEncodingAndEndOfLineIsRead)
  {
    for (const Sample &sample : samples)
      for (const auto &[what, text] :
           {std::pair("UTF-16", utf16(sample.text, "\xFF\xFE")),
            std::pair("UTF-16 without a mark", utf16(sample.text, "")),
            std::pair("UTF-8 with its mark", "\xEF\xBB\xBF" + sample.text),
            std::pair("CR", with_line_ends(sample.text, "\r")), std::pair("CR LF", with_line_ends(sample.text, "\r\n")),
            std::pair("UTF-16, CR LF", utf16(with_line_ends(sample.text, "\r\n"), "\xFF\xFE")),
            std::pair("Ctrl-Z", sample.text + "\x1A")})
        EXPECT_EQ(refusal(sample.ending, text), "") << sample.name << ", " << what;
  }

  TEST(MeshContent, OfAnotherFormatThanTheEndingIsToldSo)
  {
    for (const Sample &sample : samples)
      for (const std::string ending : {".msh", ".k", ".key", ".dyn", ".inp", ".vtk", ".txt", ".mesh"})
        if (const std::string said = refusal(ending, sample.text);
            ending == sample.ending || (sample.ending == ".k" && (ending == ".key" || ending == ".dyn")))
          EXPECT_EQ(said, "") << sample.name << " as " << ending;
        else
          {
            EXPECT_NE(said.find(sample.name), std::string::npos) << sample.name << " as " << ending << ": " << said;
            EXPECT_NE(said.find("Rename the file"), std::string::npos) << said;
            EXPECT_NE(said.find(sample.ending), std::string::npos) << said;
          }
  }

  TEST(MeshContent, OfAFormatThatIsNotOfferedIsNamed)
  {
    const std::vector<std::array<std::string, 3>> others{
      {"<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\">\n", "XML", "legacy"},
      {"    -1\n  2411\n         1\n", "UNV", "gmsh FILE"},
      {"/COM, ANSYS\n/PREP7\nNBLOCK,6,SOLID\n", "ANSYS", "Abaqus"},
      {"SOL 101\nCEND\nBEGIN BULK\nGRID,1,,0.,0.,0.\n", "Nastran", "gmsh FILE"},
      {"$NOD\n4\n1 0 0 0\n", "format 1", "gmsh FILE"},
      {"solid blade\n facet normal 0 0 1\n", "STL", "quadrilaterals"},
      {"ISO-10303-21;\nHEADER;\n", "STEP", "Mesh it"},
      {"(0 \"Fluent\")\n(2 3)\n", "Fluent", "text"},
      {"MeshVersionFormatted 2\nDimension 3\n", "Medit", "gmsh FILE"},
      {"Point(1) = {0, 0, 0};\n", ".geo", "-format msh2"},
      {std::string("\x89HDF\r\n\x1A\n\0\0", 10), "HDF5", "save it as text"},
      {std::string("\x1F\x8B\x08\0\0", 5), "gzip", "gunzip"},
      {std::string("PK\x03\x04\0\0", 6), "zip", "unpack"},
      {std::string("CDF\x01\0\0", 6), "netCDF", "text"}};
    for (const auto &[text, name, action] : others)
      for (const char *ending : {".msh", ".inp", ".k", ".vtk"})
        {
          const std::string said = refusal(ending, text);
          EXPECT_NE(said.find(name), std::string::npos) << said;
          EXPECT_NE(said.find(action), std::string::npos) << said;
        }
  }

  // Keywords alone tell neither: the ending does.
  TEST(MeshContent, KeywordsThatBothHaveGoByTheEnding)
  {
    std::string nodes = "*NODE\n1,0.,0.,0.\n2,.1,0.,0.\n3,.1,.1,0.\n4,0.,.1,0.\n";
    for (int k = 5; k < 600; ++k)
      nodes += std::to_string(k) + ",9.,9.,9.\n";
    EXPECT_EQ(refusal(".k", nodes + "*ELEMENT_SHELL\n1,1,1,2,3,4\n"), "");
    EXPECT_EQ(refusal(".inp", nodes + "*ELEMENT, TYPE=S4\n1,1,2,3,4\n"), "");
  }
} // namespace birdstrike::mesh_content_test
