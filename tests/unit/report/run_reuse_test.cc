#include "report/comparison/run_record.h"
#include "report/comparison/run_reuse.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/program.h>

#include <gtest/gtest.h>

#include <cmath>

#include "../io/scratch_folder.h"
#include "recorded_run.h"

using namespace birdstrike;

namespace
{
  /// A case file, a run of it, and the question whether that run will do.
  class RunReuse : public ::testing::Test
  {
  protected:
    ScratchFolder               scratch;
    const std::string           prm    = scratch.write("plate.prm", "subsection Bird\n  set Mass = 0.1\nend\n");
    const std::filesystem::path folder = scratch.path() / "run";
    RecordedRun                 run;

    std::string reason(const std::vector<std::string> &overrides = {}) const
    {
      CaseParameters wanted;
      wanted.read(prm, overrides);
      return reason_not_to_reuse(folder, wanted);
    }

    void edit_summary(const std::string &from, const std::string &to) const
    {
      std::string text = read_text(folder / "summary.json");
      ASSERT_NE(text.find(from), std::string::npos);
      scratch.write("run/summary.json", text.replace(text.find(from), from.size(), to));
    }
  };
} // namespace

TEST_F(RunReuse, TheSameParametersWillDo)
{
  run.write(folder, prm);
  EXPECT_EQ(reason(), "");
  EXPECT_EQ(reason({"Output/Directory=elsewhere"}), "") << "where a run lies does not matter";
  EXPECT_EQ(reason({"Bird/Mass=1.0e-1"}), "") << "the same number in other letters";
}

TEST_F(RunReuse, EveryOtherEntryMatters)
{
  run.write(folder, prm);
  EXPECT_EQ(reason({"Bird/Mass=0.2"}), "Bird/Mass differs");
  EXPECT_EQ(reason({"Blade/Mesh/Elements along chord=9"}), "Blade/Mesh/Elements along chord differs");
  EXPECT_EQ(reason({"Time/Threads=2"}), "Time/Threads differs");
}

TEST_F(RunReuse, AnIncompleteRunWillNotDo)
{
  EXPECT_EQ(reason(), "there is no complete run");
  run.write(folder, prm);
  std::filesystem::remove(folder / "summary.json");
  EXPECT_EQ(reason(), "there is no complete run");
}

TEST_F(RunReuse, ARunThatWasEndedFromOutsideWillNotDo)
{
  run.reason = end_reasons().name(EndReason::signal);
  run.write(folder, prm);
  EXPECT_EQ(reason(), "a signal ended it");
  run.reason = end_reasons().name(EndReason::wall_time);
  run.write(folder, prm);
  EXPECT_EQ(reason(), "Time/Maximum wall time ended it, which depends on the machine");
}

TEST_F(RunReuse, AnotherProgramsRunWillNotDo)
{
  run.write(folder, prm);
  edit_summary('"' + program_identity().build + '"', "\"0123\"");
  EXPECT_EQ(reason(), "another build of the program made it");
  edit_summary('"' + program_identity().version + '"', "\"0.0.1\"");
  EXPECT_EQ(reason(), "another release of the program made it");
}

TEST_F(RunReuse, RunsFromBeforeTheProgramWasNamedWillNotDo)
{
  run.write(folder, prm);
  scratch.write("run/summary.json", "{\"case\": \"plate\"}\n");
  EXPECT_EQ(reason(), "another release of the program made it");
}

TEST_F(RunReuse, AMeshThatWasChangedSinceMatters)
{
  const std::string mesh    = scratch.write("plate.msh", "mesh");
  const std::string of_mesh = "Blade/Mesh/File=" + mesh, from_file = "Blade/Mesh/Generator=file";
  run.overrides = {from_file, of_mesh};
  run.write(folder, prm);
  EXPECT_EQ(reason({from_file, of_mesh}), "");
  const auto when = std::filesystem::last_write_time(mesh);
  scratch.write("plate.msh", "mend");
  std::filesystem::last_write_time(mesh, when); // as a copy that keeps times does
  EXPECT_EQ(reason({from_file, of_mesh}), "'" + mesh + "' has changed");
  scratch.write("plate.msh", "mesh");
  EXPECT_EQ(reason({from_file, of_mesh}), "") << "the contents count";
  std::filesystem::remove(mesh);
  EXPECT_EQ(reason({from_file, of_mesh}), "'" + mesh + "' has changed");
}

TEST_F(RunReuse, AnIncompleteFolderWillNotDo)
{
  run.write(folder, prm);
  scratch.write("run/.birdstrike", "running\n");
  EXPECT_EQ(reason(), "its state is 'running'");
  scratch.write("run/.birdstrike", "done\n");
  EXPECT_EQ(reason(), "");
  std::filesystem::remove(folder / "results.h5");
  EXPECT_EQ(reason(), "it has no results.h5");
  std::filesystem::remove(folder / "history.csv");
  EXPECT_EQ(reason(), "it has no history");
}

TEST_F(RunReuse, AFolderThatIsDamagedWillNotDo)
{
  run.write(folder, prm);
  scratch.write("run/results.h5", "no HDF5");
  EXPECT_EQ(reason(), "its files cannot be read");
  scratch.write("run/summary.json", "no JSON");
  EXPECT_EQ(reason(), "its files cannot be read");
}

