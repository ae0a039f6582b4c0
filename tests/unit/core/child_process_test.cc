#include <birdstrike/core/child_process.h>
#include <birdstrike/core/log.h>
#include <birdstrike/core/program.h>

#include <gtest/gtest.h>
#include <spdlog/logger.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <iostream>
#include <map>
#include <stdexcept>
#include <thread>
#include <vector>

#include "../io/scratch_folder.h"

using birdstrike::program_identity;
using birdstrike::run_child;
using birdstrike::run_child_if_found;
using birdstrike::run_children;

TEST(ChildProcess, TellsOutputAndExitCode)
{
  const auto result = run_child({{"sh", "-c", "echo out; echo err >&2; exit 3"}, "", true});
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
  EXPECT_FALSE(run_child_if_found({{"no-such-program-of-birdstrike"}, "", true}));
  EXPECT_THROW(run_child({{"no-such-program-of-birdstrike"}, "", true}), std::runtime_error);
}

TEST(ChildProcess, StartsTheRunningProgramAgain)
{
  const auto result = run_child({{"another name", "--gtest_list_tests"}, "", true, birdstrike::this_program});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.output.find("StartsTheRunningProgramAgain"), std::string::npos);
}

namespace
{
  std::string said_before; // by the parent: a program that is loaded again does not know it

  int tell(const int n, char **arguments)
  {
    for (int k = 0; k < n; ++k)
      std::printf("%s|", arguments[k]);
    std::printf("%s|", said_before.c_str());
    std::fflush(stdout);
    std::cerr << std::filesystem::current_path().string();
    birdstrike::log().info("|logged");
    if (n > 1 && std::string(arguments[1]) == "throw")
      throw std::runtime_error("thrown");
    return 5;
  }
} // namespace

TEST(ChildProcess, BeginsInACopyOfThisProcess)
{
  said_before = "here";
  birdstrike::begin_children_at(tell);
  std::printf("waits to be written ");
  const auto result = run_child({{"name", "a b"}, "/", true, birdstrike::this_program});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_EQ(result.output, "name|a b|here|/|logged\n"); // no colours
  EXPECT_EQ(run_child({{"name", "throw"}, "", true, birdstrike::this_program}).exit_code, 127);

  // several, of which one is another program
  std::map<std::size_t, int> codes;
  run_children({{{"one"}, "", true, birdstrike::this_program},
                {{"sh", "-c", "exit 7"}, "", true},
                {{"two"}, "", true, birdstrike::this_program}},
               2, [&](const std::size_t k, const birdstrike::ChildResult &ended) { codes[k] = ended.exit_code; });
  EXPECT_EQ(codes, (std::map<std::size_t, int>{{0, 5}, {1, 7}, {2, 5}}));

  // as a rank of a job it is loaded again
  ::setenv("PMI_RANK", "0", 1);
  const auto loaded = run_child({{"name", "--gtest_list_tests"}, "", true, birdstrike::this_program});
  ::unsetenv("PMI_RANK");
  EXPECT_NE(loaded.output.find("BeginsInACopyOfThisProcess"), std::string::npos);

  // so it is where there is another thread
  std::promise<void> end;
  std::thread        other([&] { end.get_future().wait(); });
  EXPECT_EQ(run_child({{"name", "--gtest_list_tests"}, "", true, birdstrike::this_program}).exit_code, 0);
  end.set_value();
  other.join();
  birdstrike::begin_children_at(nullptr);
}

TEST(ChildProcess, SignalsEndACopyAsTheyEndAnyProgram)
{
  birdstrike::begin_children_at([](int, char **) {
    ::kill(::getppid(), SIGTERM); // handed on to this child, in which it acts by default
    ::sleep(20);
    return 0;
  });
  const auto result = run_child({{"name"}, "", true, birdstrike::this_program});
  birdstrike::begin_children_at(nullptr);
  EXPECT_EQ(result.exit_code, 128 + SIGTERM);
  EXPECT_EQ(result.stopped_by, SIGTERM);
}

