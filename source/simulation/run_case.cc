#include "simulation/bird_strike.h"
#include "simulation/checkpoints.h"
#include "simulation/explain.h"
#include "simulation/read_case.h"
#include "simulation/run_size.h"
#include "simulation/warnings/case_warnings.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/interrupted.h>
#include <birdstrike/core/log.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/core/program.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/input_copies.h>
#include <birdstrike/io/output_entries.h>
#include <birdstrike/io/run_folder.h>
#include <birdstrike/report/failure_record.h>
#include <birdstrike/report/summary.h>
#include <birdstrike/report/text.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/logger.h>

#include <csignal>

/// A run from its first step, and one that goes on from a checkpoint.
namespace birdstrike
{
  namespace
  {
    /// What a run that goes on may change: how long it goes, what it tells and in which steps; not what it computes.
    const EntryNames may_change = output_entries_and(
      {"Time/End time", "Time/Threads", "Time/Force threads", "Time/Maximum wall time", "Time/Energy error limit",
       "Time/Stop at tip peak", "Time/Tip peak wait", "Time/Step scale", "Time/Bird step scale"});

    void stop_on_signal(int)
    {
      BirdStrike::request_stop();
    }

    void write_on_signal(int)
    {
      Checkpoints::request();
    }

    /// Signals that do not end a process, from its beginning.
    void survive_signals()
    {
      std::signal(SIGUSR1, write_on_signal);
      std::signal(SIGPIPE, SIG_IGN); // who reads the screen may leave: the files go on
    }

    /// From the moment that there is a folder on, a run that is stopped ends in order.
    void listen_to_signals()
    {
      BirdStrike::forget_stop_requests();
      for (const int stop : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(stop, stop_on_signal) == SIG_IGN) // nohup, or a shell's background: it stays ignored
          std::signal(stop, SIG_IGN);
    }

    std::string program()
    {
      return program_identity().version + " " + program_identity().build;
    }

    Warnings show_and_join(Warnings of_inputs, const Warnings &of_scene)
    {
      show(of_scene);
      of_inputs.insert(of_inputs.end(), of_scene.begin(), of_scene.end());
      return of_inputs;
    }

    /// Of birds that come from a position: where they aim and when they arrive.
    void write_what_follows(CaseParameters &parameters, const Scene &scene)
    {
      std::vector<std::string> entries;
      for (const Projectile &each : scene.birds)
        if (const BirdParameters &bird = each.parameters; !bird.position.empty() && each.contact)
          {
            entries.push_back(fmt::format("{}/Arrival time={}", bird.section, bird.arrival));
            entries.push_back(fmt::format("{}/Aim point={}", bird.section, fmt::join(bird.aim_point, ", ")));
          }
      parameters.file.set(entries);
    }

    void write_parameters(const InputCopies &copies, RunFolder &folder)
    {
      copies.write(folder.path());
      folder.write_text("original.prm", copies.original());
      folder.write_text("parameters.prm", copies.parameters());
    }

    /// A bad case is refused before a folder is touched; one that is lost on the way to its first step leaves a record.
    Scene make_scene(const CaseParameters &parameters, const InputCopies &copies)
    {
      try
        {
          return Scene(parameters);
        }
      catch (const NumericalFailure &failure)
        {
          RunFolder folder(parameters.run_directory());
          write_parameters(copies, folder);
          folder.fail(failure.what(), make_failure_record(failure.facts()));
          throw;
        }
    }

    /// The last line of what a lost run says.
    std::string describe_last_checkpoint(const Checkpoints &checkpoints, const RunFolder &folder,
                                         const TimeParameters &time)
    {
      if (checkpoints.last().empty())
        return "No checkpoint was written (Output/Checkpoint/Time interval writes them).";
      return fmt::format("Last good checkpoint: {}. Continue from it: birdstrike resume {}, in smaller steps with "
                         "--set \"Time/Step scale={:.2g}\"",
                         checkpoints.describe_last(), folder.path().string(), 0.5 * time.step_scale);
    }

