#include "temporary_mesh.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>

#include <gtest/gtest.h>

// What decks hold beside nodes and elements. Expectations are those of the LS-DYNA Keyword User's Manual, Volume I.
namespace birdstrike::ls_dyna_deck_test
{
  namespace
  {
    /// A strip of three unit squares along x, part 3 "airfoil": nodes 1 2 3 4 at y = 0 and 11 12 13 14 at y = 1.
    const std::string nodes =
      "*KEYWORD\n*NODE\n1,0,0,0\n2,1,0,0\n3,2,0,0\n4,3,0,0\n11,0,1,0\n12,1,1,0\n13,2,1,0\n14,3,1,0\n";
    const std::string part   = "*PART\nairfoil\n3,1,1\n";
    const std::string shells = "*ELEMENT_SHELL\n1,3,1,2,12,11\n2,3,2,3,13,12\n3,3,3,4,14,13\n";
    const std::string strip  = nodes + part + shells;

    template <int dim = 2>
    BladeMesh<dim> read(const std::string &text, const std::string &parts = "")
    {
      const test::TemporaryMesh file(".k", text);
      MeshParameters            p = file.parameters();
      p.parts                     = parts;
      return BladeMesh<dim>({p});
    }

    template <int dim = 2>
    std::string complaint(const std::string &text, const std::string &parts = "")
    {
      try
        {
          read<dim>(text, parts);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    std::string complaint_of(const ShellMesh &mesh, const std::string &boundary)
    {
      try
        {
          mesh.boundary_names.parse(boundary, "Clamped");
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    /// Nodes on a named boundary by the ids of the file.
    std::vector<std::int64_t> ids(const ShellMesh &mesh, const std::string &boundary)
    {
      std::vector<std::int64_t> all;
      for (const std::uint32_t n : mesh.nodes_on(mesh.boundary_names.parse(boundary, "Clamped")))
        all.push_back(mesh.node_label(n));
      std::sort(all.begin(), all.end());
      return all;
    }

    void expect_words(const std::string &said, const std::string &words)
    {
      EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
    }

    using Nodes = std::vector<std::int64_t>;
  } // namespace

  // 3 m^2 of 0.25 m: 750 kg at 1000 kg/m^3, whatever stands behind the four thicknesses.
  TEST(LsDynaDeck, ThicknessStandsOnTheSecondCardOfEachOption)
  {
    for (const std::string option : {"THICKNESS", "BETA", "MCID", "THICKNESS_BETA", "THICKNESS_MCID", "BETA_OFFSET",
                                     "MCID_OFFSET", "THICKNESS_OFFSET", "THICKNESS_BETA_OFFSET"})
      {
        std::string text = nodes + "*ELEMENT_SHELL_" + option + "\n";
        for (const char *const element : {"1,3,1,2,12,11", "2,3,2,3,13,12", "3,3,3,4,14,13"})
          text += std::string(element) + "\n            0.25        2.5E-01          2.50-1            0.25\n" +
                  (option.ends_with("OFFSET") ? "             0.0\n" : "");
        const auto mesh = read(text);
        const auto mass = mesh.compute_mass(DensityLaw(1000.), make_thickness_law({}));
        EXPECT_EQ(mass.n_given, 3u) << option;
        EXPECT_NEAR(mass.total, 750., 1e-9) << option;
      }
    expect_words(complaint(nodes + "*ELEMENT_SHELL_BETA_OFFSET\n1,3,1,2,12,11\n1,1,1,1\n0.01\n"),
                 "off the mid-surface");
    expect_words(complaint(nodes + "*ELEMENT_SHELL_BETA\n1,3,1,2,12,11\n1,1\n"), "a thickness at some corners only");
  }

  TEST(LsDynaDeck, AngleOfPliesIsNoted)
  {
    const auto with = [](const std::string &angle) {
      return read(nodes + "*ELEMENT_SHELL_BETA\n1,3,1,2,12,11\n1,1,1,1," + angle + "\n").file_notes;
    };
    EXPECT_TRUE(with("0").of_plies.empty());
    ASSERT_EQ(with("45").of_plies.size(), 1u);
    expect_words(with("45").of_plies[0], "element 1");
    EXPECT_TRUE(with("45").always.empty());
  }

  TEST(LsDynaDeck, NodeSetsOfEachLayout)
  {
    for (const std::string set :
         {"*SET_NODE_COLUMN_TITLE\nroot\n7\n1,0.5\n11,0.5\n", "*SET_NODE_GENERAL_TITLE\nroot\n7\nNODE,1,11\n",
          "*SET_NODE_LIST_GENERATE_INCREMENT_TITLE\nroot\n7\n1,11,10\n",
          "*SET_NODE_LIST\n1\n1\n*SET_NODE_LIST\n2\n11\n*SET_NODE_ADD_TITLE\nroot\n7\n1,2\n",
          "*SET_NODE_ADD_TITLE\nroot\n7\n1,-2\n*SET_NODE_LIST\n1\n1\n*SET_NODE_LIST\n2\n11\n",
          "*SET_NODE_LIST_COLLECT_TITLE\nroot\n7\n1\n*SET_NODE_LIST_COLLECT_TITLE\nroot\n7\n11\n",
          "*SET_NODE_TITLE\nroot\n7\n1,11\n", "*SET_NODE_LIST_TITLE_COLLECT\nroot\n7\n1,11\n",
          "*SET_NODE_GENERAL_TITLE\nroot\n7\nALL\nDNODE,2,3,4,12,13,14\n",
          "*SET_NODE_GENERAL_TITLE\nroot\n7\nSET_SHELL,5\nDSET_NODE,4\n*SET_SHELL_LIST\n5\n1\n*SET_NODE_LIST\n4\n2,"
          "12\n",
          "*SET_NODE_LIST\n1\n1,2,11\n*SET_NODE_LIST\n2\n1,11,3\n*SET_NODE_INTERSECT_TITLE\nroot\n7\n1,2\n",
          "*SET_NODE_GENERAL_TITLE\nroot\n7\nPART,3\nDNODE,2,3,4\nDNODE,12,13,14\n"})
      {
        const auto mesh = read(strip + set);
        EXPECT_EQ(ids(mesh, "root"), (Nodes{1, 11})) << set;
        EXPECT_EQ(ids(mesh, "7"), (Nodes{1, 11})) << set;
        EXPECT_EQ(ids(mesh, "node_set_7"), (Nodes{1, 11})) << set;
      }
  }

  TEST(LsDynaDeck, ElementAndPartSetsOfEachLayout)
  {
    const std::string two = nodes + "*ELEMENT_SHELL\n1,3,1,2,12,11\n2,3,2,3,13,12\n3,4,3,4,14,13\n";
    for (const std::string set :
         {"*SET_SHELL_COLUMN_TITLE\nx\n1\n1,9\n2,9\n", "*SET_SHELL_GENERAL_TITLE\nx\n1\nPART,3\n",
          "*SET_SHELL_GENERAL_TITLE\nx\n1\nALL\nDELEM,3\n", "*SET_PART_COLUMN_TITLE\nx\n1\n3,0,0\n",
          "*SET_PART_LIST\n1\n3\n*SET_PART_ADD_TITLE\nx\n2\n1\n",
          "*SET_SHELL_LIST\n4\n1\n*SET_SHELL_LIST\n5\n2\n"
          "*SET_SHELL_ADD_TITLE\nx\n1\n4,5\n"})
      {
        const auto mesh = read(two + set);
        const auto of   = mesh.material_names.parse("x", "Material ids");
        for (std::size_t c = 0; c < 3; ++c)
          EXPECT_EQ(std::find(of.begin(), of.end(), mesh.material_ids[c]) != of.end(), c < 2) << set << c;
      }
  }

  TEST(LsDynaDeck, SetsThatAreNotReadSayWhereTheyStand)
  {
    for (const auto &[set, words] :
         {std::pair<std::string, std::string>{"*SET_NODE_GENERAL_TITLE\nroot\n7\nBOX,1\n", "its option BOX"},
          {"*SET_NODE_ADD_ADVANCED_TITLE\nroot\n7\n1,1\n", "Line 18, *SET_NODE_ADD_ADVANCED_TITLE"},
          {"*SET_NODE_ADD_TITLE\nroot\n7\n1,2\n", "node_set_1, which is not there"},
          {"*SET_NODE_LIST_TITLE\nroot\n7\n1\n*SET_NODE_LIST\n7\n11\n", "line 18 already, and no _COLLECT"},
          {"*SET_2D_SEGMENT_TITLE\nroot\n7\n", "*SET_2D_SEGMENT_TITLE"}})
      expect_words(complaint_of(read(strip + set), "root"), words);
    EXPECT_EQ(complaint(strip + "*SET_NODE_GENERAL\n7\nBOX,1\n"), "") << "nobody asks for it";
  }

  TEST(LsDynaDeck, TitlesThatTwoSetsShareAreRefused)
  {
    const std::string other = "*SET_NODE_LIST_TITLE\nroot\n7\n1,11\n*SET_NODE_LIST_TITLE\nroot\n8\n";
    expect_words(complaint_of(read(strip + other + "4,14\n"), "root"),
                 "Give the one that is meant: node_set_7, node_set_8");
    EXPECT_EQ(ids(read(strip + other + "4,14\n"), "node_set_8"), (Nodes{4, 14}));
    EXPECT_EQ(ids(read(strip + other + "11,1\n"), "root"), (Nodes{1, 11})) << "both are the same";
  }

  TEST(LsDynaDeck, PassesOverWhatLeavesTheMeshAsItIs)
  {
    std::string text = strip;
    for (const char *const keyword : {"CONTROL_TERMINATION",
                                      "CONTROL_SPH",
                                      "DATABASE_BINARY_D3PLOT",
                                      "DATABASE_GLSTAT",
                                      "MAT_PIECEWISE_LINEAR_PLASTICITY_TITLE",
                                      "MAT_024",
                                      "EOS_GRUNEISEN",
                                      "SECTION_SHELL_TITLE",
                                      "SECTION_SPH",
                                      "HOURGLASS",
                                      "DEFINE_CURVE_TITLE",
                                      "DEFINE_BOX",
                                      "LOAD_BODY_RX",
                                      "LOAD_NODE_SET",
                                      "BOUNDARY_SPC_SET",
                                      "BOUNDARY_PRESCRIBED_MOTION_RIGID",
                                      "CONTACT_AUTOMATIC_NODES_TO_SURFACE_ID",
                                      "CONTACT_ERODING_NODES_TO_SURFACE",
                                      "INITIAL_VELOCITY_GENERATION",
                                      "DAMPING_GLOBAL",
                                      "DEFORMABLE_TO_RIGID",
                                      "PARAMETER",
                                      "PARAMETER_EXPRESSION",
                                      "RIGIDWALL_PLANAR",
                                      "INTEGRATION_SHELL",
                                      "SENSOR_DEFINE_NODE",
                                      "ALE_MULTI-MATERIAL_GROUP",
                                      "ELEMENT_PLOTEL",
                                      "TERMINATION_NODE",
                                      "CONSTRAINED_GLOBAL",
                                      "CONSTRAINED_LAGRANGE_IN_SOLID",
                                      "FREQUENCY_DOMAIN_FRF",
                                      "SET_DISCRETE_LIST"})
      text += "*" + std::string(keyword) + "\n         1         1       0.5\n";
    const auto mesh = read(text);
    EXPECT_EQ(mesh.cells.size(), 3u);
    EXPECT_TRUE(mesh.file_notes.always.empty()) << mesh.file_notes.always[0];
  }

  TEST(LsDynaDeck, RefusesByNameWhatMovesJoinsThickensOrMakes)
  {
    for (const char *const keyword : {"NODE_TRANSFORM",
                                      "NODE_MERGE",
                                      "NODE_MERGE_SET",
                                      "NODE_MERGE_TOLERANCE",
                                      "NODE_THICKNESS",
                                      "NODE_THICKNESS_SET",
                                      "NODE_TO_TARGET_VECTOR",
                                      "NODE_REFERENCE",
                                      "PERTURBATION_NODE",
                                      "PERTURBATION_SHELL_THICKNESS",
                                      "CONSTRAINED_ADAPTIVITY",
                                      "PART_DUPLICATE",
                                      "PART_STACKED_ELEMENTS",
                                      "INCLUDE",
                                      "INCLUDE_TRANSFORM",
                                      "INCLUDE_STAMPED_PART",
                                      "CASE_BEGIN_1",
                                      "CONTROL_REFINE_SHELL",
                                      "CONTROL_FORMING_AUTOPOSITION_PARAMETER",
                                      "INITIAL_LAG_MAPPING",
                                      "DEFINE_FORMING_BLANKMESH",
                                      "DELETE_PART",
                                      "COMPONENT_GEBOD_MALE",
                                      "IGA_SHELL",
                                      "NOBODY_KNOWS_THIS"})
      expect_words(complaint(strip + "*" + keyword + "\n"),
                   "line 18: the keyword *" + std::string(keyword) + " is not offered");
  }

  TEST(LsDynaDeck, NotesWhatTiesStressesOrCuts)
  {
    for (const char *const keyword : {"CONSTRAINED_NODAL_RIGID_BODY", "CONSTRAINED_EXTRA_NODES_SET",
                                      "CONTACT_TIED_NODES_TO_SURFACE", "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK",
                                      "INITIAL_STRESS_SHELL", "CONSTRAINED_SPOTWELD", "DEFINE_ELEMENT_DEATH_SHELL_SET"})
      {
        const auto notes = read(strip + "*" + keyword + "\n1,2\n*" + keyword + "\n1,3\n").file_notes.always;
        ASSERT_EQ(notes.size(), 1u) << keyword;
        expect_words(notes[0], std::string(keyword) + " in line 18 (2 in all)");
      }
  }

  // As the fan blade of LSTC's example: shells with a title, a rigid hub of bricks, a bird of particles, a disc with a
  // triangle; the blade's root is tied to the hub.
  TEST(LsDynaDeck, PartsPickTheBlade)
  {
    const std::string deck =
      strip +
      "*NODE\n101,0,0,-2\n102,1,0,-2\n103,1,1,-2\n104,0,1,-2\n105,0,0,-1\n106,1,0,-1\n107,1,1,-1\n108,0,1,-1\n"
      "501,9,9,9\n502,9,9,8\n"
      "*PART_INERTIA\nhub\n4,2,2\n0,0,0,1,0\n1,0,0,1,0,1\n0,0,0\ndisc\n6,2,2\n0,0,0,1,0\n1,0,0,1,0,1\n0,0,0\n"
      "*PART\nbird\n5,3,3\n"
      "*ELEMENT_SOLID\n1,4,101,102,103,104,105,106,107,108\n*ELEMENT_SHELL\n9,6,101,102,103,103\n"
      "*ELEMENT_SPH\n     501       5           0.001\n     502       5           0.001\n"
      "*ELEMENT_DISCRETE\n1,7,1,101\n*PART_MOVE\n5,1.0,0,0\n"
      "*CONSTRAINED_EXTRA_NODES_SET\n4,7\n*SET_NODE_LIST_TITLE\nroot\n7\n1,11\n*SET_PART_LIST_TITLE\nelastic\n1\n3\n"
      "*SET_SHELL_LIST_TITLE\nfirst\n1\n1,2\n";
    for (const std::string parts : {"airfoil", "3", "part_3", "elastic", "part_set_1", "AIRFOIL"})
      {
        const auto mesh = read(deck, parts);
        EXPECT_EQ(mesh.cells.size(), 3u) << parts;
        EXPECT_EQ(mesh.nodes.size(), 8u) << parts;
        EXPECT_EQ(ids(mesh, "root"), (Nodes{1, 11})) << parts;
      }
    EXPECT_EQ(read(deck, "first").cells.size(), 2u);
    EXPECT_EQ(read<3>(deck, "hub").cells.size(), 1u);
    expect_words(complaint(deck), "element 9 is a triangle");
    expect_words(complaint(deck), "Blade/Mesh/Parts");
    expect_words(complaint(deck, "airfoil, disc"), "element 9 is a triangle");
    expect_words(complaint(deck, "airfoil bird"), "*ELEMENT_SPH are not offered");
    expect_words(complaint(deck, "hub"), "holds no quadrilaterals, only hexahedra");
    expect_words(complaint(deck, "wing"), "the mesh has no part 'wing'.\nNames in this mesh: airfoil, ");
    expect_words(complaint(deck, "12"), "the mesh has no part '12'");
  }

  TEST(LsDynaDeck, RefusesWhatIsDoneToTheBladeAlone)
  {
    const std::string other =
      "*NODE\n101,0,0,5\n102,1,0,5\n103,1,1,5\n104,0,1,5\n*ELEMENT_SHELL\n9,8,101,102,103,104\n";
    const std::string deck = strip + other;
    for (const auto &[done, words] :
         {std::pair<std::string, std::string>{"*PART_MOVE\n3,1.,0.,0.\n", "*PART_MOVE moves part 3"},
          {"*PART_MOVE\n1,1.,0.,0.,0,1\n*SET_PART_LIST\n1\n3\n", "*PART_MOVE moves part set 1"},
          {"*ELEMENT_MASS\n77,12,0.5\n", "gives a mass to node 12"},
          {"*ELEMENT_INERTIA\n77,12,0\n1,1,1,1,1,1,0.5\n", "gives a mass to node 12"},
          {"*ELEMENT_MASS_PART\n3,0.5\n", "adds a mass"},
          {"*SET_NODE_LIST\n5\n12\n*ELEMENT_MASS_NODE_SET\n77,5,0.5\n", "adds a mass"}})
      expect_words(complaint(deck + done, "airfoil"), words);
    for (const std::string done :
         {"*PART_MOVE\n8,1.,0.,0.\n", "*ELEMENT_MASS\n77,101,0.5\n", "*ELEMENT_MASS_PART\n8,0.5\n",
          "*SET_NODE_LIST\n5\n102\n*ELEMENT_MASS_NODE_SET\n77,5,0.5\n"})
      EXPECT_EQ(complaint(deck + done, "airfoil"), "") << done;
  }

  TEST(LsDynaDeck, NumbersOfFortranAndParameters)
  {
    const std::string odd =
      "*NODE\n21, 1.75-1, 1.5+0, -2.5-1\n22,1,0,0\n23,1,2,0\n24,0,2,0\n*ELEMENT_SHELL\n5,3,21,22,23,24\n";
    const auto mesh = read(odd);
    const auto n    = static_cast<std::size_t>(std::find(mesh.file_node_ids.begin(), mesh.file_node_ids.end(), 21) -
                                            mesh.file_node_ids.begin());
    EXPECT_EQ(mesh.nodes.at(n), (std::array<double, 3>{0.175, 1.5, -0.25}));
    expect_words(complaint(nodes + "*PARAMETER\nRxt,1.0\n*NODE\n21,&xt,0,0\n"),
                 "the parameter '&xt' stands for a number");
    for (const char *const no_number : {"1.7.5", "1-", "--1", "1.5-1-1"})
      expect_words(complaint("*NODE\n21," + std::string(no_number) + ",0,0\n"), "as a number");
  }
} // namespace birdstrike::ls_dyna_deck_test
