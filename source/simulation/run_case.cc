#include "simulation/bird_strike.h"
#include "simulation/case_warnings.h"
#include "simulation/checkpoints.h"
#include "simulation/explain.h"
#include "simulation/read_case.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/interrupted.h>
#include <birdstrike/core/log.h>
#include <birdstrike/core/program.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/run_folder.h>
#include <birdstrike/report/summary.h>
#include <birdstrike/report/text.h>

#include <spdlog/logger.h>

#include <csignal>

/// A run from its first step, and one that goes on from a checkpoint.
namespace birdstrike
{
  namespace
  {
    /// What a run that goes on may change: how long it goes and what it tells, not what it computes.
    const EntryNames may_change{"Time/End time",
                                "Time/Threads",
                                "Time/Maximum wall time",
                                "Time/Energy error limit",
                                "Time/Stop at tip peak",
                                "Time/Tip peak wait",
                                "Case/Description",
                                "Output/Directory",
                                "Output/History interval",
                                "Output/Field interval",
                                "Output/Console interval",
                                "Output/Flush interval",
                                "Output/Checkpoint/Step interval",
                                "Output/Checkpoint/Time interval",
                                "Output/Checkpoint/Wall interval",
                                "Output/Checkpoint/At the end",
                                "Output/Checkpoint/Keep"};

    void stop_on_signal(int)
    {
      BirdStrike::request_stop();
    }

    void write_on_signal(int)
    {
      Checkpoints::request();
    }

    /// From the moment that there is a folder on, a run that is stopped ends in order.
    void listen_to_signals()
    {
      BirdStrike::forget_stop_requests();
      for (const int stop : {SIGINT, SIGTERM, SIGHUP})
        std::signal(stop, stop_on_signal);
      std::signal(SIGUSR1, write_on_signal);
      std::signal(SIGPIPE, SIG_IGN); // who reads the screen may leave: the files go on
    }

    std::string program()
    {
      return program_identity().version + " " + program_identity().build;
    }

    Warnings find_all_warnings(Warnings of_inputs, const CaseParameters &parameters, const Scene &scene)
    {
      const Warnings of_scene = find_scene_warnings(parameters, scene);
      show(of_scene);
      of_inputs.insert(of_inputs.end(), of_scene.begin(), of_scene.end());
      return of_inputs;
    }

    /// To its end, and its results into the folder.
    void finish_run(BirdStrike &strike, Checkpoints &checkpoints, RunFolder &folder,
                    const std::vector<InputFile> &inputs)
    {
      try
        {
          strike.run([&](const bool is_over) { checkpoints.write_when_due(strike, is_over); });
          log().info("{}", strike.closing_report());
          Summary summary = strike.compute_summary();
          summary.set_inputs(inputs);
          show(summary.warnings()); // those of the beginning once more: they are far up by now
          folder.finish(to_text(summary));
        }
      catch (const NumericalFailure &error)
        {
          folder.fail(error.what());
          if (checkpoints.last().empty())
            throw;
          throw NumericalFailure(std::string(error.what()) + "\nLast checkpoint: " + checkpoints.last() + ".");
        }
      catch (const std::exception &error)
        {
          folder.fail(error.what());
          throw;
        }
      log().info("Results in {}", folder.path().string());
      if (strike.is_interrupted())
        throw Interrupted("Interrupted by a signal before Time/End time; what stands in the folder goes as far as it "
                          "came.\nGo on with: birdstrike resume " +
                          folder.path().string());
    }

    /// The newest checkpoint that can be read.
    Checkpoint read_newest(const std::filesystem::path &run)
    {
      for (const auto &file : find_checkpoints(run))
        try
          {
            Checkpoint checkpoint = read_checkpoint(file);
            log().info("Going on from {} at t = {}, step {}.", file.string(), format_quantity(checkpoint.time, "s"),
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
        throw InputError(entry + " is another one than when the run began.\n  A run that goes on may change Time/End "
                                 "time, Threads, Maximum wall time, Energy error limit, Stop at tip peak, and "
                                 "intervals of Output.\n  Action: run the changed case anew.");
      const std::vector<InputFile> inputs = list_input_files(now);
      for (const InputFile &input : checkpoint.inputs)
        if (std::ranges::find(inputs, input) == inputs.end())
          throw InputError("The file '" + input.name +
                           "' is not what it was when the run began.\n  Action: put it back, or run the case anew.");
    }
  } // namespace

  void run_case(const CaseRequest &request)
  {
    CaseParameters parameters;
    const Warnings of_inputs = read_case(parameters, request);
    if (!request.is_forced && holds_finished_run(parameters.run_directory()))
      throw InputError("The folder '" + parameters.run_directory() +
                       "' holds a finished run.\n  Action: --output DIR for another folder, or --force to replace it.");
    const auto inputs = list_input_files(parameters);
    Scene      scene(parameters); // refuses a bad case before a folder is touched
    const auto forecast = explain(parameters, scene);

    listen_to_signals();
    RunFolder folder(parameters.run_directory());
    log_to_file(folder.file("log.txt").string());
    folder.write_text("original.prm", parameters.file.original());
    folder.write_text("parameters.prm", parameters.file.as_prm());
    log().info("{}", forecast);
    const Warnings warnings = find_all_warnings(of_inputs, parameters, scene);
    BirdStrike     strike(parameters, scene, folder.path(), warnings);
    Checkpoints    checkpoints(parameters.output.checkpoints, folder.path(),
                               {parameters.file.as_prm(), inputs, program(), 0., 0, {}}, strike);
    finish_run(strike, checkpoints, folder, inputs);
  }

  void resume_run(const ResumeRequest &request)
  {
    RunFolder folder = RunFolder::of_resumed_run(request.run);
    log_to_file(folder.file("log.txt").string(), true);
    listen_to_signals();
    const Checkpoint checkpoint = read_newest(folder.path());
    folder.write_text("parameters.prm", checkpoint.parameters); // the truth, whatever has become of the file
    CaseParameters then, now;
    const auto     prm = folder.file("parameters.prm").string(), here = "Output/Directory=" + request.run;
    then.read(prm, {here});
    std::vector<std::string> overrides = request.overrides;
    overrides.push_back(here);
    const Warnings of_inputs = read_case(now, {prm, overrides, ""});
    require_the_same_case(checkpoint, then, now);
    if (now.time.end_time <= checkpoint.time * (1. + 1e-12))
      throw InputError("The run has reached its end, t = " + format_quantity(checkpoint.time, "s") +
                       ".\n  Action: give a later one, --set \"Time/End time=...\".");
    if (checkpoint.program != program())
      log().warn("The checkpoint was written by another build of the program ({}, this is {}): last digits may differ.",
                 checkpoint.program, program());
    folder.write_text("parameters.prm", now.file.as_prm());

    Scene          scene(now);
    const Warnings warnings = find_all_warnings(of_inputs, now, scene);
    BirdStrike     strike(now, scene, folder.path(), warnings);
    Archive        archive = Archive::reading(checkpoint.state);
    strike.archive(archive);
    archive.finish();
    Checkpoints checkpoints(now.output.checkpoints, folder.path(),
                            {now.file.as_prm(), checkpoint.inputs, program(), 0., 0, {}}, strike);
    finish_run(strike, checkpoints, folder, checkpoint.inputs);
  }
} // namespace birdstrike