    /// To its end, and its results into the folder.
    void finish_run(BirdStrike &strike, Checkpoints &checkpoints, RunFolder &folder, const CaseParameters &parameters,
                    const std::vector<InputFile> &inputs)
    {
      try
        {
          strike.run([&](const bool is_over) { checkpoints.write_when_due(strike, is_over); });
          Summary summary = strike.compute_summary();
          summary.set_inputs(inputs);
          show(summary.warnings()); // those of the beginning once more: they are far up by now
          const ToldText closing = strike.closing_report();
          tell(closing.brief, closing.whole);
          folder.finish(to_text(summary));
        }
      catch (NumericalFailure &failure)
        {
          failure.add_checkpoint(checkpoints.last(), describe_last_checkpoint(checkpoints, folder, parameters.time));
          folder.fail(failure.what(), make_failure_record(failure.facts()));
          throw;
        }
      catch (const std::exception &error)
        {
          folder.fail(error.what());
          throw;
        }
      const std::string results = folder.path().string();
      log().info("Results in {0}. Next: birdstrike compare {0} draws its curves", results);
      if (strike.is_interrupted())
        throw Interrupted("Interrupted by a signal before Time/End time. The results in the folder end there." +
                          std::string(checkpoints.last().empty()
                                        ? ""
                                        : "\nContinue with: birdstrike resume " + folder.path().string()));
    }

    /// Those whose entries are not compared: what included files say stands in parameters.prm.
    std::vector<InputFile> without_included(std::vector<InputFile> inputs)
    {
      std::erase_if(inputs, [](const InputFile &file) { return file.is_included; });
      return inputs;
    }

    /// The newest checkpoint that can be read.
    Checkpoint read_newest(const std::filesystem::path &run)
    {
      for (const auto &file : find_checkpoints(run))
        try
          {
            Checkpoint checkpoint = read_checkpoint(file);
            log().info("Continuing from {} at t = {}, step {}.", file.string(), format_quantity(checkpoint.time, "s"),
                       checkpoint.step);
            return checkpoint;
          }
        catch (const InputError &error)
          {
            log().warn("{}\nThe one before is taken.", error.what());
          }
      throw InputError("'" + run.string() +
                       "' holds no checkpoint that can be read.\n  Action: run the case again; Output/Checkpoint says "
                       "when checkpoints are written.");
    }

    void require_the_same_case(const Checkpoint &checkpoint, const CaseParameters &then, const CaseParameters &now)
    {
      if (const std::string entry = first_difference(then, now, may_change); !entry.empty())
        throw InputError(entry +
                         " has changed since the run began.\n  A run that continues may change Time/End time, Threads, "
                         "Maximum wall time, Energy error limit, Stop at tip peak, Tip peak wait, Step scale and Bird "
                         "step scale, and intervals of Output.\n  Action: run the changed case anew.");
      const std::vector<InputFile> inputs = list_input_files(now);
      for (const InputFile &input : checkpoint.inputs)
        if (std::ranges::find(inputs, input.fingerprint, &InputFile::fingerprint) == inputs.end())
          throw InputError("The file '" + input.name +
                           (inputs.size() < checkpoint.inputs.size()
                              ? "' is not there, neither in the run folder nor seen from the working directory"
                              : "' has changed since the run began") +
                           ".\n  Action: put it back, or run the case anew.");
    }

    /// Those that the checkpoint tells of, and those that it goes on with.
    std::vector<std::string> collect_changes(const Checkpoint &checkpoint, const TimeParameters &then,
                                             const TimeParameters &now)
    {
      std::vector<std::string> changes = checkpoint.changes;
      const std::string        at      = format_quantity(checkpoint.time, "s");
      const auto               add     = [&](const char *entry, const double before, const double after) {
        if (before != after && checkpoint.step > 0)
          changes.push_back(fmt::format("{} from {:g} to {:g} at {}", entry, before, after, at));
      };
      add("Time/Step scale", then.step_scale, now.step_scale);
      add("Time/Bird step scale", then.bird_step_scale, now.bird_step_scale);
      return changes;
    }
  } // namespace

