#include "simulation/case_warnings.h"

#include <gtest/gtest.h>

#include "simulation/scene.h"
#include <birdstrike/io/case_parameters.h>

#include <algorithm>

using namespace birdstrike;

namespace
{
  const std::string frontal = BIRDSTRIKE_SOURCE_DIR "/prm/frontal.prm";

  std::vector<std::string> codes(const Warnings &warnings)
  {
    std::vector<std::string> all;
    for (const Warning &warning : warnings)
      all.push_back(warning.code);
    return all;
  }

  Warnings of_inputs(const std::vector<std::string> &overrides)
  {
    CaseParameters parameters;
    parameters.read(frontal, overrides);
    return find_input_warnings(parameters);
  }

  std::vector<std::string> of_scene(std::vector<std::string> overrides)
  {
    overrides.push_back("Bird/Particle spacing=0.004"); // fast
    CaseParameters parameters;
    parameters.read(frontal, overrides);
    const Scene scene(parameters);
    return codes(find_scene_warnings(parameters, scene));
  }
} // namespace

TEST(CaseWarnings, AShippedCaseHasNone)
{
  EXPECT_EQ(codes(of_inputs({})), codes({}));
  EXPECT_EQ(of_scene({}), codes({}));
}

TEST(CaseWarnings, NamesTheUnitThatWasMeant)
{
  // a case typed in mm, t, s (MPa): each entry by itself
  const std::vector<std::tuple<std::string, std::string, std::string>> wrong{
    {"Blade/Material/Young's modulus=113800", "unit/young", "MPa? That would be 1.138e+11 Pa"},
    {"Blade/Material/Young's modulus=113.8", "unit/young", "GPa? That would be 1.138e+11 Pa"},
    {"Blade/Material/Yield stress=880", "unit/yield", "MPa? That would be 8.8e+08 Pa"},
    {"Blade/Material/Density=4.43", "unit/density", "g/cm^3? That would be 4430 kg/m^3"},
    {"Bird/Density=0.95", "unit/bird_density", "g/cm^3? That would be 950 kg/m^3"},
    {"Bird/Mass=100.5", "unit/bird_mass", "in g? That would be 0.1005 kg"},
    {"Bird/Velocity=0, 0, 177400", "unit/speed", "mm/s? That would be 177.4 m/s"},
    {"Time/End time=12", "unit/end_time", "ms? That would be 0.012 s"}};
  for (const auto &[entry, code, text] : wrong)
    {
      const Warnings warnings = of_inputs({entry});
      ASSERT_EQ(codes(warnings), std::vector{code}) << entry;
      EXPECT_NE(warnings[0].text.find(text), std::string::npos) << warnings[0].text;
    }
}

TEST(CaseWarnings, AnAngleMayBeMeantInRadians)
{
  CaseParameters parameters;
  parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/studies/angle.prm", {"Bird/Angle to surface=0.6353"});
  const Warnings warnings = find_input_warnings(parameters);
  ASSERT_EQ(codes(warnings), std::vector<std::string>{"unit/angle"});
  EXPECT_NE(warnings[0].text.find("in rad? That would be 36.4"), std::string::npos) << warnings[0].text;
}

TEST(CaseWarnings, NamesEntriesWithoutMeaning)
{
  const Warnings warnings = of_inputs({"Blade/Mesh/Layers=4"}); // of a shell
  ASSERT_EQ(codes(warnings), std::vector<std::string>{"entry/unused"});
  EXPECT_NE(warnings[0].text.find("Blade/Mesh/Layers"), std::string::npos);
}

