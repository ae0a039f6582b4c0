#include "simulation/warnings/case_warnings.h"

#include <gtest/gtest.h>

#include "simulation/scene.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>

#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace birdstrike;

// What a mesh leaves to be guessed: sides that nobody names, thickness, joints, units.
namespace mesh_warnings
{
  using Codes = std::vector<std::string>;

  const std::string frontal = BIRDSTRIKE_SOURCE_DIR "/prm/frontal.prm";

  /// Codes of both kinds, or the words of what is refused.
  Codes codes_of(std::vector<std::string> overrides)
  {
    overrides.insert(overrides.begin(), "Bird/Particle spacing=0.004"); // fast
    CaseParameters parameters;
    Codes          codes;
    try
      {
        parameters.read(frontal, overrides);
        const Scene scene(parameters);
        for (const Warnings &some : {find_input_warnings(parameters), find_scene_warnings(parameters, scene)})
          for (const Warning &warning : some)
            codes.push_back(warning.code);
      }
    catch (const InputError &error)
      {
        codes.emplace_back(error.what());
      }
    return codes;
  }

  Codes of_file(const std::string &file, const std::vector<std::string> &overrides)
  {
    std::vector<std::string> all{"Blade/Mesh/Generator=file", "Blade/Mesh/File=" + file,
                                 "Blade/Mesh/Elements along span=28", "Blade/Mesh/Elements along chord=8"}; // defaults
    all.insert(all.end(), overrides.begin(), overrides.end());
    return codes_of(all);
  }

  const std::string shells = BIRDSTRIKE_SOURCE_DIR "/meshes/plate-28x8.msh",
                    bricks = BIRDSTRIKE_SOURCE_DIR "/meshes/plate-28x8x1.msh";
} // namespace mesh_warnings

TEST(MeshWarnings, WhereAFileNamesItsSidesTheRootMustBeNamed)
{
  using namespace mesh_warnings;
  const Codes refused = of_file(shells, {"Blade/Supports/Tip=tip"});
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_NE(refused[0].find("Names in this mesh:"), std::string::npos) << refused[0];
  const Codes no_such = of_file(shells, {"Blade/Supports/Clamped=0", "Blade/Supports/Tip=tip"});
  ASSERT_EQ(no_such.size(), 1U);
  EXPECT_NE(no_such[0].find("the mesh has no boundary id 0"), std::string::npos) << "all four sides have names";
  EXPECT_EQ(of_file(shells, {"Blade/Supports/Clamped=root", "Blade/Supports/Tip=tip"}), Codes{});
  EXPECT_EQ(of_file(shells, {"Blade/Supports/Clamped=", "Blade/Supports/Hub=root", "Blade/Supports/Tip=tip"}), Codes{});
  EXPECT_EQ(of_file(shells, {"Blade/Supports/Clamped=root"}), Codes{"blade/no_tip"}) << "1 is the root here";
  // all four sides have names: with the hub alone there is no side 0 to be held, nor to be missed
  EXPECT_EQ(of_file(shells, {"Blade/Supports/Hub=root", "Blade/Supports/Tip=tip"}), Codes{});
}

TEST(MeshWarnings, ElementsOutsideOfTheSizeFactorsAreSaid)
{
  using namespace mesh_warnings; // 62 x 18 elements of 5.02 x 4.94 mm
  const std::string failure = "Blade/Material/Failure=plastic strain", factors = "Blade/Material/Failure size factors=";
  EXPECT_EQ(codes_of({failure, factors + "4e-3: 1.2; 6e-3: 1"}), Codes{});
  EXPECT_EQ(codes_of({failure, factors + "1e-3: 1.2; 4e-3: 1"}), Codes{"blade/beyond_size_factors"});
  EXPECT_EQ(codes_of({factors + "1e-3: 1.2; 4e-3: 1"}), Codes{"entry/unused"}) << "of a metal that does not fail";
}

// What is rigid cannot fail, and a section is named with its own table: lengths in mm are those of points and elements.
TEST(MeshWarnings, SizeFactorsAreThoseOfASectionAndOfElasticBlades)
{
  const std::string row = "Blade/Mesh/Row/", failure = "Material/Failure=plastic strain",
                    factors = "Material/Failure size factors=1e-3: 1.2; 4e-3: 1";
  const auto text_of        = [](std::vector<std::string> overrides) {
    overrides.insert(overrides.begin(), "Bird/Particle spacing=0.004");
    CaseParameters parameters;
    parameters.read(mesh_warnings::frontal, overrides);
    std::string text;
    for (const Warning &warning : find_scene_warnings(parameters, Scene(parameters)))
      text += warning.code == "blade/beyond_size_factors" ? warning.text : "";
    return text;
  };
  const std::string rest = " elements are outside of the points, 1 to 4 mm, and take the factor of the nearer end; its "
                           "elements are of 4.979 to 4.979 mm.";
  EXPECT_EQ(text_of({row + "Blades=3", row + "Place=2", row + "Rigid=1 3", "Blade/" + failure, "Blade/" + factors}),
            "Blade/Material/Failure size factors: 1116" + rest);
  EXPECT_EQ(
    text_of({"Blade/Mesh/Material patches=0 0.5 0 1: 1", "Blade/Section 1/Material ids=1",
             "Blade/Section 1/Material/Name=Ti-6Al-4V", "Blade/Section 1/" + failure, "Blade/Section 1/" + factors}),
    "Blade/Section 1/Material/Failure size factors: 558" + rest);
}