TEST_F(RunReuse, NoRunTakesAFolderInUse)
{
  run.write(folder, prm);
  {
    const RunFolderInUse reader(folder), another(folder);
    EXPECT_FALSE(reader.is_of_a_running_run());
    EXPECT_FALSE(another.is_of_a_running_run());
    EXPECT_THROW(RunFolder{folder}, InputError);
    EXPECT_THROW(drop_results(folder), InputError);
    EXPECT_TRUE(std::filesystem::exists(folder / "summary.json"));
  }
  drop_results(folder);
  EXPECT_EQ(RunRecord(folder).state(), "failed: it never started");
  EXPECT_TRUE(RunRecord(folder).column("time").empty());
  EXPECT_TRUE(std::filesystem::exists(folder / "parameters.prm")) << "what the next run may be made of";
  const RunFolder writer(folder);
  EXPECT_TRUE(RunFolderInUse(folder).is_of_a_running_run());
  EXPECT_FALSE(std::filesystem::exists(folder / "summary.json"));
}

TEST_F(RunReuse, ParametersThatAreNoLongerKnownWillNotDo)
{
  run.write(folder, prm);
  scratch.write("run/parameters.prm", "subsection Bird\n  set Weight = 1\nend\n");
  EXPECT_EQ(reason(), "its parameters.prm cannot be read");
}

TEST_F(RunReuse, TheRecordHasWhatTheRunLeft)
{
  run.write(folder, prm);
  const RunRecord record(folder);
  EXPECT_TRUE(record.is_complete());
  EXPECT_EQ(record.state(), "done");
  EXPECT_EQ(record.summary().number("tip/peak"), 0.15);
  EXPECT_EQ(record.summary().number("contact/impulse/2"), -4.);
  EXPECT_TRUE(std::isnan(record.summary().number("tip/none")));
  EXPECT_EQ(record.summary().text("case"), "plate");
  EXPECT_EQ(record.column("time").size(), 2600u);
  EXPECT_EQ(record.column("time")[1], 10e-6);
  EXPECT_TRUE(record.column("none").empty());
  EXPECT_EQ(record.dataset("root_normal_stress_at_peak/values"), (std::vector<double>{1e8, 2e8, -1e8, -2e8}));
  EXPECT_TRUE(record.dataset("root_normal_stress_at_peak/none").empty());
  EXPECT_TRUE(record.dataset("none/values").empty());
}

TEST_F(RunReuse, TheRecordOfAKilledRunEndsWithItsLastWholeRow)
{
  std::filesystem::create_directories(folder);
  scratch.write("run/history.csv", "# 1: time [s]\n# 2: x [m]\ntime,x\n0,1\n1,2\n2,31");
  const RunRecord record(folder);
  EXPECT_FALSE(record.is_complete());
  EXPECT_EQ(record.column("x"), (std::vector<double>{1., 2.}));
  scratch.write("run/history.csv", "time,x\n0,1\n1\n2,3\n");
  EXPECT_THROW(RunRecord{folder}, std::runtime_error);
  scratch.write("run/history.csv", "");
  scratch.write("run/results.h5", "no HDF5");
  EXPECT_THROW(RunRecord(folder).dataset("a/b"), std::runtime_error);
}

// A run anew gives back what was stopped or damaged, and nothing else.
TEST_F(RunReuse, WhatARunAnewCannotGiveBackIsKept)
{
  const auto to_keep = [&](const std::vector<std::string> &overrides = {}) {
    CaseParameters wanted;
    wanted.read(prm, overrides);
    return reason_to_keep(folder, wanted);
  };
  EXPECT_EQ(to_keep(), "") << "there is nothing";
  run.write(folder, prm);
  EXPECT_EQ(to_keep(), "");
  EXPECT_EQ(to_keep({"Bird/Mass=0.2"}), "Bird/Mass differs");
  scratch.write("run/results.h5", "no HDF5");
  EXPECT_EQ(to_keep(), "") << "the same run, damaged";
  edit_summary('"' + program_identity().build + '"', "\"0123\"");
  EXPECT_EQ(to_keep(), "another build of the program made it");
  scratch.write("run/summary.json", "no JSON");
  EXPECT_EQ(to_keep(), "");
  EXPECT_EQ(to_keep({"Bird/Mass=0.2"}), "Bird/Mass differs") << "whatever its summary says";
  std::filesystem::remove(folder / "summary.json");
  EXPECT_EQ(to_keep({"Bird/Mass=0.2"}), "") << "neither results nor a checkpoint";
  run.reason = end_reasons().name(EndReason::signal);
  run.write(folder, prm);
  EXPECT_EQ(to_keep(), "") << "it was stopped";
  EXPECT_EQ(to_keep({"Bird/Mass=0.2"}), "Bird/Mass differs");
}

TEST_F(RunReuse, ALossOfRunsIsRefusedWithTheFirstOfThem)
{
  EXPECT_NO_THROW(refuse_loss_of_runs("", "", 0));
  try
    {
      refuse_loss_of_runs("runs/a", "Bird/Mass differs", 3);
      FAIL();
    }
  catch (const InputError &error)
    {
      for (const char *words : {"'runs/a'", "Bird/Mass differs", "2 folders more", "--force", "--output"})
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}
