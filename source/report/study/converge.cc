#include "report/comparison/case_run.h"
#include "report/comparison/failed_runs.h"
#include "report/comparison/written_table.h"
#include "report/study/convergence_table.h"
#include "report/study/lattice_places.h"
#include "report/study/section_masses.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/io/case_parameters.h>

#include <fmt/format.h>
#include <spdlog/logger.h>

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    const ReportKind kind{"ladder", {"converge", "levels", "refinement"}, {"figures.gp"}};

    std::optional<OrderRange> read_orders(const ConvergeRequest &request)
    {
      const std::optional<OrderRange> orders = birdstrike::read_orders(request.order, "--order");
      if (orders && request.n_levels < fewest_of_an_interval)
        throw InputError(fmt::format("--order: {} levels leave no interval worth the name.\n  Allowed: {} to 12.",
                                     request.n_levels, fewest_of_an_interval));
      return orders;
    }
  } // namespace

  void converge(const ConvergeRequest &request)
  {
    if (!refinements().has(request.refinement))
      throw InputError("--vary " + request.refinement +
                       ": what is to be refined?\n  Allowed: " + refinements().selection() + ".");
    const std::optional<OrderRange> orders     = read_orders(request);
    const Refinement                refinement = refinements().at(request.refinement);
    const fs::path                  output =
      request.output.empty() ? fs::path("runs/converge") / fs::path(request.prm_file).stem() : fs::path(request.output);
    ReportFolder::require_usable(output, kind);
    CaseParameters parameters;
    parameters.read(request.prm_file, request.overrides);
    const std::vector<LadderLevel> levels = make_ladder(parameters, request);
    const LadderPlaces             places = make_lattice_places(parameters, request.n_places);
    const StudyPlan                plan   = make_ladder_plan(refinement, levels, places.size());

    RunOptions options{request.prm_file, request.overrides, request.n_jobs, "", "ladder", request.is_forced};
    auto       runs = plan_runs(make_ladder_points(levels, places), output, options);
    log().info("{} levels{}, {} of them are there", levels.size(),
               places.size() > 1 ? fmt::format(" at {} places, {} runs", places.size(), runs.size()) : "",
               std::ranges::count_if(runs, &PointRun::is_done));
    if (!request.is_forced)
      refuse_loss_of(find_lost_points(output / "levels.csv", plan, runs), output, kind,
                     "the same ladder again, or with more levels");
    const ReportFolder folder(output, kind, !request.is_forced);
    run_points(runs, options);
    folder.drop_results();

    const StudyTable       table(plan, runs);
    const ConvergenceTable convergence(refinement, levels, places.size(), table, orders);
    folder.write_text("levels.csv", table.as_csv());
    folder.write_text("converge.csv", convergence.as_csv());
    if (const Figure figure = convergence.make_figure(); figure.has_lines())
      {
        folder.write_text("figures.gp", script_of({figure}));
        folder.write_text(figure.stem + ".csv", data_of(figure));
        draw_figures(folder);
      }
    std::vector<fs::path> done;
    for (const PointRun &run : runs)
      if (run.is_done)
        done.push_back(run.folder);
    log().info("\n{}{}{}{}", convergence.as_text(), describe_rounded_meshes(levels), describe_changing_sections(done),
               table.warnings_as_text());
    for (const PointRun &run : runs)
      if (!run.is_done)
        log().info("No value of {}: {}", run.point.name, run.state);
    log().info("Ladder in {}", folder.path().string());
    FailedRuns failed;
    for (const PointRun &run : runs)
      failed.add(run.point.name, run.exit_code);
    failed.raise(places.size() > 1 ? "runs" : "levels");
  }
} // namespace birdstrike
