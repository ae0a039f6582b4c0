#include "io/parameter_tree.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/input_files.h>

#include <gtest/gtest.h>

#include <cctype>

#include "scratch_folder.h"

using birdstrike::CaseParameters;
using birdstrike::KnownEntry;

TEST(CaseParameters, EveryTextIsASentenceThatEndsWithItsUnit)
{
  const CaseParameters parameters;
  const auto           tree = parameters.file.tree();
  EXPECT_GT(tree.entries().size(), 50u);
  for (const KnownEntry &entry : tree.entries())
    {
      const std::string where = birdstrike::to_string(entry.section) + "/" + entry.name;
      EXPECT_FALSE(entry.unit.empty()) << where << ": the text does not end with a unit in brackets";
      ASSERT_FALSE(entry.text.empty()) << where;
      EXPECT_EQ(entry.text.back(), '.') << where << ": the text is no sentence";
      EXPECT_TRUE(std::isupper(static_cast<unsigned char>(entry.text.front()))) << where;
      EXPECT_TRUE(std::isupper(static_cast<unsigned char>(entry.name.front()))) << where;
    }
}

TEST(CaseParameters, HasOneSectionForEachRoomAndOneForStudies)
{
  const CaseParameters parameters;
  EXPECT_EQ(parameters.file.tree().subsection_names({}),
            (std::vector<std::string>{"Case", "Blade", "Bird", "Bird 2", "Bird 3", "Bird 4", "Contact", "Time",
                                      "Output", "Study"}));
}

// What a further bird's section does not say is as in section Bird; of what stands for one another (velocity, aim) what
// it says replaces all.
TEST(CaseParameters, FurtherBirdsAreAsTheFirstButForWhatTheySay)
{
  const ScratchFolder scratch;
  const std::string   file = scratch.write(
      "birds.prm", "subsection Bird\n set Mass = 0.2\n set Speed = 150\n set Angle to surface = 60\n"
                     " set Aim span fraction = 0.7\n set Aim chord fraction = 0.5\n"
                     " subsection Equation of state\n  set Type = linear\n  set Bulk modulus = 2e9\n end\nend\n"
                     "subsection Bird 2\n set Enabled = true\n set Angle to surface = 90\n"
                     " set Arrival time = 1 ms\nend\n"
                     "subsection Bird 4\n set Enabled = true\n set Mass = 50 g\n set Velocity = 0, 0, 200\n"
                     " set Aim point = 0.1, 0, 0\n subsection Equation of state\n  set Type = us-up\n end\nend\n");
  CaseParameters parameters;
  parameters.read(file);
  const auto birds = parameters.birds();
  ASSERT_EQ(birds.size(), 3u);
  EXPECT_EQ(birds[1].number, 2u);
  EXPECT_EQ(birds[1].bird.mass, 0.2);
  EXPECT_NEAR(birds[1].bird.velocity[2], 150., 1e-9);
  EXPECT_EQ(birds[1].bird.aim_point, birds[0].bird.aim_point);
  EXPECT_EQ(birds[1].bird.arrival, 1e-3);
  EXPECT_EQ(birds[1].liquid.type, birdstrike::EosType::linear);
  EXPECT_EQ(birds[2].number, 4u);
  EXPECT_EQ(birds[2].bird.mass, 0.05);
  EXPECT_EQ(birds[2].bird.velocity[2], 200.);
  EXPECT_EQ(birds[2].bird.aim_point[0], 0.1);
  EXPECT_EQ(birds[2].bird.arrival, 0.) << "its own";
  EXPECT_EQ(birds[2].liquid.type, birdstrike::EosType::us_up);
  EXPECT_EQ(birds[2].liquid.bulk_modulus, 2e9);

  CaseParameters again; // the printed file says all of it
  again.read(scratch.write("again.prm", parameters.file.as_prm()));
  EXPECT_EQ(first_difference(parameters, again, {"Case/Name"}), "");
}

