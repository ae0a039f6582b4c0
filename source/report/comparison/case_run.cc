#include "report/comparison/case_run.h"
#include <birdstrike/core/child_process.h>
#include <birdstrike/core/interrupted.h>
#include <birdstrike/core/log.h>

#include <spdlog/logger.h>

#include <stdexcept>

namespace birdstrike
{
  std::vector<std::string> case_arguments(const std::string &verb, const std::string &prm_file,
                                          const std::vector<std::string> &overrides,
                                          const std::filesystem::path    &folder)
  {
    std::vector<std::string> arguments{"birdstrike", verb, prm_file};
    for (const std::string &text : overrides)
      arguments.insert(arguments.end(), {"--set", text});
    arguments.insert(arguments.end(), {"--output", folder.string()});
    return arguments;
  }

  std::vector<std::string> run_arguments(const std::string &prm_file, const std::vector<std::string> &overrides,
                                         const std::filesystem::path &folder)
  {
    std::vector<std::string> arguments = case_arguments("run", prm_file, overrides, folder);
    arguments.emplace_back("--force");
    return arguments;
  }

  void end_if_stopped(const int signal, const std::string &text)
  {
    if (signal != 0)
      throw Interrupted(text);
  }

  RunRecord read_record(const std::filesystem::path &folder)
  {
    try
      {
        RunRecord record(folder);
        record.dataset("history/time"); // raises if results.h5 is there and damaged
        return record;
      }
    catch (const std::runtime_error &error)
      {
        return RunRecord::unreadable(folder, error.what());
      }
  }

  void draw_figures(const ReportFolder &folder)
  {
    const auto result =
      run_child_if_found({{"gnuplot", "--default-settings", "figures.gp"}, folder.path().string(), true});
    if (result)
      end_if_stopped(result->stopped_by,
                     "Stopped before all figures were drawn. The tables are written; draw the rest: (cd " +
                       folder.path().string() + " && gnuplot figures.gp).");
    if (!result)
      log().info("The curves are not drawn, for gnuplot is not installed: apt-get install gnuplot-nox, then "
                 "(cd {} && gnuplot figures.gp).",
                 folder.path().string());
    else if (result->exit_code != 0)
      log().warn("gnuplot could not draw {}: {}", folder.file("figures.gp").string(), result->output.substr(0, 300));
  }
} // namespace birdstrike