TEST(MeshWarnings, AThicknessThatNobodyGaveIsSaid)
{
  std::string                 pattern = (std::filesystem::temp_directory_path() / "birdstrike-thick-XXXXXX").string();
  const std::filesystem::path folder  = mkdtemp(pattern.data());
  for (const std::string thickness : {"", "set Value = 4e-3", "set Maximum = 4e-3"})
    {
      std::ofstream(folder / "case.prm") << "subsection Blade\n subsection Mesh\n set Generator = file\n set File = "
                                         << mesh_warnings::shells
                                         << "\n end\n subsection Supports\n set Clamped = root\n set Tip = tip\n end\n"
                                         << " subsection Thickness\n"
                                         << thickness << "\n end\nend\n";
      CaseParameters parameters;
      parameters.read((folder / "case.prm").string(), {"Bird/Particle spacing=0.004"});
      const Warnings warnings = find_scene_warnings(parameters, Scene(parameters));
      EXPECT_EQ(warnings.size(), thickness.empty() ? 1U : 0U) << thickness;
      EXPECT_TRUE(warnings.empty() || warnings[0].code == "blade/thickness_not_given") << warnings[0].text;
      EXPECT_TRUE(warnings.empty() || warnings[0].text.find("224 of 224 elements") != std::string::npos);
    }
  std::filesystem::remove_all(folder);
}

TEST(MeshWarnings, LayersOfAFileAreCountedToo)
{
  using namespace mesh_warnings;
  const std::vector<std::string> solid{"Blade/Kind=solid", "Blade/Supports/Clamped=root", "Blade/Supports/Tip=tip"};
  EXPECT_EQ(of_file(bricks, solid), Codes{}) << "automatic is the solid-shell there";
  auto with_one_point = solid;
  with_one_point.push_back("Blade/Element/Formulation=one point");
  EXPECT_EQ(of_file(bricks, with_one_point), Codes{"blade/layers"});
}

TEST(MeshWarnings, LengthsOfAnotherUnit)
{
  using namespace mesh_warnings;
  EXPECT_EQ(codes_of({"Blade/Thickness/Value=4.27e-6"}), Codes{"unit/thickness"}) << "0.00427 mm";
  EXPECT_EQ(codes_of({"Blade/Supports/Held boxes=0 -50 -5 312 50 5: ux uy uz"}), Codes{"blade/all_held"});
  EXPECT_EQ(codes_of({"Blade/Supports/Held boxes=0 -50 -5 0.3 50 5: ux uy uz"}), Codes{});
  const std::vector<std::string> blade{"Blade/Mesh/Generator=blade", "Bird/Chordwise offset=0"};
  const auto                     with = [&](const std::string &more) {
    auto all = blade;
    all.push_back(more);
    const Codes codes = codes_of(all);
    return std::count(codes.begin(), codes.end(), "unit/stacking");
  };
  EXPECT_EQ(with("Blade/Mesh/Profile/Lean=5e-3*s"), 0);
  EXPECT_EQ(with("Blade/Mesh/Profile/Lean=5*s"), 1);
}

TEST(MeshWarnings, StrainsInPercent)
{
  using namespace mesh_warnings;
  EXPECT_EQ(codes_of({"Blade/Material/Failure=plastic strain", "Blade/Material/Failure strain=14"}),
            Codes{"unit/failure_strain"});
  EXPECT_EQ(codes_of({"Blade/Material/Failure=plastic strain", "Blade/Material/Failure strain=0.14"}), Codes{});
  EXPECT_EQ(codes_of({"Blade/Material/Hardening=curve", "Blade/Material/Hardening modulus=table",
                      "Blade/Material/Yield stress=table",
                      "Blade/Material/Hardening curve=0: 880 MPa; 2: 915 MPa; 10: 1200 MPa"}),
            Codes{"unit/curve_strain"});
}