TEST(CaseWarnings, LooksAtTheParts)
{
  using Codes = std::vector<std::string>;
  EXPECT_EQ(of_scene({"Blade/Supports/Clamped=", "Blade/Supports/Free=0"}), Codes{"blade/free"});
  EXPECT_EQ(of_scene({"Bird/Chordwise offset=-0.04445"}), (Codes{"bird/cut_by_edge", "bird/misses_in_part"}));
  EXPECT_EQ(of_scene({"Bird/Chordwise offset=-0.0635"}), Codes{"bird/misses_in_part"}) << "all but passes it";
  EXPECT_EQ(of_scene({"Output/Field interval=1e-9", "Time/End time=0.4"}), Codes{"output/large"});
  EXPECT_EQ(of_scene({"Blade/Supports/Tip=0"}), Codes{"blade/tip_is_root"});
  EXPECT_EQ(of_scene({"Blade/Kind=solid"}), Codes{}) << "one layer of solid-shells";
  EXPECT_EQ(of_scene({"Blade/Kind=solid", "Blade/Mesh/Layers=2"}), Codes{"blade/layers"});
  EXPECT_EQ(of_scene({"Blade/Kind=solid", "Blade/Mesh/Layers=4"}), Codes{});
  EXPECT_EQ(of_scene({"Blade/Kind=solid", "Blade/Mesh/Layers=2", "Blade/Element/Formulation=B-bar"}),
            Codes{"blade/layers"});
}

// Frontal.prm's bird is 81 mm long.
TEST(CaseWarnings, ASliceThatCutsNothingIsSaid)
{
  const auto of_slice = [](const std::string &between) {
    CaseParameters parameters;
    parameters.read(frontal, {"Bird/Particle spacing=0.004", "Bird/Slice/Between=" + between});
    return find_scene_warnings(parameters, Scene(parameters));
  };
  const Warnings in_mm = of_slice("-24.5, 24.5");
  ASSERT_EQ(codes(in_mm), std::vector<std::string>{"bird/uncut"});
  EXPECT_NE(in_mm[0].text.find("meant in mm? That would be 0.049 m"), std::string::npos) << in_mm[0].text;
  EXPECT_EQ(codes(of_slice("-0.0245, 0.0245")), std::vector<std::string>{});
  EXPECT_EQ(codes(of_slice("-0.0245, 1")), std::vector<std::string>{}) << "all behind one plane";
}

// Solid-shells do not fail (refused): they are no advice for a metal that does.
TEST(CaseWarnings, AdvisesLayersThatAreAllowed)
{
  const auto advice = [](std::vector<std::string> overrides) {
    overrides.insert(overrides.end(), {"Blade/Kind=solid", "Blade/Mesh/Layers=2", "Bird/Particle spacing=0.004"});
    CaseParameters parameters;
    parameters.read(frontal, overrides);
    const Warnings warnings = find_scene_warnings(parameters, Scene(parameters));
    return warnings.size() == 1 && warnings[0].code == "blade/layers" ? warnings[0].text : "";
  };
  EXPECT_NE(advice({}).find("One layer of solid-shells"), std::string::npos);
  const std::string failing = advice({"Blade/Material/Failure=plastic strain", "Blade/Material/Failure strain=0.2"});
  EXPECT_NE(failing.find("Four layers bend right"), std::string::npos) << failing;
  EXPECT_EQ(failing.find("solid-shells"), std::string::npos) << failing;
}

TEST(CaseWarnings, ABirdOfFewParticlesIsCoarse)
{
  CaseParameters parameters;
  parameters.read(frontal, {"Bird/Particle spacing=0.006"});
  const Scene scene(parameters);
  EXPECT_EQ(codes(find_scene_warnings(parameters, scene)), std::vector<std::string>{"bird/coarse"});
}

TEST(CaseWarnings, AShellThickerThanItsElementsIsNone)
{
  const auto warns = [](const std::string &thickness) {
    const auto all = of_scene({"Blade/Thickness/Value=" + thickness});
    return std::count(all.begin(), all.end(), "blade/thick_shell") == 1;
  };
  EXPECT_FALSE(warns("0.006"));
  EXPECT_TRUE(warns("0.0223"));
}
