#include "report/study/study_runs.h"
#include "report/comparison/case_run.h"
#include "report/comparison/resumable.h"
#include "report/comparison/run_reuse.h"
#include "report/study/run_outcome.h"
#include <birdstrike/core/child_process.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/interrupted.h>
#include <birdstrike/core/log.h>
#include <birdstrike/core/machine.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/checkpoint_file.h>
#include <birdstrike/report/text.h>
#include <birdstrike/time_control/end_reason.h>

#include <fmt/format.h>
#include <spdlog/logger.h>

#include <algorithm>
#include <chrono>
#include <sstream>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    std::string first_line(const std::string &text)
    {
      return text.substr(0, text.find('\n'));
    }

    std::vector<std::string> overrides_of(const StudyPoint &point, const RunOptions &options)
    {
      std::vector<std::string> all = options.overrides;
      all.insert(all.end(), point.overrides.begin(), point.overrides.end());
      return all;
    }

    void look_for_checkpoint(PointRun &run, const CaseParameters &parameters)
    {
      const auto time = find_resumable_time(run.folder, parameters);
      run.goes_on     = time.has_value();
      if (time)
        run.state = "stopped at " + format_quantity(*time, "s") + ", will continue";
    }

    /// Runs that would be lost.
    struct KeptRuns
    {
      fs::path    first;
      std::string why;
      std::size_t n = 0;

      void add(const fs::path &folder, const std::string &reason)
      {
        if (reason.empty() || n++ > 0)
          return;
        first = folder;
        why   = reason;
      }
    };

    void look_for_run(PointRun &run, const RunOptions &options, KeptRuns &kept)
    {
      CaseParameters parameters;
      parameters.read(options.prm_file, overrides_of(run.point, options));
      const fs::path plain = run.folder.parent_path() / make_folder_name(run.point.name); // of a smaller study
      FoundRun       found = find_run({run.folder, plain}, parameters);
      if (found.in_use)
        run.folder = found.folder;
      run.is_done = run.is_reused = found.in_use != nullptr;
      run.state                   = run.is_done ? "done" : "not run";
      if (!run.is_done)
        look_for_checkpoint(run, parameters);
      if (!run.is_done && !run.goes_on && !options.may_lose)
        kept.add(run.folder, reason_to_keep(run.folder, parameters));
    }

    /// The program's own file, for those who start it by another program.
    std::string program_file()
    {
      return fs::read_symlink(this_program).string();
    }

    std::vector<std::string> words_of(const std::string &text)
    {
      std::istringstream       in(text);
      std::vector<std::string> words;
      for (std::string word; in >> word;)
        words.push_back(word);
      return words;
    }

    ChildRequest make_request(const PointRun &run, const RunOptions &options)
    {
      std::vector<std::string> arguments =
        run.goes_on ? std::vector<std::string>{"birdstrike", "resume", run.folder.string()}
                    : run_arguments(options.prm_file, overrides_of(run.point, options), run.folder.string());
      if (options.launcher.empty())
        return {arguments, "", true, this_program};
      arguments.front()                 = program_file();
      std::vector<std::string> launched = words_of(options.launcher);
      launched.insert(launched.end(), arguments.begin(), arguments.end());
      return {launched, "", true};
    }

    bool is_to_run(const PointRun &run)
    {
      return !run.is_done && run.exit_code == 0;
    }

    /// What an earlier run has left goes first, lest it be taken for this one's.
    void clear(PointRun &run)
    {
      try
        {
          drop_results(run.folder);
        }
      catch (const InputError &error)
        {
          run.state     = "refused: " + first_line(error.what());
          run.exit_code = static_cast<int>(ExitCode::bad_input);
        }
    }

    std::size_t jobs_of(const RunOptions &options)
    {
      return std::min(options.n_jobs > 0 ? options.n_jobs : usable_cores(), most_children);
    }

    /// Runs that share the cores of this machine; those of a launcher have cores of their own.
    void warn_of_shared_cores(const std::size_t n_threads, const std::size_t n_points, const RunOptions &options)
    {
      const std::size_t n_jobs = std::min(jobs_of(options), n_points), n_cores = usable_cores();
      if (options.launcher.empty() && n_jobs * n_threads > n_cores)
        log().warn(
          "Warning: {} runs side by side with Time/Threads = {} share {} cores and take turns. Leave Time/Threads "
          "out, or give --jobs {}.",
          n_jobs, n_threads, n_cores, std::max<std::size_t>(n_cores / n_threads, 1));
    }

    /// Returns the signal that stopped it, or 0.
    int run_side_by_side(const std::vector<PointRun *> &started, const RunOptions &options)
    {
      using Clock = std::chrono::steady_clock;
      std::vector<ChildRequest> requests;
      for (const PointRun *run : started)
        requests.push_back(make_request(*run, options));
      const std::size_t n_jobs  = jobs_of(options);
      const auto        begin   = Clock::now();
      std::size_t       n_ended = 0;
      return run_children(requests, n_jobs, [&](const std::size_t k, const ChildResult &result) {
        judge(*started[k], result);
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        const auto   n_left  = static_cast<double>(requests.size() - ++n_ended);
        log().info(
          "{} of {}: {}: {}{}", n_ended, requests.size(), started[k]->point.name, started[k]->state,
          n_left > 0. ? ", about " + format_duration(seconds * n_left / static_cast<double>(n_ended)) + " to go" : "");
      });
    }
  } // namespace

  std::vector<PointRun> plan_runs(const std::vector<StudyPoint> &points, const fs::path &directory, RunOptions &options)
  {
    std::vector<PointRun> runs;
    std::string           refusal;
    KeptRuns              kept;
    bool                  is_first = true;
    for (const StudyPoint &point : points)
      {
        PointRun run{point, directory / point.folder, "", false, false, 0};
        try
          {
            if (is_first)
              {
                CaseParameters parameters;
                parameters.read(options.prm_file, overrides_of(point, options));
                if (!parameters.file.is_given("Time/Threads"))
                  options.overrides.emplace_back("Time/Threads=1");
                else
                  warn_of_shared_cores(parameters.time.n_threads(), points.size(), options);
                is_first = false;
              }
            look_for_run(run, options, kept);
          }
        catch (const InputError &error)
          {
            run.state     = "refused: " + first_line(error.what());
            run.exit_code = static_cast<int>(ExitCode::bad_input);
            if (refusal.empty())
              refusal = error.what();
          }
        runs.push_back(std::move(run));
      }
    if (std::ranges::all_of(runs, [](const PointRun &run) { return run.exit_code != 0; }))
      throw InputError(refusal);
    refuse_loss_of_runs(kept.first, kept.why, kept.n);
    return runs;
  }

  void run_points(std::vector<PointRun> &runs, const RunOptions &options)
  {
    std::vector<PointRun *> to_run;
    do // again for those whose checkpoints are refused
      {
        to_run.clear();
        for (PointRun &run : runs)
          {
            if (is_to_run(run) && !run.goes_on)
              clear(run);
            if (is_to_run(run))
              to_run.push_back(&run);
          }
        const int signal = run_side_by_side(to_run, options);
        end_if_stopped(
          signal, "The " + options.what +
                    " was stopped. Complete points will be reused; points with a checkpoint will continue from it.");
      }
    while (std::ranges::any_of(runs, is_to_run));
  }

  std::string quote_for_shell(const std::string &text)
  {
    if (!text.empty() && text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                                "_-+=.,/:@%") == std::string::npos)
      return text;
    std::string quoted = "'";
    for (const char letter : text)
      quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return quoted + "'";
  }

  std::string make_task_list(const std::vector<PointRun> &runs, const RunOptions &options)
  {
    const std::string here = quote_for_shell(fs::current_path().string());
    std::string       text;
    for (const PointRun &run : runs)
      if (is_to_run(run))
        {
          ChildRequest request = make_request(run, options);
          if (options.launcher.empty())
            request.arguments.front() = program_file();
          text += "cd " + here + " &&";
          for (const std::string &argument : request.arguments)
            text += " " + quote_for_shell(argument);
          text += "\n";
        }
    return text;
  }
} // namespace birdstrike
