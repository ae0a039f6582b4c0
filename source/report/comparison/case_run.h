#pragma once

#include "report/comparison/run_record.h"
#include <birdstrike/io/report_folder.h>

#include <filesystem>
#include <string>
#include <vector>

/// What reports on several cases share: every case runs in a process of its own, and what it has left is read back.
namespace birdstrike
{
  /// The arguments by which the program runs a case into a folder, its own name first. What is there is replaced,
  /// checkpoints too.
  std::vector<std::string> run_arguments(const std::string &prm_file, const std::vector<std::string> &overrides,
                                         const std::filesystem::path &folder);

  /// The same for a verb that only looks.
  std::vector<std::string> case_arguments(const std::string &verb, const std::string &prm_file,
                                          const std::vector<std::string> &overrides,
                                          const std::filesystem::path    &folder);

  /// Throws Interrupted with `text` unless the signal is 0: every command that is stopped has the same exit code.
  void end_if_stopped(int signal, const std::string &text);

  /// A record that cannot be read is a loss of its own case only: it is returned as unreadable.
  RunRecord read_record(const std::filesystem::path &folder);

  /// Lets gnuplot draw figures.gp; says what to do where it is not installed.
  void draw_figures(const ReportFolder &folder);
} // namespace birdstrike
