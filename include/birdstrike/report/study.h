#pragma once

#include <string>
#include <vector>

namespace birdstrike
{
  /// What the command line says about a study.
  struct StudyRequest
  {
    std::string              prm_file;
    std::vector<std::string> vary; ///< "Section/Entry=VALUES" (io/varied_entry.h); empty: section Study of the file
    bool                     are_pairs = false;     ///< values go together one by one, instead of each with each
    std::vector<std::string> overrides;             ///< "Section/Entry=value", for all points
    std::string              output;                ///< folder; empty: runs/study/<the file's name>
    std::size_t              n_jobs = 0;            ///< points side by side; 0: one a core
    std::string              launcher;              ///< words before each run's command, "srun -n 1"
    std::string              task_list;             ///< file for the command lines; not empty: nothing is run
    bool                     only_collects = false; ///< nothing is run: what is there goes into the table
    bool                     is_forced     = false; ///< runs of other entries and tables of other points are replaced
  };

  /// Runs a case once for each point of a grid of values (or of pairs), side by side, each in a process and a run
  /// folder of its own, or takes runs that are there and were made of the same parameters and files by this build: a
  /// study that was stopped goes on where it was. Then writes one table (study.csv, study.h5) with every quantity that
  /// `compare` reports, response curves of one varied entry, families of curves and maps of two (figures.gp, *.csv,
  /// *.svg). A point that was refused or lost keeps its row, with the reason.
  ///
  /// With a task list it writes a line of shell for each point that is still to run, and runs none.
  ///
  /// Where the folder holds finished runs of other entries or files, or a table with points that this study lacks,
  /// InputError is thrown before anything is run, unless the study is forced.
  ///
  /// Throws InputError for what the user must change and, after everything has been written, what the points that came
  /// to no result ask for, as compare_cases does.
  void run_study(const StudyRequest &request);
} // namespace birdstrike
