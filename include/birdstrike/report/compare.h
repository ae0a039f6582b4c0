#pragma once

#include <string>
#include <vector>

namespace birdstrike
{
  /// What the command line says about a comparison.
  struct CompareRequest
  {
    std::vector<std::string> prm_files;
    std::vector<std::string> blade_kinds; ///< each file once for each of these values of Blade/Kind; empty: as they are
    std::vector<std::string> overrides;   ///< "Section/Entry=value", for all cases
    std::string              output    = "runs/compare";
    bool                     is_forced = false; ///< runs of other entries and tables of other cases are replaced
  };

  /// Runs the cases, or takes runs that are complete and were made of the same parameters by this build: in the
  /// comparison's own folder, where `run` would put them, or beside a parameters.prm that was given. Then writes one
  /// table (terminal, comparison.md, comparison.csv) and overlaid curves (figures.gp, *.csv and, where gnuplot is
  /// installed, *.svg).
  ///
  /// Every case runs in a process of its own, so that its memory is its own and its loss nobody else's. All cases are
  /// checked before the first one runs. Throws InputError for what the user must change, and, after everything has been
  /// written, NumericalFailure if a case was lost, Interrupted if a signal ended one, InputError if one was refused
  /// when its turn came, std::runtime_error if one crashed.
  void compare_cases(const CompareRequest &request);
} // namespace birdstrike
