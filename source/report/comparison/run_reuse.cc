#include "report/comparison/run_reuse.h"
#include "report/comparison/run_record.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/program.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/checkpoint_file.h>
#include <birdstrike/io/input_files.h>
#include <birdstrike/report/summary.h>

#include <algorithm>
#include <stdexcept>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    /// The first file that is not what the run has read, or is missing on one side; empty if there is none.
    std::string changed_file(const RunRecord &run, const CaseParameters &wanted)
    {
      std::vector<InputFile> now = list_input_files(wanted);
      std::erase_if(now, [](const InputFile &file) { return file.is_included; }); // what they say has been compared
      for (std::size_t k = 0;; ++k)
        {
          const std::string key  = "inputs/" + std::to_string(k);
          InputFile         then = {run.summary().text(key + "/name"), run.summary().text(key + "/fingerprint")};
          if (run.summary().text(key + "/role") == "include") // these are the last ones
            then = {};
          if (k == now.size())
            return then.name;
          if (now[k].fingerprint != then.fingerprint) // wherever it lay
            return then.name.empty() ? now[k].name : then.name;
        }
    }

    std::string judge_program(const RunRecord &run)
    {
      if (run.summary().text("program/version") != program_identity().version)
        return "another release of the program made it";
      if (run.summary().text("program/build") != program_identity().build)
        return "another build of the program made it";
      return "";
    }

    bool has_other_steps(const RunRecord &run)
    {
      return std::ranges::any_of(run.summary().warnings(),
                                 [](const Warning &warning) { return warning.code == "run/other_steps"; });
    }

    constexpr auto of_other_steps = "it was resumed with other time steps than it began with";

    /// What a folder lacks or what it says against itself, whatever the parameters.
    std::string judge_folder(const RunRecord &run, const bool has_results)
    {
      if (!run.is_complete())
        return "there is no complete run";
      if (const std::string reason = judge_program(run); !reason.empty())
        return reason;
      const std::string ended = run.summary().text("end/reason");
      if (ended == end_reasons().name(EndReason::signal))
        return "a signal ended it";
      if (ended == end_reasons().name(EndReason::wall_time))
        return "Time/Maximum wall time ended it, which depends on the machine";
      if (has_other_steps(run))
        return of_other_steps;
      if (run.state() != "done")
        return "its state is '" + run.state() + "'";
      if (run.column("time").empty())
        return "it has no history";
      if (run.column("time").back() < run.summary().number("end/time"))
        return "its history.csv is cut off";
      if (has_results && run.dataset("history/time").empty())
        return "it has no results.h5";
      return "";
    }

    /// Files are judged by what the run says of their contents.
    EntryNames but_for_files(const CaseParameters &parameters)
    {
      EntryNames names = entries_that_may_differ();
      for (const std::string &name : file_entries(parameters))
        names.push_back(name);
      return names;
    }

    std::string judge_entries(const fs::path &folder, const CaseParameters &wanted)
    {
      CaseParameters made_from;
      try
        {
          made_from.read((folder / "parameters.prm").string());
        }
      catch (const InputError &)
        {
          return "its parameters.prm cannot be read";
        }
      const std::string entry = first_difference(wanted, made_from, but_for_files(wanted));
      return entry.empty() ? "" : entry + " differs";
    }

    std::string judge_files(const RunRecord &run, const CaseParameters &wanted)
    {
      const std::string file = changed_file(run, wanted);
      return file.empty() ? "" : "'" + file + "' has changed";
    }

    std::string judge(const RunRecord &run, const CaseParameters &wanted)
    {
      std::string reason = judge_folder(run, wanted.output.hdf5);
      if (reason.empty())
        reason = judge_entries(run.folder(), wanted);
      return reason.empty() ? judge_files(run, wanted) : reason;
    }

    bool has_come_to_its_end(const RunRecord &run)
    {
      const std::string ended = run.summary().text("end/reason");
      return run.is_complete() && run.state() == "done" && ended != end_reasons().name(EndReason::signal) &&
             ended != end_reasons().name(EndReason::wall_time);
    }
  } // namespace

  std::vector<std::string> entries_that_may_differ()
  {
    std::vector<std::string> names = study_entries();
    names.insert(names.end(), {"Output/Directory", "Output/Copy inputs"});
    return names;
  }

  std::string reason_not_to_reuse(const fs::path &folder, const CaseParameters &wanted)
  {
    try
      {
        return judge(RunRecord(folder), wanted);
      }
    catch (const std::runtime_error &) // the record's: there is a file that is none of a run's
      {
        return "its files cannot be read";
      }
  }

  std::string reason_to_keep(const fs::path &folder, const CaseParameters &wanted)
  {
    if (!fs::exists(folder / "parameters.prm") ||
        (!fs::exists(folder / "summary.json") && find_checkpoints(folder).empty()))
      return "";
    if (const std::string reason = judge_entries(folder, wanted); !reason.empty())
      return reason;
    try
      {
        const RunRecord run(folder);
        if (!has_come_to_its_end(run))
          return "";
        if (const std::string reason = judge_files(run, wanted); !reason.empty())
          return reason;
        return has_other_steps(run) ? of_other_steps : judge_program(run);
      }
    catch (const std::runtime_error &) // damaged
      {
        return "";
      }
  }

  void refuse_loss_of_runs(const fs::path &folder, const std::string &why, const std::size_t n)
  {
    if (n > 0)
      throw InputError("The folder '" + folder.string() + "' holds a run that would be lost, for " + why + ".\n" +
                       (n > 1 ? "  So do " + std::to_string(n - 1) + " folders more.\n" : "") +
                       "  Action: --output DIR for another folder, or --force to replace what is there.");
  }

  FoundRun find_run(const std::vector<fs::path> &folders, const CaseParameters &wanted)
  {
    FoundRun found;
    for (const fs::path &folder : folders)
      {
        if (!fs::exists(folder / "summary.json"))
          continue;
        auto              in_use = std::make_unique<RunFolderInUse>(folder);
        const std::string reason =
          in_use->is_of_a_running_run() ? "a run is writing into it" : reason_not_to_reuse(folder, wanted);
        if (reason.empty())
          return {folder, std::move(in_use), ""};
        if (found.why_not.empty())
          found.why_not = "the one in " + folder.string() + " is not reused because " + reason;
      }
    return found;
  }
} // namespace birdstrike