TEST(ChildProcess, NamesTheSignalThatEndedIt)
{
  EXPECT_EQ(run_child({{"sh", "-c", "kill -KILL $$"}, "", true}).exit_code, 128 + SIGKILL);
}

TEST(ChildProcess, HandsSignalsOnAndSaysSo)
{
  // The child asks its parent, this process, to terminate, and ends in its own way when that is handed on.
  const auto result =
    run_child({{"sh", "-c", "trap 'exit 7' TERM; kill -TERM $PPID; for i in $(seq 3000); do sleep 0.01; done; exit 8"},
               "",
               true});
  EXPECT_EQ(result.exit_code, 7);
  EXPECT_EQ(result.stopped_by, SIGTERM);
}

TEST(ChildProcess, RunsSeveralSideBySideAndTellsEachEnd)
{
  // Each but the last waits for the file of the next one: three at once end, two at once would wait for ever.
  const ScratchFolder scratch;
  const auto          wait_for = [](const char *file) {
    return std::string("for i in $(seq 1000); do [ -e ") + file + " ] && break; sleep 0.01; done; [ -e " + file + " ]";
  };
  std::vector<birdstrike::ChildRequest> requests{
    {{"sh", "-c", wait_for("b") + "; echo first $?"}, scratch.path().string(), true},
    {{"sh", "-c", wait_for("c") + "; echo second $?; touch b"}, scratch.path().string(), true},
    {{"sh", "-c", "touch c; exit 4"}, scratch.path().string(), true},
    {{"no-such-program-of-birdstrike"}, "", true}};
  std::map<std::size_t, birdstrike::ChildResult> results;
  EXPECT_EQ(run_children(requests, 3, [&](const std::size_t k, const auto &result) { results[k] = result; }), 0);
  ASSERT_EQ(results.size(), 4u);
  EXPECT_EQ(results[0].output, "first 0\n");
  EXPECT_EQ(results[1].output, "second 0\n");
  EXPECT_EQ(results[2].exit_code, 4);
  EXPECT_EQ(results[3].exit_code, 127);
  EXPECT_NE(results[3].output.find("no such program"), std::string::npos);
}

TEST(ChildProcess, StartsNoFurtherOneAfterASignal)
{
  const ScratchFolder scratch;
  const std::string   folder = scratch.path().string(), listens = "trap 'exit 7' TERM; ";
  const std::string   waits     = "for i in $(seq 3000); do sleep 0.01; done; exit 8";
  const std::string   is_first  = listens + "touch ready; " + waits;
  const std::string   signals   = "until [ -e ready ]; do sleep 0.01; done; kill -TERM $PPID; " + waits;
  const auto          in_folder = [&](const std::string &script) {
    return birdstrike::ChildRequest{{"sh", "-c", script}, folder, true};
  };
  const std::vector<birdstrike::ChildRequest> requests{in_folder(is_first), in_folder(listens + signals),
                                                       in_folder("exit 0")};
  std::map<std::size_t, int>                  codes;
  const auto on_end = [&](const std::size_t k, const auto &result) { codes[k] = result.exit_code; };
  EXPECT_EQ(run_children(requests, 2, on_end), SIGTERM);
  EXPECT_EQ(codes, (std::map<std::size_t, int>{{0, 7}, {1, 7}}));
}

// No child is left to wait for while one is still to be started.
TEST(ChildProcess, EndsWhenASignalEndsTheOnlyOne)
{
  std::vector<int> codes;
  const auto       on_end = [&](std::size_t, const auto &result) { codes.push_back(result.exit_code); };
  EXPECT_EQ(
    run_children({{{"sh", "-c", "kill -TERM $PPID; exec sleep 30"}, "", true}, {{"true"}, "", true}}, 1, on_end),
    SIGTERM);
  EXPECT_EQ(codes, std::vector<int>{128 + SIGTERM});
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
  const std::string file  = std::filesystem::read_symlink(birdstrike::this_program);
  const auto        notes = run_child({{"readelf", "-n", file}, "", true});
  EXPECT_NE(notes.output.find("Build ID: " + program_identity().build), std::string::npos) << notes.output;
}