TEST(MeshWarnings, ABladeOfAnEngineTurnsAboutAnAxisThatIsGiven)
{
  using namespace mesh_warnings;
  const auto of_inputs = [](std::vector<std::string> overrides) {
    overrides.insert(overrides.end(), {"Blade/Mesh/Generator=blade", "Blade/Spin/Speed=300"});
    CaseParameters parameters;
    parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/quickstart.prm", overrides);
    Codes codes;
    for (const Warning &warning : find_input_warnings(parameters))
      codes.push_back(warning.code);
    return codes;
  };
  EXPECT_EQ(of_inputs({}), Codes{"blade/axis_not_given"});
  EXPECT_EQ(of_inputs({"Blade/Spin/Axis=0, 0, 1"}), Codes{});
  const std::vector<std::string> at_ends{"Blade/Supports/Clamped=root", "Blade/Supports/Tip=tip", "Blade/Spin/Speed=10",
                                         "Blade/Spin/Prestress=false"};
  const auto                     with = [&](const std::string &more) {
    auto all = at_ends;
    all.push_back(more);
    return of_file(shells, all);
  };
  EXPECT_EQ(of_file(shells, at_ends), Codes{"blade/axis_not_given"}) << "of a file it may lie anywhere";
  EXPECT_EQ(with("Blade/Spin/Axis=0, 1, 0"), Codes{});
  EXPECT_EQ(with("Blade/Spin/Axis=1, 0.1, 0"), Codes{"blade/axis_along_span"});
}

// A file of a blade along z, whose normal, (0.99, 0, n_z), hardly looks up.
TEST(MeshWarnings, ABladeAlongZHasItsSidesAndPliesTold)
{
  using namespace mesh_warnings;
  std::string                 pattern = (std::filesystem::temp_directory_path() / "birdstrike-along-XXXXXX").string();
  const std::filesystem::path folder  = mkdtemp(pattern.data());
  const auto                  of_lean = [&](const double lean, std::vector<std::string> overrides) {
    std::ofstream file(folder / "blade.inp");
    file << "*NODE\n";
    for (int i = 0; i <= 10; ++i)
      for (int j = 0; j <= 4; ++j)
        file << 5 * i + j + 1 << ", " << lean * 0.03 * i << ", " << 0.02 * j - 0.04 << ", " << 0.03 * i << "\n";
    file << "*ELEMENT, TYPE=S4R, ELSET=blade\n";
    for (int i = 0; i < 10; ++i)
      for (int j = 0; j < 4; ++j)
        file << 4 * i + j + 1 << ", " << 5 * i + j + 1 << ", " << 5 * i + j + 6 << ", " << 5 * i + j + 7 << ", "
             << 5 * i + j + 2 << "\n";
    file << "*NSET, NSET=root\n1, 2, 3, 4, 5\n*NSET, NSET=tip\n51, 52, 53, 54, 55\n";
    file.close();
    overrides.insert(overrides.end(), {"Blade/Supports/Clamped=root", "Blade/Supports/Tip=tip",
                                       "Bird/Velocity=100, 0, 0", "Bird/Aim point=0, 0, 0.2", "Blade/Probes="});
    return of_file((folder / "blade.inp").string(), overrides);
  };
  const auto tells = [&](const double lean, const std::vector<std::string> &overrides, const char *code) {
    const Codes codes = of_lean(lean, overrides);
    return std::ranges::count(codes, code) == 1;
  };
  const std::string pressure = "Blade/Loads/Pressure=1e4", top = "blade/top_by_little";
  EXPECT_FALSE(tells(-0.02, {}, top.c_str())) << "nothing goes by the top face";
  EXPECT_TRUE(tells(-0.02, {pressure}, top.c_str()));
  EXPECT_TRUE(tells(0.02, {pressure}, top.c_str()));
  EXPECT_FALSE(tells(0.02, {pressure, "Blade/Mesh/Top=1 0 0"}, top.c_str()));
  EXPECT_FALSE(tells(-0.5, {pressure}, top.c_str()));
  EXPECT_NE(of_lean(0.02, {pressure, "Blade/Mesh/Top=0 1 0"}).back().find("lies along the surface"), std::string::npos);
  const std::vector<std::string> plies{
    "Blade/Laminate/Plies=[0/90]s",           "Blade/Laminate/Density=1600",
    "Blade/Laminate/Young's modulus 1=138e9", "Blade/Laminate/Young's modulus 2=9e9",
    "Blade/Laminate/Poisson's ratio 12=0.3",  "Blade/Laminate/Shear modulus 12=6.9e9",
    "Blade/Laminate/Shear modulus 13=6.9e9",  "Blade/Laminate/Shear modulus 23=3.4e9"};
  auto given = plies;
  given.emplace_back("Blade/Laminate/Reference direction=0 0 1");
  EXPECT_TRUE(tells(0.2, plies, "laminate/direction_not_given"));
  EXPECT_FALSE(tells(0.2, given, "laminate/direction_not_given"));
  std::filesystem::remove_all(folder);
}

