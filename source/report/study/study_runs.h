#pragma once

#include "report/study/study_points.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike
{
  /// A point of a study and what its run has come to.
  struct PointRun
  {
    StudyPoint            point;
    std::filesystem::path folder;
    std::string           state;             ///< "done", "lost: ...", "refused: ...", "not run", ...
    bool                  is_done   = false; ///< its run folder holds a complete run of the same parameters
    bool                  is_reused = false; ///< and did so before
    int                   exit_code = 0;     ///< of the run, or what a run would have ended with
    bool                  goes_on   = false; ///< from a checkpoint in its folder
  };

  /// How points are run: each with one thread where the case says nothing.
  struct RunOptions
  {
    std::string              prm_file;
    std::vector<std::string> overrides;          ///< of all points
    std::size_t              n_jobs   = 0;       ///< side by side; 0: one a core
    std::string              launcher = {};      ///< words before each command
    std::string              what     = "study"; ///< of what, in words on the screen
    bool                     may_lose = false;   ///< runs of other entries in folders of points
  };

  /// Reads every point's case, and looks into its folder, a folder of `directory`, for a run that can be taken. Runs
  /// nothing, writes nothing. A point whose entries are refused is marked so; throws that InputError where all are, and
  /// another one where a run of other entries would be lost (reason_to_keep) that may not be.
  std::vector<PointRun> plan_runs(const std::vector<StudyPoint> &points, const std::filesystem::path &directory,
                                  RunOptions &options);

  /// Runs the points that are neither done nor refused, side by side, telling of each as it ends; those with a
  /// checkpoint go on from it, and anew where `resume` refuses. Throws Interrupted where a signal stops it.
  void run_points(std::vector<PointRun> &runs, const RunOptions &options);

  /// What a run that was refused says why, of all that it has said: behind its warnings.
  std::string find_refusal(const std::string &output);

  /// A text as one word of the shell.
  std::string quote_for_shell(const std::string &text);

  /// A line of shell for each of these points, that runs it from any folder.
  std::string make_task_list(const std::vector<PointRun> &runs, const RunOptions &options);
} // namespace birdstrike
