#include "simulation/warnings/case_warnings.h"

#include <gtest/gtest.h>

#include "simulation/scene.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/machine.h>
#include <birdstrike/io/case_parameters.h>

#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

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

// The plate pressed along its span buckles at pi^2 EI/4L^2 = 1671 N (Euler), of a wide plate up to 1/(1 - nu^2) more.
TEST(CaseWarnings, SaysThatConstantLoadsBuckleTheBlade)
{
  for (const auto &[load, is_unstable] :
       {std::pair("-1340", false), {"-2500", true}, {"2500", false}, {"-2500*min(1, t/1e-3)", false}})
    {
      const auto all = of_scene({std::string("Blade/Loads/Point loads=0.3112 0 0: ") + load + "; 0; 0"});
      EXPECT_EQ(std::ranges::count(all, "blade/unstable_equilibrium"), is_unstable) << load;
    }
}

// A plate that spins about its span is softened by m w^2, and has no tension: its equilibrium ends at its first
// frequency, 1.8751^2 t sqrt(E/(12 rho))/L^2 = 227 rad/s.
TEST(CaseWarnings, SaysThatTheEquilibriumAtTheStartIsUnstable)
{
  for (const auto &[speed, is_unstable] : {std::pair("200", false), {"260", true}})
    {
      const auto all = of_scene({"Blade/Spin/Axis=1, 0, 0", std::string("Blade/Spin/Speed=") + speed});
      EXPECT_EQ(std::ranges::count(all, "blade/unstable_equilibrium"), is_unstable) << speed;
    }
}

// 'Ti-6Al-4V' of the table has a yield stress of 880 MPa (MatWeb) and no flow curve.
TEST(CaseWarnings, SaysWhatAMetalThatIsNamedAloneDoesNotDo)
{
  const auto of_case = [](const std::vector<std::string> &overrides) {
    CaseParameters parameters;
    parameters.read(BIRDSTRIKE_SOURCE_DIR "/tests/data/alone.prm", overrides);
    return find_input_warnings(parameters);
  };
  const Warnings said = of_case({});
  ASSERT_EQ(codes(said), std::vector<std::string>{"metal/no_hardening"});
  for (const char *part : {"Blade/Material: 'Ti-6Al-4V'", "880 MPa", "no hardening and no strain rates", "Rate factor",
                           "Hardening = perfect"})
    EXPECT_NE(said[0].text.find(part), std::string::npos) << said[0].text;
  EXPECT_EQ(codes(of_case({"Blade/Material/Hardening=table"})), codes(said)) << "what the table has is none";
  EXPECT_EQ(codes(of_case({"Blade/Material/Yield stress=900 MPa"})), codes(said));
  EXPECT_NE(of_case({"Blade/Material/Rate factor=0.02"})[0].text.find("but no hardening, neither"), std::string::npos);
  for (const char *known : {"Blade/Material/Hardening=perfect", "Blade/Material/Hardening=elastic",
                            "Blade/Material/Name=Al 2024 Johnson-Cook", "Blade/Kind=rigid"})
    EXPECT_FALSE(std::ranges::count(codes(of_case({known})), "metal/no_hardening")) << known;
}

