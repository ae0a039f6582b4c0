#include "report/study/run_outcome.h"
#include "report/comparison/case_run.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/interrupted.h>
#include <birdstrike/io/checkpoint_file.h>
#include <birdstrike/report/text.h>
#include <birdstrike/time_control/end_reason.h>

#include <fmt/format.h>

#include <sstream>

namespace birdstrike
{
  namespace
  {
    std::string last_line(std::string text)
    {
      text.erase(text.find_last_not_of('\n') + 1);
      return text.substr(text.rfind('\n') + 1);
    }

    std::string describe_stop(const PointRun &run)
    {
      const RunRecord record = read_record(run.folder);
      return !record.is_complete() ? "stopped"
                                   : "stopped at " + format_quantity(record.summary().number("end/time"), "s") +
                                       (find_checkpoints(run.folder).empty() ? "" : ", will continue");
    }

    /// Its results are those of a part, and which depends on the machine, or on who stopped it.
    bool ended_by(const RunRecord &record, const EndReason reason)
    {
      return record.is_complete() && record.summary().text("end/reason") == end_reasons().name(reason);
    }
  } // namespace

  std::string find_refusal(const std::string &output)
  {
    std::istringstream in(output);
    std::string        refusal;
    bool               is_next = true;
    for (std::string line; std::getline(in, line);)
      if (line.starts_with("Warning:"))
        is_next = true;
      else if (is_next)
        {
          refusal = line;
          is_next = false;
        }
    return refusal;
  }

  void judge(PointRun &run, const ChildResult &result)
  {
    if (run.goes_on && result.exit_code == static_cast<int>(ExitCode::bad_input))
      {
        run.goes_on = false;
        run.state   = "run anew, for resume says: " + find_refusal(result.output);
        return;
      }
    const RunRecord record = read_record(run.folder);
    if (result.exit_code == 0 && (!record.is_complete() || ended_by(record, EndReason::signal)))
      {
        run.exit_code = static_cast<int>(ExitCode::internal_error); // of a launcher that only hands over
        run.state     = "its launcher is back with exit code 0, and there is no complete run";
        return;
      }
    const bool is_cut = result.exit_code == 0 && ended_by(record, EndReason::wall_time);
    run.exit_code     = is_cut ? Interrupted::exit_code : result.exit_code;
    run.is_done       = run.exit_code == 0;
    const auto marker = record.state();
    if (run.is_done)
      run.state = "done";
    else if (result.exit_code == static_cast<int>(ExitCode::numerical_failure))
      run.state = "lost: " + (marker.starts_with("failed: ") ? marker.substr(8) : marker);
    else if (result.exit_code == static_cast<int>(ExitCode::bad_input))
      run.state = "refused: " + find_refusal(result.output);
    else if (run.exit_code == Interrupted::exit_code)
      run.state = describe_stop(run);
    else
      run.state = fmt::format("ended with exit code {}: {}", result.exit_code, last_line(result.output));
  }
} // namespace birdstrike