TEST(CaseParameters, DefaultsPassTheirOwnRangesAndReadBack)
{
  const ScratchFolder scratch;
  CaseParameters      first, second;
  const auto          tree = first.file.tree();
  for (const KnownEntry &entry : tree.entries())
    EXPECT_TRUE(entry.allows(entry.value))
      << birdstrike::to_string(entry.section) << "/" << entry.name << " = " << entry.value;
  first.read(scratch.write("plain.prm", ""));
  second.read(scratch.write("parameters.prm", first.file.as_prm()));
  EXPECT_EQ(second.name, "plain");
  EXPECT_EQ(first.file.as_prm(), second.file.as_prm());
}

TEST(CaseParameters, NameAndFolderComeFromTheFileUnlessGiven)
{
  const ScratchFolder scratch;
  {
    CaseParameters parameters;
    parameters.read(scratch.write("frontal.prm", ""), {"Time/End time=2e-3", "Time/Multirate=off"});
    EXPECT_EQ(parameters.name, "frontal");
    EXPECT_EQ(parameters.run_directory(), "runs/frontal");
    CaseParameters again;
    again.read(scratch.write("parameters.prm", parameters.file.as_prm()));
    EXPECT_EQ(again.name, "frontal");
    EXPECT_EQ(parameters.time.end_time, 2e-3);
    EXPECT_FALSE(parameters.time.multirate);
  }
  CaseParameters parameters;
  parameters.read(scratch.write("other.prm", ""), {"Case/Name=mine", "Output/Directory=elsewhere/run"});
  EXPECT_EQ(parameters.name, "mine");
  EXPECT_EQ(parameters.run_directory(), "elsewhere/run");
}

TEST(CaseParameters, TimesThatCannotBeAreRefused)
{
  const ScratchFolder scratch;
  const std::string   file = scratch.write("case.prm", "");
  for (const char *entry :
       {"Time/End time=0", "Time/Step scale=1.5", "Time/Step scale=0", "Output/Console interval=0", "Time/Threads=-1"})
    EXPECT_THROW(CaseParameters().read(file, {entry}), birdstrike::InputError) << entry;
}

TEST(CaseParameters, EveryShippedFileIsRead)
{
  const ScratchFolder scratch;
  unsigned int        n_files = 0;
  for (const auto &entry : std::filesystem::directory_iterator(BIRDSTRIKE_SOURCE_DIR "/prm"))
    if (entry.path().extension() == ".prm")
      {
        ++n_files;
        CaseParameters parameters, again;
        EXPECT_NO_THROW(parameters.read(entry.path().string()));
        EXPECT_NO_THROW(again.read(scratch.write("parameters.prm", parameters.file.as_prm()))) << entry.path();
        EXPECT_EQ(again.file.as_prm(), parameters.file.as_prm()) << entry.path();
      }
  EXPECT_GE(n_files, 1u) << "no parameter files in " BIRDSTRIKE_SOURCE_DIR "/prm";
}

TEST(CaseParameters, ThePrintedFileHasTheValuesOfTheTableAndGivesTheSameMetal)
{
  const ScratchFolder            scratch;
  const std::vector<std::string> sections{
    "Blade/Material/Name=Al 2024 Johnson-Cook", "Blade/Material/Hardening modulus=7e8",
    "Blade/Material/Failure=Johnson-Cook",      "Blade/Section 1/Material ids=1",
    "Blade/Section 2/Material ids=2",           "Blade/Section 2/Material/Name=Al 6061-T6"};
  CaseParameters first, again;
  first.read(scratch.write("case.prm", ""), sections);
  const std::string             printed = first.file.as_prm();
  const auto                    tree    = first.file.tree();
  const birdstrike::SectionPath here{"Blade", "Material"};
  EXPECT_EQ(tree.find(here, "Poisson's ratio")->value, "0.33");
  EXPECT_EQ(tree.find(here, "Damage D3")->value, "-1.5");
  EXPECT_EQ(tree.find(here, "Hardening")->value, "johnson-cook");
  EXPECT_EQ(tree.find(here, "Hardening modulus")->value, "7e8");
  EXPECT_EQ(tree.find(here, "Heat capacity")->value, "table") << "nothing heats: it plays no part";
  EXPECT_EQ(tree.find({"Blade", "Section 2", "Material"}, "Yield stress")->value, "2.76e+08");
  EXPECT_NE(printed.find("# Of the table: Al 2024 Johnson-Cook.\n    set Density = 2780\n"), std::string::npos);
  EXPECT_NE(printed.find("# Here Al 2024 Johnson-Cook, with its data from Blade/Material."), std::string::npos);

  again.read(scratch.write("parameters.prm", printed));
  EXPECT_EQ(again.blade.material, first.blade.material);
  EXPECT_EQ(again.blade.sections, first.blade.sections);
  EXPECT_EQ(birdstrike::first_difference(first, again, {}), "");
  CaseParameters typed; // 'table' typed is the value written
  typed.read(scratch.write("case.prm", ""), sections);
  EXPECT_EQ(birdstrike::first_difference(typed, again, {}), "");
}

