#include "temporary_mesh.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>

#include <gtest/gtest.h>

// Names, parts and keywords of whole decks. Expectations are those of the Abaqus Keywords Reference Guide.
namespace birdstrike::abaqus_deck_test
{
  namespace
  {
    /// Three squares in a row along x, nodes 1 2 3 4 at y = 0 and 11 12 13 14 at y = 1.
    const std::string nodes = "*Node\n1, 0., 0.\n2, 1., 0.\n3, 2., 0.\n4, 3., 0.\n11, 0., 1.\n12, 1., 1.\n13, 2., 1.\n"
                              "14, 3., 1.\n";
    const std::string squares = "*Element, type=S4R\n1, 1, 2, 12, 11\n2, 2, 3, 13, 12\n7, 3, 4, 14, 13\n";
    const std::string flat    = nodes + squares;

    std::string part(const std::string &name, const std::string &sets = "")
    {
      return "*Part, name=" + name + "\n" + flat + sets + "*End Part\n";
    }
    std::string instance(const std::string &name, const std::string &of, const std::string &placement = "")
    {
      return "*Instance, name=" + name + ", part=" + of + "\n" + placement + "*End Instance\n";
    }

    template <int dim = 2>
    BladeMesh<dim> read(const std::string &text, const std::string &parts = "")
    {
      const test::TemporaryMesh file(".inp", text);
      MeshParameters            p = file.parameters();
      p.parts                     = parts;
      return BladeMesh<dim>({p});
    }

