#include "temporary_mesh.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>

#include <gtest/gtest.h>

// Expectations are those of the LS-DYNA Keyword User's Manual, Volume I.
namespace birdstrike::ls_dyna_file_test
{
  namespace
  {
    std::string column(const std::string &text, const std::size_t width)
    {
      return std::string(width - text.size(), ' ') + text;
    }

    std::string card(const std::vector<std::string> &fields, const std::size_t width, const std::size_t first = 0)
    {
      std::string text;
      for (std::size_t k = 0; k < fields.size(); ++k)
        text += column(fields[k], k == 0 && first > 0 ? first : width);
      return text + '\n';
    }

    /// Two squares along x of parts 3 and 4, nodes 1 2 3 at y = 0, 11 12 13 at y = 1; a node set of the root, in
    /// columns of a format: the widths of ids, whole and real numbers, and what stands after keywords.
    std::string strip(const std::size_t id, const std::size_t integer, const std::size_t real, const std::string &head,
                      const std::string &mark)
    {
      std::string text = "$ a strip\n*KEYWORD" + head + "\n*TITLE\nstrip\n*node" + mark + "\n$#   nid\n";
      for (const auto &[n, x, y] : {std::array<std::string, 3>{"1", "0.0", "0.0"},
                                    {"2", "1.0", "0"},
                                    {"3", "2.0", "0"},
                                    {"11", "0", "1.0"},
                                    {"12", "1.0E+00", "1."},
                                    {"13", "2.", "1."}})
        text += card({n, x, y, "0.0", "0", "0"}, real, id);
      text += "*ELEMENT_SHELL" + mark + "\n" + card({"1", "3", "1", "2", "12", "11"}, id) +
              card({"2", "4", "2", "3", "13", "12", "0", "0", "0", "0"}, id);
      text += "*PART" + mark + "\n$ title\nblade root\n" + card({"3", "1", "1"}, integer) + "airfoil\n" +
              card({"4", "1", "1"}, integer);
      text += "*SET_NODE_LIST_TITLE" + mark + "\nhub nodes\n" + card({"7", "0.0", "0.0"}, integer) +
              card({"1", "11"}, integer) + "*SET_NODE_LIST" + mark + "\n" + card({"9"}, integer) +
              card({"3", "13"}, integer);
      return text + "*END\nthis is not read\n";
    }

    template <int dim>
    BladeMesh<dim> read(const std::string &text)
    {
      return BladeMesh<dim>({test::TemporaryMesh(".k", text).parameters()});
    }

