#include "report/comparison/case_run.h"
#include "report/comparison/comparison_figures.h"
#include "report/comparison/failed_runs.h"
#include "report/comparison/written_table.h"
#include "report/study/study_figures.h"
#include "report/study/study_table.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/whole_file.h>
#include <birdstrike/report/study.h>

#include <fmt/format.h>
#include <spdlog/logger.h>

#include <algorithm>
#include <fstream>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    const ReportKind kind{
      "study",
      {"study", "responses", "maps", "tip_deflection", "contact", "energies", "root_moment", "root_stress", "profiles"},
      {"study.h5", "figures.gp"}};

    /// Of the command line, or else of the file's section Study.
    StudyPlan read_plan(const StudyRequest &request)
    {
      if (!request.vary.empty())
        return read_study_plan(request.vary, request.are_pairs);
      CaseParameters parameters;
      parameters.read(request.prm_file, request.overrides);
      const StudyParameters &study = parameters.study;
      return read_study_plan(study.given(), study.are_pairs || request.are_pairs);
    }

    /// Curves in time and profiles of all points in one picture, while they and their legend leave room for it.
    std::vector<Figure> make_overlays(const std::vector<PointRun> &runs)
    {
      constexpr std::size_t    most = 8;
      std::vector<ComparedRun> records;
      for (const PointRun &run : runs)
        if (run.is_done && runs.size() <= most)
          records.push_back({run.point.name, read_record(run.folder)});
      return make_comparison_figures(records);
    }

    void write(const ReportFolder &folder, const StudyPlan &plan, const std::vector<PointRun> &runs)
    {
      const StudyTable table(plan, runs);
      folder.drop_results();
      folder.write_text("study.csv", table.as_csv());
      table.write_hdf5(folder.file("study.h5"));
      auto figures = make_study_figures(plan, runs, table);
      for (Figure &overlay : make_overlays(runs))
        figures.push_back(std::move(overlay));
      folder.write_text("figures.gp", script_of(figures));
      for (const Figure &figure : figures)
        folder.write_text(figure.stem + ".csv", data_of(figure));
      log().info("\n{}", table.as_text());
      if (!figures.empty())
        draw_figures(folder);
      log().info("Study in {}", folder.path().string());
    }

    /// Over a list of before, or an empty file: the case itself is easily named by mistake.
    void require_no_other_file(const std::string &file)
    {
      std::ifstream in(file);
      bool          is_list = !fs::is_directory(file);
      for (std::string line; is_list && std::getline(in, line);)
        is_list = line.starts_with("cd ") && line.find(" && ") != std::string::npos; // as make_task_list writes them
      if (!is_list)
        throw InputError("--task-list " + file +
                         ": the file there is no list of tasks.\n  Action: give the list a name of its own.");
    }

    void write_task_list(const std::string &file, const std::vector<PointRun> &runs, const RunOptions &options)
    {
      const std::string tasks = make_task_list(runs, options);
      write_whole_file(file, {tasks});
      const auto        n_tasks = std::ranges::count(tasks, '\n');
      const std::string collected =
        "The same command without --task-list, but with --collect, makes the table of the points that have been run.";
      if (n_tasks == 0)
        return log().info("{} is empty: no point is left to run. {}", file, collected);
      const std::string name = quote_for_shell(file);
      log().info("{}: {} lines, one a point. GNU parallel: parallel < {}. Slurm: an array 1-{}, each task\n"
                 "  bash -c \"$(sed -n \"${{SLURM_ARRAY_TASK_ID}}p\" {})\"\n{}",
                 file, n_tasks, name, n_tasks, name, collected);
    }
  } // namespace

  void run_study(const StudyRequest &request)
  {
    const fs::path output =
      request.output.empty() ? fs::path("runs/study") / fs::path(request.prm_file).stem() : fs::path(request.output);
    ReportFolder::require_usable(output, kind);
    if (!request.task_list.empty())
      require_no_other_file(request.task_list);
    const StudyPlan plan   = read_plan(request);
    const auto      points = make_points(plan);
    RunOptions      options{request.prm_file, request.overrides, request.n_jobs, request.launcher};
    options.may_lose      = request.is_forced || request.only_collects;
    auto       runs       = plan_runs(points, output, options);
    const auto n_done     = std::ranges::count_if(runs, [](const PointRun &run) { return run.is_done; });
    const auto n_to_go_on = std::ranges::count_if(runs, [](const PointRun &run) { return run.goes_on; });
    log().info("{} points, {} of them are there{}", runs.size(), n_done,
               n_to_go_on > 0 ? fmt::format(", {} will continue from a checkpoint", n_to_go_on) : "");
    const bool makes_table = request.task_list.empty();
    if (makes_table && !request.is_forced)
      refuse_loss_of(find_lost_points(output / "study.csv", plan, runs), output, kind,
                     "the same study again, or with more values");
    const ReportFolder folder(output, kind, !makes_table || !request.is_forced);
    if (!makes_table)
      return write_task_list(request.task_list, runs, options);
    if (!request.only_collects)
      run_points(runs, options);
    write(folder, plan, runs);
    FailedRuns failed;
    for (const PointRun &run : runs)
      failed.add(run.point.name, run.exit_code);
    failed.raise("points");
  }
} // namespace birdstrike