    std::string complaint(const std::string &text, const std::string &parts = "")
    {
      try
        {
          read(text, parts);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    std::string complaint_of(const NamedIds &names, const std::string &name)
    {
      try
        {
          names.parse(name, "Entry");
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    using Nodes = std::vector<std::int64_t>;

    Nodes ids(const ShellMesh &mesh, const std::string &boundary)
    {
      Nodes all;
      for (const std::uint32_t n : mesh.nodes_on(mesh.boundary_names.parse(boundary, "Clamped")))
        all.push_back(mesh.node_label(n));
      std::sort(all.begin(), all.end());
      return all;
    }

    /// Elements of a material by the ids of the file.
    Nodes elements(const ShellMesh &mesh, const std::string &material)
    {
      Nodes      all;
      const auto of = mesh.material_names.parse(material, "Material ids");
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        if (std::find(of.begin(), of.end(), mesh.material_ids[c]) != of.end())
          all.push_back(mesh.element_label(c));
      return all;
    }

    void expect_words(const std::string &said, const std::string &words)
    {
      EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
    }
  } // namespace

  // As Abaqus/CAE numbers the sets of part and assembly alike.
  TEST(AbaqusDeck, SetsOfPartAndAssemblyAreTwo)
  {
    const auto mesh =
      read(part("Blade", "*Nset, nset=Set-1\n1, 2, 3, 4\n*Elset, elset=Set-1\n1\n*Nset, nset=edge\n11, 12, 13, 14\n") +
           "*Assembly, name=Assembly\n" + instance("Blade-1", "Blade") +
           "*Nset, nset=Set-1, instance=Blade-1\n1, 11\n*Elset, elset=Set-1, instance=Blade-1\n2, 7\n"
           "*Nset, nset=Set-2, instance=Blade-1\n4, 14\n*Nset, nset=both\nSet-2, Blade-1.edge\n*End Assembly\n");
    EXPECT_EQ(ids(mesh, "Blade-1.Set-1"), (Nodes{1, 2, 3, 4}));
    EXPECT_EQ(ids(mesh, "blade.set-1"), (Nodes{1, 2, 3, 4}));
    EXPECT_EQ(ids(mesh, "Assembly.Set-1"), (Nodes{1, 11}));
    EXPECT_EQ(ids(mesh, "Set-2"), (Nodes{4, 14})) << "there is one";
    EXPECT_EQ(ids(mesh, "edge"), (Nodes{11, 12, 13, 14})) << "there is one";
    EXPECT_EQ(ids(mesh, "both"), (Nodes{4, 11, 12, 13, 14}));
    expect_words(complaint_of(mesh.boundary_names, "Set-1"),
                 "'Set-1' means several sets of the mesh.\nGive the one that is meant: Assembly.Set-1, Blade-1.Set-1.");
    EXPECT_EQ(elements(mesh, "Blade-1.Set-1"), (Nodes{1}));
    EXPECT_EQ(elements(mesh, "Assembly.Set-1"), (Nodes{2, 7}));
    expect_words(complaint_of(mesh.material_names, "set-1"), "Assembly.Set-1, Blade-1.Set-1");
    EXPECT_EQ(mesh.boundary_names.list(), "Assembly.Set-1, Blade-1.Set-1, Set-2, both, edge");
  }

  TEST(AbaqusDeck, ANodeSetAndASurfaceOfOneNameAreTwo)
  {
    const auto mesh = read(flat + "*Nset, nset=root\n1, 11\n*Surface, name=root\n7, E2\n*Elset, elset=root\n2\n"
                                  "*Nset, nset=tip\n4, 14\n*Surface, name=tip\n7, E2\n");
    EXPECT_EQ(ids(mesh, "nset.root"), (Nodes{1, 11}));
    EXPECT_EQ(ids(mesh, "surface.root"), (Nodes{4, 14}));
    EXPECT_EQ(elements(mesh, "root"), (Nodes{2})) << "no other set holds cells";
    expect_words(complaint_of(mesh.boundary_names, "root"), "Give the one that is meant: nset.root, surface.root.");
    EXPECT_EQ(ids(mesh, "tip"), (Nodes{4, 14})) << "both are the same side";
  }

  TEST(AbaqusDeck, OneNameInTwoBlocksIsOneSet)
  {
    EXPECT_EQ(ids(read(flat + "*Nset, nset=root\n1\n*Nset, nset=ROOT\n11\n"), "root"), (Nodes{1, 11}));
  }

  // A second part with the same ids, as each part of Abaqus/CAE begins with 1.
  TEST(AbaqusDeck, PartsPickAPartAnInstanceOrASet)
  {
    const std::string hub =
      "*Part, name=Hub\n*Node\n1, 0., 0., 5.\n2, 9., 0., 5.\n3, 9., 9., 5.\n*Element, type=S3\n1, 1, 2, 3\n*End Part\n";
    const std::string blade = part("Blade", "*Elset, elset=front\n1, 2\n");
    const std::string rest  = "*Assembly, name=A\n" + instance("Hub-1", "Hub", "0., 0., 3.\n") +
                             instance("Blade-1", "Blade") + "*Nset, nset=root\nBlade-1.1, Blade-1.11\n" +
                             "*Nset, nset=hole, instance=Hub-1\n1, 2\n*Elset, elset=all, instance=Blade-1\n1, 2, 7\n"
                             "*Tie, name=t\nx, y\n*End Assembly\n";
    for (const std::string &deck : {blade + hub + rest, hub + blade + rest})
      {
        for (const std::string parts : {"Blade", "blade-1", "all", "part.Blade"})
          {
            const auto mesh = read(deck, parts);
            EXPECT_EQ(mesh.cells.size(), 3u) << parts;
            EXPECT_EQ(mesh.nodes.size(), 8u) << parts;
            EXPECT_EQ(ids(mesh, "root"), (Nodes{1, 11}));
            EXPECT_EQ(elements(mesh, "front"), (Nodes{1, 2}));
            ASSERT_EQ(mesh.file_notes.always.size(), 1u);
            expect_words(mesh.file_notes.always[0], "*TIE in line");
          }
        EXPECT_EQ(read(deck, "Blade-1.front").cells.size(), 2u);
        expect_words(complaint(deck), "Blade/Mesh/Parts");
        expect_words(complaint(deck, "Hub-1"), "elements of the type S3");
        expect_words(complaint(deck, "Wing"), "the mesh has no part 'Wing'");
      }
    expect_words(complaint(blade + hub + rest), "a second *PART begins here");
    const std::string two = part("Blade") + part("Other") + "*Assembly\n" + instance("B", "Blade") +
                            instance("O", "Other", "0., 0., 1.\n") + "*End Assembly\n";
    EXPECT_EQ(read(two, "B").cells.size(), 3u);
    expect_words(complaint(two, "O"), "the *INSTANCE is moved or turned");
    expect_words(complaint(part("Blade") + part("Other"), "Blade Other"), "several parts of the file");
  }

  TEST(AbaqusDeck, FurtherInstancesOfAPartAreRefusedByName)
  {
    const std::string deck = part("Blade") + "*Assembly, name=A\n" + instance("Blade-1", "Blade") +
                             instance("Blade-2", "Blade", "0., 0., 1.\n") +
                             "*Nset, nset=root, instance=Blade-1\n1, 11\n*Nset, nset=other, instance=Blade-2\n1, 11\n"
                             "*End Assembly\n";
    expect_words(complaint(deck), "a second *INSTANCE begins here");
    EXPECT_EQ(ids(read(deck, "Blade-1"), "root"), (Nodes{1, 11}));
    expect_words(complaint(deck, "Blade-2"), "another *INSTANCE of a part");
  }

  TEST(AbaqusDeck, ElementSetsPickAmongElementsThatAreNotOffered)
  {
    const std::string deck = flat + "*Elset, elset=blade\n1, 2, 7\n*Element, type=MASS, elset=lump\n50, 99\n"
                                    "*Element, type=SPRINGA, elset=ground\n51, 1, 99\n*Element, type=S8R, elset=skin\n"
                                    "60, 1, 2, 3, 4, 11, 12, 13,\n14\n*Element, type=S3, elset=more\n61, 1, 2, 3\n";
    EXPECT_EQ(read(deck, "blade").cells.size(), 3u);
    expect_words(complaint(deck), "elements of the type MASS are not offered");
    expect_words(complaint(deck, "blade skin"), "elements of the type S8R");
    expect_words(complaint(deck, "blade more"), "elements of the type S3");
    expect_words(complaint(deck + "*Element, type=MASS\n70, 12\n", "blade"), "gives a mass to node 12 of the blade");
    expect_words(complaint(part("B") + "*Assembly\n" + instance("B-1", "B") +
                           "*Element, type=MASS, elset=m\n1, B-1.12\n*End Assembly\n"),
                 "gives a mass to node 12 of the blade");
  }

  TEST(AbaqusDeck, PassesOverWhatLeavesTheMeshAsItIs)
  {
    std::string text = "*Heading\nA job\n*Preprint, echo=NO\n" + flat;
    for (const char *const keyword : {"Material, name=Ti",
                                      "Density",
                                      "Elastic",
                                      "Plastic, hardening=JOHNSON COOK",
                                      "Damage Initiation, criterion=JC",
                                      "Shell Section, elset=x, material=Ti",
                                      "Section Controls, name=EC-1",
                                      "Amplitude, name=a",
                                      "Boundary",
                                      "Initial Conditions, type=VELOCITY",
                                      "Contact",
                                      "Contact Inclusions, ALL EXTERIOR",
                                      "Surface Interaction, name=i",
                                      "Friction",
                                      "Step, name=s",
                                      "Dynamic, Explicit",
                                      "Bulk  Viscosity",
                                      "Dload",
                                      "Output, field",
                                      "Node Output",
                                      "Element Output, directions=YES",
                                      "End Step",
                                      "Restart, write",
                                      "El Print",
                                      "Transform, nset=x",
                                      "Orientation, name=o",
                                      "Distribution, name=d",
                                      "Time Points, name=t",
                                      "Fixed Mass Scaling",
                                      "Parameter"})
      text += "*" + std::string(keyword) + "\n1., 2.\n";
    const auto mesh = read(text);
    EXPECT_EQ(mesh.cells.size(), 3u);
    EXPECT_TRUE(mesh.file_notes.always.empty()) << mesh.file_notes.always[0];
  }

  TEST(AbaqusDeck, RefusesByNameWhatMovesThickensOrMakes)
  {
    for (const char *const keyword : {"IMPERFECTION", "INCLUDE", "SYSTEM", "NGEN", "NCOPY", "NFILL", "NMAP", "ELGEN",
                                      "ELCOPY", "NODAL THICKNESS", "ADJUST", "IMPORT", "SYMMETRIC MODEL GENERATION",
                                      "PARAMETER SHAPE VARIATION", "SUBSTRUCTURE PATH", "MAP SOLUTION", "NSETT"})
      expect_words(complaint(flat + "*" + keyword + ", x=1\n1, 2\n"),
                   "line 14: the keyword *" + std::string(keyword) + " is not offered");
    expect_words(complaint("*NODE\n1, <xt>, 0.\n"), "the parameter '<xt>' stands for a number");
  }

  TEST(AbaqusDeck, NotesWhatTiesStressesOrShifts)
  {
    for (const char *const keyword :
         {"TIE", "MPC", "EQUATION", "COUPLING", "RIGID BODY", "EMBEDDED ELEMENT", "MODEL CHANGE", "NONSTRUCTURAL MASS",
          "CONTACT PAIR, ADJUST=0.1", "INITIAL CONDITIONS, TYPE=STRESS", "SHELL SECTION, ELSET=x, OFFSET=SPOS"})
      {
        const auto notes = read(flat + "*" + keyword + "\n1, 2\n").file_notes.always;
        ASSERT_EQ(notes.size(), 1u) << keyword;
        expect_words(notes[0], " in line 14 is not read");
      }
    EXPECT_TRUE(read(flat + "*SHELL SECTION, ELSET=x, OFFSET=0.0\n1, 2\n").file_notes.always.empty());
  }
} // namespace birdstrike::abaqus_deck_test
