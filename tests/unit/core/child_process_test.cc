#include <birdstrike/core/child_process.h>
#include <birdstrike/core/program.h>

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

using birdstrike::program_identity;
using birdstrike::run_child;

TEST(ChildProcess, TellsOutputAndExitCode)
{
  const auto result = run_child({{"sh", "-c", "echo out; echo err >&2; exit 3"}, "", true});
  EXPECT_TRUE(result.was_found);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.output, "out\nerr\n");
  EXPECT_EQ(result.stopped_by, 0);
}

TEST(ChildProcess, PassesArgumentsAsTheyAre)
{
  const auto result = run_child({{"printf", "%s|", "a b", "$HOME", "'q'", ""}, "", true});
  EXPECT_EQ(result.output, "a b|$HOME|'q'||");
}

TEST(ChildProcess, RunsInTheGivenFolder)
{
  EXPECT_EQ(run_child({{"pwd"}, "/", true}).output, "/\n");
}

TEST(ChildProcess, SaysThatAProgramIsMissing)
{
  EXPECT_FALSE(run_child({{"no-such-program-of-birdstrike"}, "", true}).was_found);
}

TEST(ChildProcess, NamesTheSignalThatEndedIt)
{
  EXPECT_EQ(run_child({{"sh", "-c", "kill -KILL $$"}, "", true}).exit_code, 128 + SIGKILL);
}

TEST(ChildProcess, HandsSignalsOnAndSaysSo)
{
  // The child asks its parent, this process, to terminate, and ends in its own way when that is handed on.
  const auto result =
    run_child({{"sh", "-c", "trap 'exit 7' TERM; kill -TERM $PPID; while :; do sleep 0.01; done"}, "", true});
  EXPECT_EQ(result.exit_code, 7);
  EXPECT_EQ(result.stopped_by, SIGTERM);
}

TEST(ChildProcess, TheChildIsNoRankOfItsParentsJob)
{
  ::setenv("PMI_RANK", "0", 1);
  ::setenv("BIRDSTRIKE_TEST_VARIABLE", "kept", 1);
  const auto result = run_child({{"sh", "-c", "echo ${PMI_RANK-none} ${BIRDSTRIKE_TEST_VARIABLE-none}"}, "", true});
  ::unsetenv("PMI_RANK");
  ::unsetenv("BIRDSTRIKE_TEST_VARIABLE");
  EXPECT_EQ(result.output, "none kept\n");
}

TEST(Program, KnowsItsReleaseAndItsBuild)
{
  EXPECT_EQ(program_identity().version.find_first_not_of("0123456789."), std::string::npos);
  EXPECT_FALSE(program_identity().version.empty());
  EXPECT_EQ(program_identity().build.size(), 16u);
  // as binutils read it
  const auto notes = run_child({{"readelf", "-n", birdstrike::path_of_this_program()}, "", true});
  ASSERT_TRUE(notes.was_found) << "readelf is of binutils, which linked this test";
  EXPECT_NE(notes.output.find("Build ID: " + program_identity().build), std::string::npos) << notes.output;
}
