#include <birdstrike/core/errors.h>
#include <birdstrike/core/thread_pool.h>
#include <birdstrike/structure/blade.h>
#include <birdstrike/structure/make_blade.h>
#include <birdstrike/structure/parameters.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

// What a blade makes of a mesh from a file: which sides and nodes are held, which bricks are solid-shells.
namespace birdstrike::file_blade_test
{
  namespace
  {
    class Blades
    {
    public:
      Blades()
        : path(std::filesystem::temp_directory_path() / ("birdstrike-blade-" + std::to_string(getpid()) + ".inp"))
      {
      }
      ~Blades()
      {
        std::filesystem::remove(path);
      }
      std::unique_ptr<Blade> make(const std::string &text, BladeParameters p = {})
      {
        std::ofstream(path) << text;
        p.mesh.generator = MeshGenerator::file;
        p.mesh.file      = path;
        return make_blade(p, pool);
      }
      std::string complaint(const std::string &text, const BladeParameters &p = {})
      {
        try
          {
            make(text, p);
          }
        catch (const InputError &error)
          {
            return error.what();
          }
        return "";
      }

    private:
      const std::filesystem::path path;
      ThreadPool                  pool;
    };

    /// 4 x 2 shells of 0.025 m; node 3 i + j + 1 at x = 0.025 i, y = 0.025 j. `sets`: Abaqus' lines after the elements.
    std::string plate(const std::string &sets)
    {
      std::ostringstream text;
      text << "*NODE\n";
      for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 3; ++j)
          text << 3 * i + j + 1 << ", " << 0.025 * i << ", " << 0.025 * j << ", 0\n";
      text << "*ELEMENT, TYPE=S4R, ELSET=all\n";
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 2; ++j)
          {
            const int first = 3 * i + j + 1;
            text << 2 * i + j + 1 << ", " << first << ", " << first + 3 << ", " << first + 4 << ", " << first + 1
                 << '\n';
          }
      return text.str() + sets;
    }

    const std::string ends = "*NSET, NSET=foot\n1, 2, 3\n*NSET, NSET=top\n13, 14, 15\n";

    BladeParameters clamped(const std::string &names)
    {
      BladeParameters p;
      p.supports.clamped = names;
      p.supports.tip     = "";
      return p;
    }

    std::vector<std::string> codes_of(const Blade &blade)
    {
      std::vector<std::string> codes;
      for (const Warning &warning : blade.census().warnings)
        codes.push_back(warning.code);
      return codes;
    }

    TEST(FileBlade, ItsRootMustBeNamed)
    {
      Blades blades;
      for (const std::string &sets : {ends, std::string()})
        {
          const std::string text = blades.complaint(plate(sets));
          for (const std::string &part :
               {std::string("Blade/Supports/Clamped is not given"), std::string("to 0 to constrain all"),
                std::string(sets.empty() ? "12 sides without a name (all of the whole boundary)"
                                         : "Names in this mesh: foot, top")})
            EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
        }
      BladeParameters hub;
      hub.supports.hub = "foot";
      EXPECT_EQ(blades.make(plate(ends), hub)->census().n_held_dofs, 18U) << "the hub alone";
      EXPECT_EQ(blades.make(plate(ends), clamped(""))->census().n_held_dofs, 0U);
      EXPECT_EQ(blades.make(plate(ends), clamped("foot"))->census().n_held_dofs, 18U);
      // of the 8 sides without a name the nodes of both long edges
      EXPECT_EQ(blades.make(plate(ends), clamped("0"))->census().n_held_dofs, 6U * 10U) << "on purpose";
    }

    TEST(FileBlade, ABoundaryThatIsHeldAllRoundIsSaid)
    {
      Blades     blades;
      const auto blade = blades.make(plate(""), clamped("0"));
      EXPECT_EQ(codes_of(*blade), std::vector<std::string>{"blade/whole_rim_held"});
      EXPECT_NE(blade->census().warnings[0].text.find("12 nodes"), std::string::npos)
        << blade->census().warnings[0].text;
      EXPECT_TRUE(codes_of(*blades.make(plate(ends), clamped("0"))).empty());
      EXPECT_TRUE(codes_of(*blades.make(plate(ends), clamped("foot, top"))).empty());
    }

    // A set of three rows: 9 nodes, of which those of the row x = 0 and of the edges lie on sides of it, 2 inside.
    TEST(FileBlade, NodesOfASetThatStayFreeAreCounted)
    {
      Blades            blades;
      const std::string deep  = plate("*NSET, NSET=foot\n1, 2, 3, 4, 5, 6, 7, 8, 9\n*NSET, NSET=one\n14\n"
                                       "*NSET, NSET=rim\n1, 2, 3, 4, 7, 6, 9\n");
      const auto        blade = blades.make(deep, clamped("foot"));
      EXPECT_EQ(blade->census().n_held_dofs, 6U * 7U);
      ASSERT_EQ(codes_of(*blade), std::vector<std::string>{"blade/set_partly_held"});
      const std::string text = blade->census().warnings[0].text;
      for (const char *part : {"Clamped = foot: 7 of the 9 nodes", "2 stay free (one is node 5)",
                               "Held boxes = 0.025 0.025 0 0.05 0.025 0: clamped"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
      EXPECT_TRUE(codes_of(*blades.make(deep, clamped("rim"))).empty()) << "all of it on its sides";
      auto advised                = clamped("foot");
      advised.supports.held_boxes = "0.025 0.025 0 0.05 0.025 0: clamped";
      const auto held             = blades.make(deep, advised);
      EXPECT_EQ(held->census().n_held_dofs, 6U * 9U);
      EXPECT_TRUE(codes_of(*held).empty()) << "what the warning advises ends it";
      auto others          = clamped("rim");
      others.supports.held = "foot: uz";
      EXPECT_EQ(codes_of(*blades.make(deep, others)), std::vector<std::string>{"blade/set_partly_held"});
    }

    /// n_x x 2 columns of bricks, 10 x 10 x 2 mm, `layers` of each along x.
    std::string bricks(const std::vector<int> &layers)
    {
      std::ostringstream text;
      const auto         node = [](const int i, const int j, const int k) { return 1 + k + 10 * (j + 3 * i); };
      text << "*NODE\n";
      for (int i = 0; i <= static_cast<int>(layers.size()); ++i)
        for (int j = 0; j < 3; ++j)
          for (int k = 0; k < 10; ++k)
            text << node(i, j, k) << ", " << 0.01 * i << ", " << 0.01 * j << ", " << 0.002 * k << '\n';
      text << "*ELEMENT, TYPE=C3D8R, ELSET=all\n";
      for (int i = 0, n = 0; i < static_cast<int>(layers.size()); ++i)
        for (int j = 0; j < 2; ++j)
          for (int k = 0; k < layers[static_cast<std::size_t>(i)]; ++k)
            text << ++n << ", " << node(i, j, k) << ", " << node(i + 1, j, k) << ", " << node(i + 1, j + 1, k) << ", "
                 << node(i, j + 1, k) << ", " << node(i, j, k + 1) << ", " << node(i + 1, j, k + 1) << ", "
                 << node(i + 1, j + 1, k + 1) << ", " << node(i, j + 1, k + 1) << '\n';
      return text.str();
    }

    TEST(FileBlade, AutomaticIsTheSolidShellWhereOneBrickMakesUpTheThickness)
    {
      Blades     blades;
      const auto found = [&](const std::vector<int> &layers, const FailureLaw law = FailureLaw::none) {
        BladeParameters p      = clamped("");
        p.kind                 = BladeKind::solid;
        p.material.hardening   = "perfect";
        p.material.failure.law = law;
        std::string text;
        for (const auto &each : blades.make(bricks(layers), p)->census().formulations)
          text += element_formulations().name(each.formulation) + " " + std::to_string(each.n_elements) + " of " +
                  std::to_string(each.n_layers) + "; ";
        return text;
      };
      EXPECT_EQ(found({1, 1, 1}), "solid-shell 6 of 1; ");
      EXPECT_EQ(found({2, 2, 2}), "one point 12 of 2; ");
      EXPECT_EQ(found({4, 4}), "one point 16 of 4; ");
      EXPECT_EQ(found({1, 1, 1}, FailureLaw::plastic_strain), "one point 6 of 1; ") << "solid-shells do not fail";
      // a root of three layers: its own bricks stand three high, the others alone
      EXPECT_EQ(found({3, 1, 1, 1}), "solid-shell 6 of 1; one point 6 of 3; ");
    }

    // Sections by number: a split one counts once, with all of its elements.
    TEST(FileBlade, AMixtureIsOneSection)
    {
      Blades          blades;
      BladeParameters p = clamped("");
      p.kind            = BladeKind::solid;
      const auto blade  = blades.make(bricks({3, 1, 1, 1}), p);
      EXPECT_TRUE(blade->census().sections.empty());
      EXPECT_EQ(blade->peak_plastic_strains().size(), 1U);
      EXPECT_NEAR(blade->mass(), 4430. * 12 * 0.01 * 0.01 * 0.002, 1e-12);
      p.sections[0].material_ids  = "all";
      p.sections[0].material.name = "Ti-6Al-4V";
      EXPECT_EQ(blades.make(bricks({3, 1, 1, 1}), p)->census().formulations.size(), 2U);
    }
  } // namespace
} // namespace birdstrike::file_blade_test