TEST(CaseParameters, IncludedFilesAreAmongTheInputsWithTheirContents)
{
  const ScratchFolder scratch;
  const std::string   base = scratch.write("base.prm", "subsection Bird\n set Mass = 90 g\nend\n");
  const std::string   file = scratch.write("case.prm", "include base.prm\n");
  CaseParameters      first, second;
  first.read(file);
  EXPECT_EQ(first.bird.mass, 0.09);
  const auto before = birdstrike::list_input_files(first);
  ASSERT_EQ(before.size(), 1u);
  EXPECT_EQ(before[0].name, base);
  EXPECT_TRUE(before[0].is_included);
  scratch.write("base.prm", "subsection Bird\n set Mass = 91 g\nend\n");
  second.read(file);
  EXPECT_NE(birdstrike::list_input_files(second)[0].fingerprint, before[0].fingerprint);
}

// A slice that a blade at rest cannot cut refuses a strike. Statics and modes of the same file need no bird, and have
// the signs of one that flies this way.
TEST(CaseParameters, ABladeAloneAsksNothingOfItsBird)
{
  const ScratchFolder scratch;
  const std::string   head = "subsection Bird\n set Velocity = 10, 0, -100\n set Aim point = 0.2, 0, 0\n",
                    slice  = " subsection Slice\n  set Number of blades = 22\n end\nend\n";
  for (const std::string &rest : {slice, " set Particle spacing = 1\nend\n" + std::string(),
                                  " subsection Equation of state\n  set Type = porous\n end\n"
                                  " set Formulation = standard\n set Reconstruction = linear\nend\n" +
                                    std::string("subsection Bird 2\n set Enabled = true\n set Mass = 1e6\nend\n")})
    {
      const std::string file = scratch.write("case.prm", head + rest);
      CaseParameters    whole, alone;
      EXPECT_THROW(whole.read(file), birdstrike::InputError) << rest;
      EXPECT_EQ(alone.read_blade(file), "");
      EXPECT_TRUE(alone.birds().empty());
      ASSERT_TRUE(alone.blade.bird.has_value());
      EXPECT_EQ(alone.blade.bird->velocity, (std::array<double, 3>{{10., 0., -100.}}));
      EXPECT_EQ(alone.blade.bird->target, (std::array<double, 3>{{0.2, 0., 0.}}));
    }
}

TEST(CaseParameters, ABladeAloneSaysWhyItsStruckSideIsUnknown)
{
  const ScratchFolder scratch;
  CaseParameters      parameters;
  const std::string why = parameters.read_blade(scratch.write("case.prm", "subsection Bird\n set Speed = 100\nend\n"));
  EXPECT_NE(why.find("Angle to surface is missing"), std::string::npos) << why;
  EXPECT_FALSE(parameters.blade.bird.has_value());
  EXPECT_EQ(parameters.read_blade(scratch.write("none.prm", "subsection Bird\n set Enabled = false\nend\n")), "");
  EXPECT_THROW(parameters.read_blade(scratch.write("blade.prm", "subsection Blade\n subsection Mesh\n"
                                                                "  set Elements along span = 0\n end\nend\n")),
               birdstrike::InputError);
}
