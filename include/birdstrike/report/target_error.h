#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace birdstrike
{
  /// What the command line says about a run to a target error.
  struct TargetRequest
  {
    std::string              target; ///< "tip peak = 2 %"
    std::string              prm_file;
    std::vector<std::string> overrides;
    std::string              output;          ///< folder; empty: runs/target/<the file's name>
    std::string              bird_order = {}; ///< of the ladder of the particles, where it is known: "1", "1:2"
    std::size_t              n_places   = 1;  ///< of the bird's lattice, over which a level's values are averaged
    bool is_forced = false;                   ///< runs of other entries and the table of another quantity are replaced
  };

  /// Expected run time of a case on one core (s).
  using RunTimeForecast = std::function<double(const std::string &prm_file, const std::vector<std::string> &overrides)>;

  /// Finds the cheapest run whose value of a quantity is within the target error of that on infinitely fine bird and
  /// mesh, and reports it with its error bar and the time that all took (report/target_error/climb.h says how errors
  /// are estimated). Bird and mesh are refined apart: three levels each to begin with, the third the case's own, then
  /// the one whose next level promises the most error for its time. Every run keeps its folder, and is reused. With an
  /// order of the bird's ladder that is known, the value may be that of a run with its finest level, of four at least,
  /// and what takes it to h = 0 of the particles.
  ///
  /// Of several places of the lattice all values are means. What a ladder's part of the error is at least is then half
  /// the 95 % confidence interval of its finest mean, and what both together add is at least that of the mean over
  /// places of what they add at each.
  ///
  /// Throws InputError for what the user must change; NumericalFailure, with the best value and what is wrong with its
  /// estimate, where the target cannot be claimed: no order that can be trusted, or the ladder's end.
  void run_to_target_error(const TargetRequest &request, const RunTimeForecast &forecast);
} // namespace birdstrike
