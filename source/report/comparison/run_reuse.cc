#include "report/comparison/run_reuse.h"
#include "report/comparison/run_record.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/program.h>
#include <birdstrike/io/case_parameters.h>
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
          if (now[k] != then)
            return then.name.empty() ? now[k].name : then.name;
        }
    }

    /// What a folder lacks or what it says against itself, whatever the parameters.
    std::string judge_folder(const RunRecord &run, const bool has_results)
    {
      if (!run.is_complete())
        return "there is no complete run";
      if (run.summary().text("program/version") != program_identity().version)
        return "another release of the program made it";
      if (run.summary().text("program/build") != program_identity().build)
        return "another build of the program made it";
      const std::string ended = run.summary().text("end/reason");
      if (ended == end_reasons().name(EndReason::signal))
        return "a signal ended it";
      if (ended == end_reasons().name(EndReason::wall_time))
        return "Time/Maximum wall time ended it, which depends on the machine";
      if (std::ranges::any_of(run.summary().warnings(),
                              [](const Warning &warning) { return warning.code == "run/other_steps"; }))
        return "it was resumed with other time steps than it began with";
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

    std::string judge(const RunRecord &run, const CaseParameters &wanted)
    {
      if (const std::string reason = judge_folder(run, wanted.output.hdf5); !reason.empty())
        return reason;
      CaseParameters made_from;
      try
        {
          made_from.read((run.folder() / "parameters.prm").string());
        }
      catch (const InputError &)
        {
          return "its parameters.prm cannot be read";
        }
      if (const std::string entry = first_difference(wanted, made_from, entries_that_may_differ()); !entry.empty())
        return entry + " differs";
      if (const std::string file = changed_file(run, wanted); !file.empty())
        return "'" + file + "' is not what it was";
      return "";
    }
  } // namespace

  std::vector<std::string> entries_that_may_differ()
  {
    std::vector<std::string> names = study_entries();
    names.emplace_back("Output/Directory");
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