TEST(MeshWarnings, UnitsOfLiquidsPliesAndIntervals)
{
  using namespace mesh_warnings;
  for (const auto &[entries, code] :
       {std::pair(Codes{"Bird/Equation of state/Murnaghan modulus=128e3"}, "unit/bulk_modulus"),
        {Codes{"Bird/Equation of state/Type=us-up", "Bird/Equation of state/Sound speed=1.48"}, "unit/sound_speed"},
        {Codes{"Bird/Equation of state/Type=linear", "Bird/Equation of state/Bulk modulus=2.2"}, "unit/bulk_modulus"},
        {Codes{"Blade/Material/Hardening modulus=1250"}, "unit/hardening_modulus"},
        {Codes{"Contact/Friction=30"}, "unit/friction"},
        {Codes{"Output/History interval=5"}, "unit/history_interval"},
        {Codes{"Output/Histories/Patches=spot: 0.2 0 0 20"}, "unit/radius"},
        {Codes{"Blade/Material/Adiabatic heating=true", "Blade/Material/Heat capacity=560",
               "Blade/Material/Melting temperature=1900", "Blade/Material/Initial temperature=150"},
         "unit/temperature"},
        {Codes{"Blade/Material/Failure=Johnson-Cook", "Blade/Material/Damage D1=0", "Blade/Material/Damage D2=0.3",
               "Blade/Material/Damage D3=0.5", "Blade/Material/Damage D4=0", "Blade/Material/Damage D5=0"},
         "material/damage_d3"}})
    {
      std::vector<std::string> overrides = entries;
      overrides.insert(overrides.begin(), "Bird/Particle spacing=0.004");
      CaseParameters parameters;
      parameters.read(frontal, overrides);
      const Warnings warnings = find_input_warnings(parameters);
      ASSERT_EQ(warnings.size(), 1U) << code;
      EXPECT_EQ(warnings[0].code, code);
    }
}

// Two squares of 0.1 m side by side; along their common side the second has nodes of its own, all or one of them.
TEST(MeshWarnings, NodesThatAreNotJoined)
{
  std::string                 pattern = (std::filesystem::temp_directory_path() / "birdstrike-slit-XXXXXX").string();
  const std::filesystem::path folder  = mkdtemp(pattern.data());
  for (const bool is_slit : {false, true})
    {
      std::ofstream file(folder / "two.msh");
      file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n1 0 0 0\n2 0.1 0 0\n3 0.2 0 0\n4 0 0.1 0\n5 0.1 0.1 0\n"
              "6 0.2 0.1 0\n7 0 0.2 0\n8 0.1 0.2 0\n9 0.2 0.2 0\n"
           << "$EndNodes\n$Elements\n8\n1 1 2 10 10 1 4\n2 1 2 10 10 4 7\n3 1 2 11 11 3 6\n4 1 2 11 11 6 9\n"
           << "5 3 2 1 1 1 2 5 4\n6 3 2 1 1 2 3 6 5\n7 3 2 1 1 4 5 8 7\n8 3 2 1 1 5 6 9 8\n$EndElements\n";
      file.close();
      if (is_slit) // node 2 of the second square is a node of its own
        {
          std::ofstream slit(folder / "two.msh");
          slit << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n10\n1 0 0 0\n2 0.1 0 0\n3 0.2 0 0\n4 0 0.1 0\n"
                  "5 0.1 0.1 0\n6 0.2 0.1 0\n7 0 0.2 0\n8 0.1 0.2 0\n9 0.2 0.2 0\n10 0.1 0 0\n"
               << "$EndNodes\n$Elements\n8\n1 1 2 10 10 1 4\n2 1 2 10 10 4 7\n3 1 2 11 11 3 6\n4 1 2 11 11 6 9\n"
               << "5 3 2 1 1 1 2 5 4\n6 3 2 1 1 10 3 6 5\n7 3 2 1 1 4 5 8 7\n8 3 2 1 1 5 6 9 8\n$EndElements\n";
        }
      CaseParameters parameters;
      parameters.read(mesh_warnings::frontal,
                      {"Blade/Mesh/Generator=file", "Blade/Mesh/File=" + (folder / "two.msh").string(),
                       "Blade/Supports/Clamped=10", "Blade/Supports/Tip=11", "Bird/Enabled=false"});
      std::string text;
      for (const Warning &warning : find_scene_warnings(parameters, Scene(parameters)))
        text += warning.code == "blade/not_joined" ? warning.text : "";
      EXPECT_EQ(text.starts_with("1 pairs of nodes lie on one another"), is_slit) << text;
      EXPECT_EQ(text.find("at the same place (0.1, 0, 0) m") != std::string::npos, is_slit) << text;
      EXPECT_EQ(text.empty(), !is_slit);
    }
  std::filesystem::remove_all(folder);
}
