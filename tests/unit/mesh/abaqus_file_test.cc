#include "temporary_mesh.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>

#include <gtest/gtest.h>

// Expectations are those of the Abaqus Keywords Reference Guide.
namespace birdstrike::abaqus_file_test
{
  namespace
  {
    using Ids = std::vector<unsigned int>;

    /// Three squares in a row along x, nodes 1 2 3 4 at y = 0 and 11 12 13 14 at y = 1, and a node that nothing has.
    const std::string nodes =
      "** a strip\n*Heading\n strip\n*Node, nset=all\n1, 0., 0.\n2, 1., 0., 0.\n  3, 2., 0., 0.\n"
      "4, 3., 0., 0.\n11, 0., 1., 0.\n12, 1., 1.,\n13, 2.0E0, 1.d0, 0.\n14, 3., 1., 0.\n99, 7, 7, 7\n";
    const std::string squares =
      "*ELEMENT, TYPE=S4R,\n  ELSET=strip\n1, 1, 2, 12, 11\n2, 2, 3,\n 13, 12\n7, 3, 4, 14, 13\n";

    template <int dim>
    BladeMesh<dim> read(const std::string &text)
    {
      return BladeMesh<dim>({test::TemporaryMesh(".inp", text).parameters()});
    }

    std::string complaint(const std::string &text)
    {
      try
        {
          read<2>(text);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    /// Nodes on a named boundary, by their x and y as one number 10 x + y.
    template <int dim>
    std::vector<int> places(const BladeMesh<dim> &mesh, const std::string &name)
    {
      std::vector<int> result;
      for (const std::uint32_t n : mesh.nodes_on(mesh.boundary_names.parse(name, "Clamped")))
        result.push_back(static_cast<int>(10. * mesh.nodes[n][0] + mesh.nodes[n][1]));
      std::sort(result.begin(), result.end());
      return result;
    }

    /// Cells of a named material, by their place in the file.
    std::vector<int> cells(const ShellMesh &mesh, const std::string &name)
    {
      std::vector<int> result;
      const auto       ids = mesh.material_names.parse(name, "Material ids");
      for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        if (std::find(ids.begin(), ids.end(), mesh.material_ids[cell]) != ids.end())
          result.push_back(static_cast<int>(cell));
      return result;
    }
  } // namespace

  TEST(AbaqusFile, SetsOfNodesAndElementsHaveNames)
  {
    const ShellMesh mesh =
      read<2>(nodes + squares +
              "*NSET, NSET=Root\n1, 11\n*nset, nset=lower, generate\n1, 4, 1\n"
              "*NSET, NSET=both\nroot, lower\n*NSET, NSET=corner\n1\n*NSET, NSET=of_last, ELSET=last\n"
              "*ELSET, ELSET=last\n7\n*ELSET, ELSET=\"the first two\", GENERATE\n1, 2\n"
              "*ELSET, ELSET=everything\nlast, the first two\n*MATERIAL, NAME=steel\n*DENSITY\n7800.\n");
    EXPECT_EQ(mesh.nodes.size(), 8u) << "a node without cells is left out";
    EXPECT_EQ(mesh.cells.size(), 3u);
    EXPECT_EQ(places(mesh, "root"), (std::vector<int>{0, 1}));
    EXPECT_EQ(places(mesh, "LOWER"), (std::vector<int>{0, 10, 20, 30}));
    EXPECT_EQ(places(mesh, "both"), (std::vector<int>{0, 1, 10, 20, 30}));
    EXPECT_EQ(places(mesh, "all").size(), 8u);
    EXPECT_EQ(cells(mesh, "strip"), (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(cells(mesh, "last"), (std::vector<int>{2}));
    EXPECT_EQ(cells(mesh, "the_first_two"), (std::vector<int>{0, 1}));
    EXPECT_EQ(cells(mesh, "last the_first_two"), cells(mesh, "everything"));
    EXPECT_THROW(places(mesh, "corner"), InputError) << "one node is no side";
    EXPECT_THROW(mesh.boundary_names.parse("strip", "Clamped"), InputError) << "elements are no boundary";
  }

  TEST(AbaqusFile, SetsMayStandBeforeTheirElements)
  {
    const ShellMesh mesh = read<2>("*ELSET, ELSET=first\n1, 99\n*ELSET, ELSET=two\nfirst, 2\n"
                                   "*NSET, NSET=of_two, ELSET=two\n" +
                                   nodes + squares);
    EXPECT_EQ(cells(mesh, "first"), (std::vector<int>{0}));
    EXPECT_EQ(cells(mesh, "two"), (std::vector<int>{0, 1}));
    EXPECT_EQ(places(mesh, "of_two"), (std::vector<int>{0, 1, 10, 11, 20, 21}));
  }

  TEST(AbaqusFile, SurfacesAreSidesOfElements)
  {
    const ShellMesh mesh = read<2>(nodes + squares +
                                   "*SURFACE, NAME=root\n1, E4\n*SURFACE, NAME=upper\nstrip, E3\n"
                                   "*SURFACE, NAME=faces\nstrip, SPOS\n");
    EXPECT_EQ(places(mesh, "root"), (std::vector<int>{0, 1}));
    EXPECT_EQ(places(mesh, "upper"), (std::vector<int>{1, 11, 21, 31}));
    EXPECT_THROW(mesh.boundary_names.parse("faces", "Clamped"), InputError) << "a shell's face is no side";

    // S1 1-2-3-4, S2 5-8-7-6, S3 1-5-6-2, S4 2-6-7-3, S5 3-7-8-4, S6 4-8-5-1
    std::string brick = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n"
                        "8, 0, 1, 1\n*ELEMENT, TYPE=C3D8I, ELSET=body\n1, 1, 2, 3, 4, 5, 6, 7,\n8\n";
    for (const char side : {'1', '2', '3', '4', '5', '6'})
      brick += std::string("*SURFACE, NAME=face") + side + "\nbody, S" + side + '\n';
    const SolidMesh              solid       = read<3>(brick);
    const std::pair<int, double> expected[6] = {{2, 0.}, {2, 1.}, {1, 0.}, {0, 1.}, {1, 1.}, {0, 0.}};
    for (unsigned int s = 0; s < 6; ++s)
      {
        const auto on = solid.nodes_on(solid.boundary_names.parse("face" + std::to_string(s + 1), "Clamped"));
        EXPECT_EQ(on.size(), 4u);
        for (const auto n : on)
          EXPECT_EQ(solid.nodes[n][expected[s].first], expected[s].second) << "S" << s + 1;
      }
  }

  // As Abaqus/CAE writes it: one part, one instance where the part is, sets in the assembly, a reference point of its
  // own.
  TEST(AbaqusFile, ReadsOneInstance)
  {
    const std::string part     = "*Part, name=Part-1\n" + nodes + squares + "*End Part\n*Assembly, name=Assembly\n";
    const std::string rest     = "*End Instance\n*Node\n1, 50., 0., 0.\n*Nset, nset=point\n1,\n"
                                 "*Nset, nset=root, instance=Part-1-1\n1, 11\n*Nset, nset=tip\nPart-1-1.4, Part-1-1.14\n"
                                 "*End Assembly\n";
    const std::string instance = "*Instance, name=Part-1-1, part=Part-1\n";
    const ShellMesh   mesh     = read<2>(part + instance + rest);
    EXPECT_EQ(places(mesh, "root"), (std::vector<int>{0, 1}));
    EXPECT_EQ(places(mesh, "tip"), (std::vector<int>{30, 31}));
    EXPECT_EQ(mesh.nodes.size(), 8u);
    EXPECT_NE(complaint(part + instance + "0., 0., 2.\n" + rest).find("*INSTANCE is moved or turned"),
              std::string::npos);
    EXPECT_NE(complaint(part + instance + "*End Instance\n" + instance + rest).find("second *INSTANCE"),
              std::string::npos);
  }

  TEST(AbaqusFile, RefusesInWords)
  {
    for (const auto &[text, words] :
         {std::pair<std::string, std::string>{nodes + "*ELEMENT, TYPE=S3\n1, 1, 2, 12\n",
                                              "line 14: elements of the type S3"},
          {nodes + "*ELEMENT, TYPE=C3D20R\n1, 1, 2, 3, 4, 11, 12, 13, 14, 1, 2, 3, 4, 11, 12, 13,\n14, 1, 2, 3, 4\n",
           "type C3D20R"},
          {nodes + squares + "*INCLUDE, INPUT=rest.inp\n", "*INCLUDE is not offered"},
          {nodes + "*NGEN\n1, 4, 1\n" + squares, "*NGEN is not offered"},
          {"*NODE, SYSTEM=C\n" + squares, "SYSTEM=C"},
          {nodes + "*ELEMENT, TYPE=S4\n1, 1, 2, 12, 77\n", "element 1 has the node 77"},
          {nodes + squares + "*ELEMENT, TYPE=S4\n7, 1, 2, 12, 11\n", "element 7 is given twice"},
          {nodes + "4, 0, 0, 0\n" + squares, "node 4 is given twice"},
          {nodes + "*ELEMENT, TYPE=S4\n1, 1, 2, 12\n", "has 3 nodes"},
          {nodes + "x, 1, 2\n" + squares, "line 14: cannot read 'x'"},
          {nodes + squares + "*NSET, NSET=a\nb\n", "the set 'b' has not been defined before"},
          {nodes + "*ELEMENT, TYPE=S4\n1, 1, 2, 12, 12\n", "element 1 has the node 12 more than once"}})
      EXPECT_NE(complaint(text).find(words), std::string::npos) << words << "\n" << complaint(text);
  }

  // deal.II 9.4 never came back from ordering the quadrilaterals of such a surface where the second of three elements
  // on an edge began with it.
  TEST(AbaqusFile, RefusesASurfaceThatBranches)
  {
    const std::string        more = "21, 1., 0., 1.\n22, 1., 1., 1.\n*ELEMENT, TYPE=S4\n";
    std::vector<std::string> cells{"1, 1, 2, 12, 11\n", "3, 2, 12, 22, 21\n", "5, 2, 3, 13, 12\n"};
    EXPECT_EQ(complaint(nodes + more + cells[0] + cells[2]), "");
    do
      {
        const std::string text = complaint(nodes + more + cells[0] + cells[1] + cells[2]);
        EXPECT_NE(text.find("elements 1, 3 and 5 share an edge, between the nodes 2 and 12"), std::string::npos)
          << text;
      }
    while (std::next_permutation(cells.begin(), cells.end()));
    EXPECT_NE(complaint(nodes + squares + "8, 2, 12, 13, 3\n").find("elements 2 and 8 have the same nodes"),
              std::string::npos);
  }
} // namespace birdstrike::abaqus_file_test