    template <int dim>
    std::string complaint(const std::string &text)
    {
      try
        {
          read<dim>(text);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    template <int dim>
    void expect_at(const BladeMesh<dim> &mesh, const std::string &name, const double x, const std::size_t n)
    {
      const auto nodes = mesh.nodes_on(mesh.boundary_names.parse(name, "Clamped"));
      EXPECT_EQ(nodes.size(), n) << name;
      for (const auto node : nodes)
        EXPECT_EQ(mesh.nodes[node][0], x) << name;
    }

    const std::string nodes =
      "*KEYWORD\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n";
  } // namespace

  TEST(LsDynaFile, ReadsTheColumnsOfEachFormat)
  {
    for (const std::string &text :
         {strip(8, 10, 16, "", ""), strip(10, 10, 16, " I10=Y", ""), strip(20, 20, 20, " long=y", ""),
          strip(20, 20, 20, " 200m", " +"), strip(10, 10, 16, "", " %"), strip(8, 10, 16, " LONG=Y", " -")})
      {
        const auto mesh = read<2>(text);
        ASSERT_EQ(mesh.cells.size(), 2u) << text;
        EXPECT_EQ(mesh.material_ids, (std::vector<unsigned int>{3, 4}));
        EXPECT_EQ(mesh.material_names.parse("Blade_root", "Material ids"), (std::vector<unsigned int>{3}));
        EXPECT_EQ(mesh.material_names.parse("airfoil", "Material ids"), (std::vector<unsigned int>{4}));
        expect_at(mesh, "hub_nodes", 0., 2);
        expect_at(mesh, "7", 0., 2);
        expect_at(mesh, "node_set_9", 2., 2);
        expect_at(mesh, "9", 2., 2);
      }
  }

  // A brick on one card and on two, by itself inside out; a segment set, a generated node set, sets of solids and
  // parts.
  TEST(LsDynaFile, ReadsBricksAndTheirSets)
  {
    const std::string sets =
      "*SET_SEGMENT_TITLE\nroot\n5,0.,0.\n1,4,8,5\n*SET_NODE_LIST_GENERATE_TITLE\nlower\n2\n1,4\n"
      "*SET_SOLID_TITLE\ncore\n1\n1\n*SET_PART_LIST_TITLE\nwhole\n1\n6\n*SET_NODE_GENERAL\n3\nALL\n";
    for (const std::string element :
         {"*ELEMENT_SOLID\n1,6,1,2,3,4,5,6,7,8\n",
          "*ELEMENT_SOLID (ten nodes format)\n       1       6\n"
          "       1       2       3       4       5       6       7       8       0       0\n",
          "*ELEMENT_SOLID\n1,6,5,6,7,8,1,2,3,4\n", "*ELEMENT_TSHELL\n1,6,1,2,3,4,5,6,7,8\n"})
      {
        const auto mesh = read<3>(nodes + element + sets);
        ASSERT_EQ(mesh.cells.size(), 1u) << element;
        expect_at(mesh, "root", 0., 4);
        EXPECT_EQ(mesh.nodes_on(mesh.boundary_names.parse("lower", "Clamped")).size(), 4u);
        for (const char *name : {"core", "whole", "6", "part_6"})
          EXPECT_EQ(mesh.material_names.parse(name, "Material ids"), (std::vector<unsigned int>{6})) << name;
      }
  }

  TEST(LsDynaFile, RefusesInWords)
  {
    const auto shell = [](const std::string &text) { return complaint<2>(nodes + text); };
    const auto brick = [](const std::string &text) { return complaint<3>(nodes + text); };
    for (const auto &[said, words] :
         {std::pair<std::string, std::string>{shell("*ELEMENT_SHELL\n1,1,1,2,3,3\n"),
                                              "line 12: element 1 is a triangle"},
          {shell("*ELEMENT_SHELL\n1,1,1,2,3\n"), "element 1 is a triangle"},
          {shell("*ELEMENT_SHELL\n1,1,1,2,3,4,5,6,7,8\n"), "of the second order"},
          {shell("*ELEMENT_SHELL_OFFSET\n1,1,1,2,3,4\n0.5\n"), "off the mid-surface"},
          {shell("*ELEMENT_SHELL_COMPOSITE\n"), "elements *ELEMENT_SHELL_COMPOSITE are not offered"},
          {shell("*ELEMENT_SPH\n1,1,1.0\n"), "*ELEMENT_SPH are not offered"},
          {shell("*INCLUDE\nother.k\n"), "*INCLUDE is not offered"},
          {shell("*NODE\n&n,1,2,3\n"), "line 12: the parameter '&n' stands for a number"},
          {brick("*ELEMENT_SOLID\n1,1,1,2,3,4,4,4,4,4\n"), "element 1 is no brick"},
          {brick("*ELEMENT_SOLID\n1,1\n1,2,3,4,5,6,7,8,1,2\n"), "tetrahedron of ten nodes"},
          {brick("*ELEMENT_SHELL\n1,1,1,2,3,4\n"), "holds 1 quadrilaterals"},
          {shell("*PART\nnothing\n1\n"), "is not a mesh of quadrilaterals"}})
      EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
    EXPECT_EQ(shell("*ELEMENT_SHELL_BETA_OFFSET\n1,1,1,2,3,4\n0,0,0,0,45\n0.0\n\n"), "") << "a blank line";
  }
} // namespace birdstrike::ls_dyna_file_test
