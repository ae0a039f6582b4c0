#include "compare_plan.h"

#include <birdstrike/core/child_process.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/io/comparison_figures.h>
#include <birdstrike/io/comparison_folder.h>
#include <birdstrike/io/comparison_table.h>

#include <spdlog/logger.h>

#include <algorithm>
#include <csignal>
#include <stdexcept>

namespace birdstrike
{
  namespace
  {
    std::vector<std::string> arguments_for(const char *verb, const PlannedCase &planned)
    {
      std::vector<std::string> arguments{path_of_this_program(), verb, planned.prm_file};
      for (const std::string &text : planned.overrides)
        arguments.insert(arguments.end(), {"--set", text});
      arguments.insert(arguments.end(), {"--output", planned.folder.string()});
      return arguments;
    }

    /// Ends this process as the signal would have ended it: whoever called the program sees why.
    void end_if_stopped(const ChildResult &result)
    {
      if (result.stopped_by == 0)
        return;
      log().info("The comparison was stopped. Cases that are complete will be reused.");
      std::signal(result.stopped_by, SIG_DFL);
      std::raise(result.stopped_by);
    }

    /// A case that cannot be run is refused before any other has taken its hours.
    void validate(const PlannedCase &planned)
    {
      const ChildResult result = run_child({arguments_for("validate", planned), "", true});
      end_if_stopped(result);
      const std::string said = result.output.substr(0, result.output.find_last_not_of('\n') + 1);
      if (result.exit_code == static_cast<int>(ExitCode::bad_input))
        throw InputError(said);
      if (result.exit_code != 0)
        throw std::runtime_error("'" + planned.name + "' could not be checked:\n" + said);
    }

    /// Returns the exit code of the run.
    int run(const PlannedCase &planned, const std::size_t number, const std::size_t n_to_run)
    {
      log().info("Case {} of {} to run: {}, into {}{}", number, n_to_run, planned.name, planned.folder.string(),
                 planned.why_run.empty() ? "" : " (" + planned.why_run + ")");
      std::filesystem::remove(planned.folder / "summary.json"); // of an earlier run: nobody takes it for this one's
      const ChildResult result = run_child({arguments_for("run", planned), "", false});
      end_if_stopped(result);
      if (result.exit_code == static_cast<int>(ExitCode::bad_input))
        throw InputError("'" + planned.name + "' was refused, as said above.");
      return result.exit_code;
    }

    void draw(const ComparisonFolder &folder)
    {
      const ChildResult result = run_child({{"gnuplot", "figures.gp"}, folder.path().string(), true});
      if (!result.was_found)
        log().info("The curves are not drawn, for gnuplot is not installed: apt-get install gnuplot-nox, then "
                   "(cd {} && gnuplot figures.gp).",
                   folder.path().string());
      else if (result.exit_code != 0)
        log().warn("gnuplot could not draw {}: {}", (folder.path() / "figures.gp").string(),
                   result.output.substr(0, 300));
    }

    std::string make_report(const ComparisonTable &table, const std::vector<Figure> &figures,
                            const std::vector<PlannedCase> &cases)
    {
      std::string text = "# Comparison\n\n" + table.as_markdown() + "\n";
      for (const PlannedCase &planned : cases)
        text += "- " + planned.name + ": run folder `" + planned.folder.string() + "`" +
                (planned.is_reused ? ", reused" : "") + "\n";
      text += "\n";
      for (const Figure &figure : figures)
        text += "![" + figure.stem + "](" + figure.stem + ".svg)\n";
      return text;
    }

    /// Profiles come from results.h5, which a case may have switched off.
    bool lacks_profiles(const std::vector<ComparedRun> &runs)
    {
      return std::any_of(runs.begin(), runs.end(), [](const ComparedRun &run) {
        return !run.record.column("tip_mid_chord").empty() && run.record.text("blade/kind") != "rigid" &&
               run.record.dataset("history/time").empty();
      });
    }

    void write(const CompareRequest &request, const std::vector<PlannedCase> &cases)
    {
      std::vector<ComparedRun> runs;
      for (const PlannedCase &planned : cases)
        runs.push_back({planned.name, RunRecord(planned.folder)});
      const ComparisonTable  table(runs);
      const auto             figures = make_comparison_figures(runs);
      const ComparisonFolder folder(request.output);
      folder.write_text("comparison.csv", table.as_csv());
      folder.write_text("comparison.md", make_report(table, figures, cases));
      folder.write_text("figures.gp", script_of(figures));
      for (const Figure &figure : figures)
        folder.write_text(figure.stem + ".csv", data_of(figure));
      log().info("\n{}", table.as_text());
      if (lacks_profiles(runs))
        log().info("A run without results.h5 is missing in the profiles: Output/HDF5 = true writes it.");
      draw(folder);
      log().info("Comparison in {}", folder.path().string());
    }
  } // namespace

  void compare_cases(const CompareRequest &request)
  {
    const std::vector<PlannedCase> cases    = plan_comparison(request);
    const auto                     is_ready = [](const PlannedCase &planned) { return planned.is_reused; };
    const auto n_to_run = cases.size() - static_cast<std::size_t>(std::count_if(cases.begin(), cases.end(), is_ready));
    for (const PlannedCase &planned : cases)
      if (planned.is_reused)
        log().info("{}: the run in {} is reused", planned.name, planned.folder.string());
      else
        validate(planned);

    ComparisonFolder(request.output); // takes it before hours of computing
    std::string lost;
    bool        is_numerical = true;
    std::size_t number       = 0;
    for (const PlannedCase &planned : cases)
      if (!planned.is_reused)
        if (const int code = run(planned, ++number, n_to_run); code != 0)
          {
            lost += (lost.empty() ? "'" : ", '") + planned.name + "' (exit code " + std::to_string(code) + ")";
            is_numerical = is_numerical && code == static_cast<int>(ExitCode::numerical_failure);
          }
    write(request, cases);
    if (lost.empty())
      return;
    if (is_numerical)
      throw NumericalFailure("Lost: " + lost + ". The table holds what the other cases came to.");
    throw std::runtime_error("a case ended as none should: " + lost + ".");
  }
} // namespace birdstrike