  void run_case(const CaseRequest &request)
  {
    survive_signals();
    if (request.is_verbose)
      set_console_level("debug");
    CaseParameters parameters;
    const Warnings of_inputs = read_case(parameters, request);
    const auto     directory = parameters.run_directory();
    const bool     can_go_on = !find_checkpoints(directory).empty();
    if (!request.is_forced && (can_go_on || holds_finished_run(directory)))
      throw InputError("The folder '" + directory + "' holds a run.\n  Action: --output DIR for another folder, " +
                       (can_go_on ? "'birdstrike resume " + directory + "' to go on with it, " : "") +
                       "or --force to replace it.");
    const InputCopies copies(parameters);
    Scene             scene = make_scene(parameters, copies);
    write_what_follows(parameters, scene);
    require_bounded_run(parameters, scene);
    const auto     forecast = explain(parameters, scene);
    const Warnings of_scene = find_scene_warnings(parameters, scene);
    refuse_if_strict(of_scene, request);

    listen_to_signals();
    RunFolder folder(directory);
    log_to_file(folder.file("log.txt").string());
    write_parameters(copies, folder);
    tell(forecast.brief, forecast.whole);
    const Warnings warnings = show_and_join(of_inputs, of_scene);
    BirdStrike     strike(parameters, scene, folder.path(), warnings);
    Checkpoints    checkpoints(parameters.output.checkpoints, folder.path(),
                               {copies.parameters(), without_included(copies.inputs()), program(), 0., 0, {}}, strike);
    finish_run(strike, checkpoints, folder, parameters, copies.inputs());
  }

  void resume_run(const ResumeRequest &request)
  {
    survive_signals();
    if (request.is_verbose)
      set_console_level("debug");
    RunFolder folder = RunFolder::of_resumed_run(request.run);
    log_to_file(folder.file("log.txt").string(), true);
    Checkpoint        checkpoint = read_newest(folder.path());
    const std::string of_run     = "resumed.prm";     // in the folder from which its paths are meant
    folder.write_text(of_run, checkpoint.parameters); // whatever has become of the file beside
    CaseParameters then, now;
    const auto     prm = folder.file(of_run).string(), here = set_directory(request.run);
    then.read(prm, {here});
    std::vector<std::string> overrides = request.overrides;
    overrides.push_back(here);
    const Warnings of_inputs = read_case(now, {.prm_file = prm, .overrides = overrides, .output = ""});
    require_the_same_case(checkpoint, then, now);
    find_copies(checkpoint.inputs, folder.path(), now);
    if (now.time.end_time <= checkpoint.time * (1. + 1e-12))
      throw InputError("The run has reached its end, t = " + format_quantity(checkpoint.time, "s") +
                       ".\n  Action: give a later one, --set \"Time/End time=...\".");
    if (checkpoint.program != program())
      log().warn("The checkpoint was written by another build of the program ({}, this is {}): last digits may differ.",
                 checkpoint.program, program());

    Scene scene(now);
    require_bounded_run(now, scene);
    listen_to_signals();
    folder.go_on();
    folder.write_text("parameters.prm", parameters_seen_from(folder.path(), now));
    remove_later_checkpoints(folder.path(), checkpoint.step); // damaged, or they would have been taken
    Warnings   warnings = show_and_join(of_inputs, find_scene_warnings(now, scene));
    const auto changes  = collect_changes(checkpoint, then.time, now.time);
    if (!changes.empty())
      warnings.push_back({"run/other_steps", "The run has continued with other time steps than at its start: " +
                                               fmt::format("{}", fmt::join(changes, "; ")) +
                                               ". A new run of parameters.prm will differ by that."});
    BirdStrike strike(now, scene, folder.path(), warnings);
    Archive    archive = Archive::reading(checkpoint.state);
    strike.archive(archive);
    archive.finish();
    Checkpoints checkpoints(
      now.output.checkpoints, folder.path(),
      {parameters_seen_from(folder.path(), now), checkpoint.inputs, program(), 0., 0, {}, changes}, strike);
    finish_run(strike, checkpoints, folder, now, checkpoint.inputs);
  }
} // namespace birdstrike
