#include "report/comparison/case_run.h"
#include "report/comparison/compare_plan.h"
#include "report/comparison/comparison_figures.h"
#include "report/comparison/comparison_table.h"
#include "report/comparison/failed_runs.h"
#include <birdstrike/core/child_process.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/report/text.h>

#include <spdlog/logger.h>

#include <algorithm>
#include <stdexcept>

namespace birdstrike
{
  namespace
  {
    constexpr auto stopped =
      "The comparison was stopped. Complete cases will be reused, and a case in progress will continue.";

    /// A case that cannot be run is refused before any other has taken its hours.
    void validate(const PlannedCase &planned)
    {
      const ChildResult result = run_child(
        {case_arguments("validate", planned.prm_file, planned.overrides, planned.folder), "", true, this_program});
      end_if_stopped(result.stopped_by, stopped);
      const std::string said = result.output.substr(0, result.output.find_last_not_of('\n') + 1);
      if (result.exit_code == static_cast<int>(ExitCode::bad_input))
        throw InputError(said);
      if (result.exit_code != 0)
        throw std::runtime_error("'" + planned.name + "' could not be checked:\n" + said);
    }

    int call(const std::vector<std::string> &arguments)
    {
      const ChildResult result = run_child({arguments, "", false, this_program});
      end_if_stopped(result.stopped_by, stopped);
      return result.exit_code;
    }

    /// What an earlier run has left goes first, lest it be taken for this one's.
    int run_anew(const PlannedCase &planned)
    {
      try
        {
          drop_results(planned.folder);
        }
      catch (const InputError &error)
        {
          log().error("{}", error.what());
          return static_cast<int>(ExitCode::bad_input);
        }
      return call(run_arguments(planned.prm_file, planned.overrides, planned.folder));
    }

    /// Returns the exit code of the run.
    int run(PlannedCase &planned, const std::size_t number, const std::size_t n_to_run)
    {
      constexpr int refused = static_cast<int>(ExitCode::bad_input);
      log().info("Case {} of {} to run: {}, into {}{}", number, n_to_run, planned.name, planned.folder.string(),
                 planned.goes_on_from      ? ", from its checkpoint at " + format_quantity(*planned.goes_on_from, "s")
                 : planned.why_run.empty() ? ""
                                           : " (" + planned.why_run + ")");
      int exit_code = planned.goes_on_from ? call({"birdstrike", "resume", planned.folder.string()}) : refused;
      if (planned.goes_on_from && exit_code == refused)
        log().info("{} is run anew, for it cannot be resumed.", planned.name);
      if (exit_code == refused)
        exit_code = run_anew(planned);
      planned.in_use = std::make_unique<RunFolderInUse>(planned.folder);
      return exit_code;
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
        return !run.record.column("tip_mid_chord").empty() &&
               run.record.summary().text("blade/kind") != blade_kinds().name(BladeKind::rigid) &&
               run.record.dataset("history/time").empty();
      });
    }

    void write(const ReportFolder &folder, const std::vector<PlannedCase> &cases)
    {
      std::vector<ComparedRun> runs;
      for (const PlannedCase &planned : cases)
        runs.push_back({planned.name, read_record(planned.folder)});
      const ComparisonTable table(runs);
      const auto            figures = make_comparison_figures(runs);
      folder.drop_results();
      folder.write_text("comparison.csv", table.as_csv());
      folder.write_text("comparison.md", make_report(table, figures, cases));
      folder.write_text("figures.gp", script_of(figures));
      for (const Figure &figure : figures)
        folder.write_text(figure.stem + ".csv", data_of(figure));
      log().info("\n{}", table.as_text());
      if (lacks_profiles(runs))
        log().info("A run without results.h5 is missing in the profiles: Output/HDF5 = true writes it.");
      draw_figures(folder);
      log().info("Comparison in {}", folder.path().string());
    }
  } // namespace

  void compare_cases(const CompareRequest &request)
  {
    std::vector<PlannedCase> cases    = plan_comparison(request);
    const auto               is_ready = [](const PlannedCase &planned) { return planned.is_reused; };
    const auto n_to_run = cases.size() - static_cast<std::size_t>(std::count_if(cases.begin(), cases.end(), is_ready));
    for (const PlannedCase &planned : cases)
      if (planned.is_reused)
        log().info("{}: the run in {} is reused", planned.name, planned.folder.string());
      else
        validate(planned);

    const ReportFolder folder(request.output, comparison_kind(), !request.is_forced); // taken before hours of computing
    FailedRuns         failed;
    std::size_t        number = 0;
    for (PlannedCase &planned : cases)
      if (!planned.is_reused)
        failed.add(planned.name, run(planned, ++number, n_to_run));
    write(folder, cases);
    failed.raise("cases");
  }
} // namespace birdstrike
