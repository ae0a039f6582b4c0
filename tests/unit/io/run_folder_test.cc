#include <birdstrike/core/errors.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/io/run_folder.h>

#include <gtest/gtest.h>

#include "scratch_folder.h"

using birdstrike::InputError;
using birdstrike::RunFolder;
namespace fs = std::filesystem;

TEST(RunFolder, FinishedRunHasItsSummaryAndIsMarkedDone)
{
  const ScratchFolder scratch;
  const fs::path      folder = scratch.path() / "runs" / "frontal";
  {
    RunFolder run(folder);
    EXPECT_EQ(read_text(folder / ".birdstrike"), "running\n");
    run.write_text("original.prm", "# text\n");
    EXPECT_FALSE(fs::exists(folder / "summary.json"));
    run.finish("{}\n");
  }
  EXPECT_EQ(read_text(folder / "original.prm"), "# text\n");
  EXPECT_EQ(read_text(folder / "summary.json"), "{}\n");
  EXPECT_EQ(read_text(folder / ".birdstrike"), "done\n");
  EXPECT_FALSE(fs::exists(folder / "summary.json.part"));
}

TEST(RunFolder, FailedRunLeavesNoSummaryNotEvenThatOfAnEarlierRun)
{
  const ScratchFolder scratch;
  RunFolder(scratch.path()).finish("{}\n");
  ASSERT_TRUE(fs::exists(scratch.path() / "summary.json"));
  try
    {
      RunFolder run(scratch.path());
      throw birdstrike::NumericalFailure("density is NaN");
    }
  catch (const birdstrike::NumericalFailure &)
    {
    }
  EXPECT_FALSE(fs::exists(scratch.path() / "summary.json"));
  EXPECT_EQ(read_text(scratch.path() / ".birdstrike"), "failed: interrupted\n");
  {
    RunFolder run(scratch.path());
    run.fail("energy error 7 %\nmore lines");
  }
  EXPECT_EQ(read_text(scratch.path() / ".birdstrike"), "failed: energy error 7 %\n");
}

TEST(RunFolder, ReplacesAnEarlierRunButKeepsForeignFiles)
{
  const ScratchFolder scratch;
  {
    RunFolder run(scratch.path());
    fs::create_directories(scratch.path() / "fields");
    for (const char *name :
         {"history.csv", "results.h5", "blade.pvd", "fields/blade_0000.vtu", "notes.md", "plot.py", "fields/view.pvsm",
          "nodes.csv", "elements.csv", "gauges.csv", "sections.csv", "patches.csv", "blades.csv"})
      scratch.write(name, "old");
    run.finish("{}");
  }
  RunFolder run(scratch.path());
  for (const char *name : {"history.csv", "results.h5", "blade.pvd", "fields/blade_0000.vtu", "summary.json",
                           "nodes.csv", "elements.csv", "gauges.csv", "sections.csv", "patches.csv", "blades.csv"})
    EXPECT_FALSE(fs::exists(scratch.path() / name)) << name;
  for (const char *name : {"notes.md", "plot.py", "fields/view.pvsm"})
    EXPECT_EQ(read_text(scratch.path() / name), "old") << name;
}

TEST(RunFolder, RefusesFoldersOfOthers)
{
  const ScratchFolder scratch;
  const std::string   file = scratch.write("precious.txt", "text");
  EXPECT_THROW(RunFolder{scratch.path()}, InputError);
  EXPECT_THROW(RunFolder{file}, InputError);
  EXPECT_THROW(RunFolder{file + "/inner"}, InputError);
  EXPECT_EQ(read_text(file), "text");
  EXPECT_FALSE(fs::exists(scratch.path() / ".birdstrike"));
}

TEST(RunFolder, TwoRunsNeverShareAFolder)
{
  const ScratchFolder scratch;
  {
    RunFolder first(scratch.path());
    first.write_text("original.prm", "first");
    EXPECT_THROW(RunFolder{scratch.path()}, InputError);
    EXPECT_EQ(read_text(scratch.path() / "original.prm"), "first");
    EXPECT_EQ(read_text(scratch.path() / ".birdstrike"), "running\n");
  }
  EXPECT_NO_THROW(RunFolder{scratch.path()});
}