TEST(CaseWarnings, NamesMoreThreadsThanCores)
{
  EXPECT_EQ(codes(of_inputs({"Time/Threads=4096"})), std::vector<std::string>{"run/threads"});
  EXPECT_NE(of_inputs({"Time/Threads=4096", "Time/Force threads=true"})[0].text.find("many times slower"),
            std::string::npos);
  CaseParameters parameters;
  parameters.read(frontal, {"Time/Threads=4096"});
  EXPECT_EQ(parameters.time.n_threads(), usable_cores());
  parameters.read(frontal, {"Time/Threads=4096", "Time/Force threads=true"});
  EXPECT_EQ(parameters.time.n_threads(), 4096u);
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

TEST(CaseWarnings, NamesEntriesThatNoLawReads)
{
  const std::vector<std::pair<std::string, std::string>> unused{
    {"Blade/Material/Hardening=perfect", "Blade/Material/Hardening modulus is set, and means nothing: Hardening is"},
    {"Blade/Material/Hardening exponent=0.3", "Hardening is linear"},
    {"Blade/Material/Rate exponent=4", "Rate law is johnson-cook"},
    {"Blade/Material/Reference rate=10", "Rate factor is 0"},
    {"Blade/Material/Initial temperature=500", "Adiabatic heating is false"},
    {"Blade/Material/Melting temperature=1900", "Adiabatic heating is false"},
    {"Blade/Material/Failure strain=0.1", "Failure is none"},
    {"Blade/Material/Damage D2=0.3", "Failure is none"},
    {"Blade/Mesh/Profile/Stagger=30", "Mesh/Generator is flat plate"},
    {"Blade/Thickness/Leading edge=0.1", "Thickness/Maximum is empty"},
    {"Blade/Mesh/Row/Pitch=20", "Mesh/Row/Blades is 1"},
    {"Blade/Rigid/Mass=2", "Blade/Kind is shell"},
    {"Bird/Equation of state/Bulk modulus=1e9", "Type is murnaghan"},
    {"Blade/Element/Hourglass coefficient=0.1", "it is that of Belytschko-Tsay shells, and there are none"}};
  for (const auto &[entry, why] : unused)
    {
      const Warnings warnings = of_inputs({entry});
      ASSERT_EQ(codes(warnings), std::vector<std::string>{"entry/unused"}) << entry;
      EXPECT_NE(warnings[0].text.find(why), std::string::npos) << warnings[0].text;
      const std::string name = entry.substr(0, entry.find('='));
      EXPECT_NE(warnings[0].text.find(name), std::string::npos) << warnings[0].text; // or longer: Hardening modulus
    }
}

TEST(CaseWarnings, NamesWhatMetalsAloneRead)
{
  const auto texts_of = [](const std::vector<std::string> &entries) {
    CaseParameters plies;
    plies.read(frontal, entries);
    std::vector<std::string> texts;
    for (const Warning &each : find_input_warnings(plies))
      texts.push_back(each.text);
    return texts;
  };
  const std::vector<std::string> laminate{
    "Blade/Laminate/Plies=[0/90]s",           "Blade/Laminate/Density=1600",
    "Blade/Laminate/Young's modulus 1=138e9", "Blade/Laminate/Young's modulus 2=9e9",
    "Blade/Laminate/Poisson's ratio 12=0.3",  "Blade/Laminate/Shear modulus 12=6.9e9",
    "Blade/Laminate/Shear modulus 13=6.9e9",  "Blade/Laminate/Shear modulus 23=3.4e9"};
  const std::vector<std::string> sheath{"Blade/Section 1/Material ids=7", "Blade/Section 1/Material/Name=Ti-6Al-4V"};
  for (const std::string entry : {"Element/Shear factor=0.9", "Element/Thinning=false", "Element/Points rule=Lobatto",
                                  "Element/Points through thickness=5", "Material/Density=4000"})
    {
      auto entries = laminate;
      entries.push_back("Blade/" + entry);
      const auto tells = [&](const std::vector<std::string> &texts) {
        const std::string name = "Blade/" + entry.substr(0, entry.find(entry[0] == 'M' ? '/' : '='));
        return std::ranges::any_of(
          texts, [&](const std::string &text) { return text.starts_with(name + " is set, and means nothing"); });
      };
      EXPECT_TRUE(tells(texts_of(entries))) << entry;
      entries.insert(entries.end(), sheath.begin(), sheath.end());
      EXPECT_EQ(tells(texts_of(entries)), entry[0] == 'M') << entry << ", which the sheath reads, but for the metal";
      EXPECT_FALSE(tells(texts_of({"Blade/" + entry}))) << entry;
    }
  auto entries = laminate;
  entries.insert(entries.end(), {"Blade/Section 1/Material ids=7", "Blade/Section 1/Points through thickness=5"});
  const auto texts = texts_of(entries);
  EXPECT_TRUE(std::ranges::any_of(texts, [](const std::string &text) {
    return text.starts_with("Blade/Section 1/Points through thickness is set, and means nothing");
  }));
}

TEST(CaseWarnings, NamesACorrectionIntervalThatNoPairsRead)
{
  using Texts = std::vector<std::string>;
  for (Texts way :
       {Texts{"Bird/Reconstruction=linear"}, Texts{"Bird/Gradient correction=false"},
        Texts{"Bird/Formulation=standard"}, Texts{"Bird/Strength/Shear modulus=2e6", "Bird/Strength/Yield stress=2e4"}})
    {
      way.emplace_back("Bird/Correction interval=8");
      const Warnings warnings = of_inputs(way);
      EXPECT_TRUE(std::ranges::any_of(warnings,
                                      [](const Warning &each) {
                                        return each.text.starts_with(
                                          "Bird/Correction interval is set, and means nothing");
                                      }))
        << way[0];
    }
  EXPECT_TRUE(of_inputs({"Bird/Correction interval=8"}).empty());
}

// The same entries where a law reads them, and those that say what is there anyway.
TEST(CaseWarnings, SaysNothingOfEntriesThatAreUsed)
{
  const std::string heating = "Blade/Material/Adiabatic heating=true", al = "Blade/Material/Name=Al 2024 Johnson-Cook",
                    modulus = "Blade/Material/Hardening modulus=table";
  for (const std::vector<std::string> &entries : std::vector<std::vector<std::string>>{
         {"Blade/Material/Hardening=voce", "Blade/Material/Hardening exponent=20"},
         {"Blade/Material/Rate law=cowper-symonds", "Blade/Material/Reference rate=40",
          "Blade/Material/Rate exponent=4"},
         {"Blade/Material/Rate factor=0"},
         {"Blade/Material/Rate factor=0.01", "Blade/Material/Reference rate=10"},
         {heating, "Blade/Material/Initial temperature=500", "Blade/Material/Softening exponent=1.1"},
         {"Blade/Material/Failure=plastic strain", "Blade/Material/Failure strain=0.1"},
         {al, modulus, "Blade/Material/Hardening=johnson-cook", "Blade/Material/Failure=Johnson-Cook",
          "Blade/Material/Damage D2=0.3"},
         {al, modulus, "Blade/Material/Hardening=johnson-cook", "Blade/Material/Rate factor=0",
          "Blade/Material/Reference rate=10", "Blade/Material/Failure=Johnson-Cook"},
         {"Blade/Mesh/Generator=blade", "Blade/Mesh/Profile/Stagger=30", "Blade/Thickness/Maximum=0.004",
          "Blade/Thickness/Leading edge=0.1", "Blade/Thickness/Value=default"},
         {"Bird/Equation of state/Type=linear", "Bird/Equation of state/Bulk modulus=1e9"},
         {"Bird/Equation of state/Type=porous", "Bird/Equation of state/Porosity=0.2"}})
    EXPECT_EQ(codes(of_inputs(entries)), std::vector<std::string>{}) << entries.back();
}

// frontal.prm sets Hardening and Hardening modulus for its Ti-6Al-4V.
TEST(CaseWarnings, NamesWhatANewMetalKeepsOfTheOldOne)
{
  const std::string al = "Blade/Material/Name=Al 2024 Johnson-Cook", hardening = "Blade/Material/Hardening=table",
                    modulus = "Blade/Material/Hardening modulus=table";
  const auto kept           = [](const std::vector<std::string> &entries) {
    const Warnings warnings = of_inputs(entries);
    EXPECT_EQ(codes(warnings), std::vector<std::string>{"entry/of_another_metal"});
    return warnings.empty() ? "" : warnings[0].text;
  };
  EXPECT_NE(kept({al}).find("still apply: Hardening, Hardening modulus."), std::string::npos) << kept({al});
  EXPECT_NE(kept({al, hardening}).find("still apply: Hardening modulus."), std::string::npos);
  EXPECT_NE(kept({hardening, al}).find("still apply: Hardening modulus."), std::string::npos) << "in either order";
  EXPECT_EQ(codes(of_inputs({al, hardening, modulus})), codes({}));
  EXPECT_EQ(codes(of_inputs({"Blade/Material/Name=Ti-6Al-4V"})), codes({})) << "what it is";
  EXPECT_EQ(codes(of_inputs({al, "Blade/Material/Name=Ti-6Al-4V"})), codes({})) << "there and back";
  CaseParameters plies;
  plies.read(BIRDSTRIKE_SOURCE_DIR "/prm/fan-blade-composite.prm", {al});
  EXPECT_FALSE(std::ranges::count(codes(find_input_warnings(plies)), "entry/of_another_metal")) << "of a laminate";
  CaseParameters              of_table;
  std::string                 pattern = (std::filesystem::temp_directory_path() / "birdstrike-table-XXXXXX").string();
  const std::filesystem::path folder  = mkdtemp(pattern.data());
  std::ofstream(folder / "case.prm") << "subsection Blade\nsubsection Material\nset Yield stress = table\nend\nend\n";
  of_table.read((folder / "case.prm").string(), {al});
  std::filesystem::remove_all(folder);
  EXPECT_EQ(codes(find_input_warnings(of_table)), codes({})) << "follows the name, though it is written out by then";
}

// What a run writes as parameters.prm has every entry, and none of them is there by a person's will.
TEST(CaseWarnings, SaysNothingOfAFileThatWasWritten)
{
  CaseParameters written;
  written.read(frontal);
  std::string                 pattern = (std::filesystem::temp_directory_path() / "birdstrike-written-XXXXXX").string();
  const std::filesystem::path folder  = mkdtemp(pattern.data());
  std::ofstream(folder / "parameters.prm") << written.file.as_prm();
  CaseParameters again;
  again.read((folder / "parameters.prm").string());
  std::filesystem::remove_all(folder);
  EXPECT_EQ(codes(find_input_warnings(again)), std::vector<std::string>{});
}

TEST(CaseWarnings, AFileThatSetsNothingIsTheDefaultCase)
{
  std::string                 pattern = (std::filesystem::temp_directory_path() / "birdstrike-empty-XXXXXX").string();
  const std::filesystem::path folder  = mkdtemp(pattern.data());
  for (const auto &[text, is_empty] :
       {std::pair("", true), std::pair("# set End time = 1\n\nsubsection Time\nend\n", true),
        std::pair("subsection Time\n  set End time = 1e-3\nend\n", false), std::pair("include other.prm\n", false)})
    {
      std::ofstream(folder / "case.prm") << text;
      std::ofstream(folder / "other.prm") << "";
      CaseParameters parameters;
      parameters.read((folder / "case.prm").string());
      EXPECT_EQ(std::ranges::count(codes(find_input_warnings(parameters)), "case/empty"), is_empty ? 1 : 0) << text;
    }
  std::filesystem::remove_all(folder);
}

TEST(CaseWarnings, LooksAtTheParts)
{
  using Codes = std::vector<std::string>;
  EXPECT_EQ(of_scene({"Blade/Supports/Clamped=", "Blade/Supports/Free=0"}), Codes{"blade/free"});
  EXPECT_EQ(of_scene({"Bird/Chordwise offset=-0.04445"}), (Codes{"bird/cut_by_edge", "bird/misses_in_part"}));
  EXPECT_EQ(of_scene({"Bird/Chordwise offset=-0.0635"}), Codes{"bird/misses_in_part"}) << "all but passes it";
  EXPECT_EQ(of_scene({"Output/Field interval=1e-9", "Time/End time=0.4"}), Codes{"output/large"});
  EXPECT_EQ(of_scene({"Blade/Supports/Tip=0"}), Codes{"blade/tip_is_root"});
  EXPECT_EQ(of_scene({"Blade/Kind=solid", "Blade/Supports/Held=1: hinged"}), Codes{"blade/hinge_is_clamp"});
  EXPECT_EQ(of_scene({"Blade/Kind=solid", "Blade/Supports/Held=1: clamped"}), Codes{});
  EXPECT_EQ(of_scene({"Blade/Supports/Held=1: hinged"}), Codes{}) << "of a shell it is one";
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

// A plate of 311.2 by 88.9 in mm, read as if these were metres; its root is at x = `from`.
TEST(CaseWarnings, AMeshInMillimetresIsToldWhichEntryScalesIt)
{
  const auto read = [](const double from) {
    std::string                 pattern = (std::filesystem::temp_directory_path() / "birdstrike-mm-XXXXXX").string();
    const std::filesystem::path folder  = mkdtemp(pattern.data());
    std::ofstream               file(folder / "mm.msh");
    file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 " << from << " -44.45 0\n2 " << from + 311.2
         << " -44.45 0\n3 " << from + 311.2 << " 44.45 0\n4 " << from
         << " 44.45 0\n$EndNodes\n$Elements\n3\n1 1 2 10 10 1 4\n2 1 2 11 11 2 3\n3 3 2 1 1 1 2 3 4\n$EndElements\n";
    file.close();
    CaseParameters parameters;
    parameters.read(frontal, {"Blade/Mesh/Generator=file", "Blade/Mesh/File=" + (folder / "mm.msh").string(),
                              "Blade/Supports/Clamped=10", "Blade/Supports/Tip=11", "Bird/Particle spacing=0.006"});
    std::string text;
    try
      {
        const Scene scene(parameters);
        for (const Warning &warning : find_scene_warnings(parameters, scene))
          text += warning.code == "unit/blade_size" ? warning.text : "";
      }
    catch (const InputError &error)
      {
        text = error.what();
      }
    std::filesystem::remove_all(folder);
    return text;
  };
  EXPECT_NE(read(0.).find("Blade/Mesh/File scale"), std::string::npos) << read(0.);
  const std::string missed = read(100.);
  EXPECT_NE(missed.find("between (100, -44.45, 0) and (411.2, 44.45, 0) m"), std::string::npos) << missed;
  EXPECT_NE(missed.find("Blade/Mesh/File scale"), std::string::npos) << missed;
}

TEST(CaseWarnings, ABirdOfFewParticlesIsCoarse)
{
  CaseParameters parameters;
  parameters.read(frontal, {"Bird/Particle spacing=0.006"});
  const Scene scene(parameters);
  EXPECT_EQ(codes(find_scene_warnings(parameters, scene)), std::vector<std::string>{"bird/coarse"});
}

// Impulses of frontal.prm and rigid-plate.prm at 4 and 1.8 mm say which targets are stiff: 3.7 % too large on a rigid
// plate and about as much on 8 and 16 mm of titanium, one on 4.27 mm.
TEST(CaseWarnings, AStiffTargetNeedsFinerParticles)
{
  const auto of_case = [](const std::string &name, const std::vector<std::string> &overrides) {
    CaseParameters parameters;
    parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/" + name, overrides);
    const Scene scene(parameters);
    const auto  all = codes(find_scene_warnings(parameters, scene));
    return std::count(all.begin(), all.end(), std::string("bird/stiff_target"));
  };
  EXPECT_EQ(of_case("rigid-plate.prm", {"Bird/Particle spacing=0.004"}), 1);
  EXPECT_EQ(of_case("rigid-plate.prm", {}), 0) << "20 particles across";
  EXPECT_EQ(of_case("rigid-plate.prm",
                    {"Bird/Particle spacing=0.004", "Blade/Rigid/Motion=free along normal", "Blade/Rigid/Mass=0.05"}),
            0)
    << "it flies off";
  for (const char *kind : {"shell", "solid"})
    for (const auto &[thickness, n] : {std::pair{"0.00427", 0}, {"0.008", 1}, {"0.016", 1}})
      EXPECT_EQ(of_case("frontal.prm", {"Bird/Particle spacing=0.004", "Blade/Mesh/Elements along span=31",
                                        "Blade/Mesh/Elements along chord=9", std::string("Blade/Kind=") + kind,
                                        std::string("Blade/Thickness/Value=") + thickness}),
                n)
        << kind << ' ' << thickness;
  for (const char *name : {"oblique.prm", "fan-blade.prm", "fan-blade-composite.prm", "fan-row.prm", "sheath.prm",
                           "perforation.prm", "quickstart.prm"})
    EXPECT_EQ(of_case(name, {}), 0) << name;
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
