#include "report/comparison/written_table.h"
#include "report/target_error/climber.h"
#include <birdstrike/core/log.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/io/report_folder.h>
#include <birdstrike/report/text.h>

#include <spdlog/logger.h>

#include <chrono>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    const ReportKind kind{"target", {"target"}, {"target.json"}};
  } // namespace

  void run_to_target_error(const TargetRequest &request, const RunTimeForecast &forecast)
  {
    using Clock          = std::chrono::steady_clock;
    const auto     begin = Clock::now();
    const fs::path output =
      request.output.empty() ? fs::path("runs/target") / fs::path(request.prm_file).stem() : fs::path(request.output);
    ReportFolder::require_usable(output, kind);
    Climber climber(request, forecast, output);
    log().info("{}", climber.describe_target());
    if (!request.is_forced)
      refuse_loss_of(climber.find_lost_tables(output / "target.csv"), output, kind,
                     "the same quantity again, with any error");
    const ReportFolder folder(output, kind);
    Climber::Answer    answer{};
    try
      {
        answer = climber.climb();
      }
    catch (const NumericalFailure &)
      {
        folder.write_text("target.csv", climber.runs().as_csv());
        log().info("\n{}", climber.runs().warnings_as_text());
        throw;
      }
    folder.write_text("target.csv", climber.runs().as_csv());
    folder.write_text("target.json", climber.as_json(answer));
    const std::chrono::duration<double> taken = Clock::now() - begin;
    log().info("\n{}\n  in {} altogether\n{}", climber.describe(answer), format_duration(taken.count()),
               climber.runs().warnings_as_text());
    climber.require_whole_error();
  }
} // namespace birdstrike
