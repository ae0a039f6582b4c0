#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace birdstrike
{
  /// What a ladder of refinements refines.
  enum class Refinement
  {
    mesh,      ///< elements along span and chord of a built-in blade
    particles, ///< particle spacing
    both,      ///< these two by the same ratio
    step,      ///< shares of the stable steps of blade and bird
    points     ///< points through the thickness
  };

  /// What the command line says about a ladder.
  struct ConvergeRequest
  {
    std::string              prm_file;
    std::string              refinement = "both";
    std::size_t              n_levels   = 3;
    double                   ratio      = 1.5; ///< of sizes from level to level
    std::size_t              n_finer    = 0;   ///< levels finer than the case; the others are coarser
    std::string              order;            ///< of the method, where it is known, "1"; or its bounds, "1:2"
    std::size_t              n_places = 1;     ///< of the bird's lattice, over which a level's values are averaged
    std::size_t              n_jobs   = 0;     ///< levels side by side; 0: one a core
    std::vector<std::string> overrides;
    std::string              output;            ///< folder; empty: runs/converge/<the file's name>
    bool                     is_forced = false; ///< as of a study
  };

  /// Runs a case on a ladder of refinements, of which it is the finest level (of time steps the coarsest: they cannot
  /// be longer), reusing runs as run_study does, and says for each quantity the observed order, the value at h = 0, the
  /// grid convergence index and the error bar, and whether the ladder is in the asymptotic range: of three levels by
  /// Richardson's extrapolation, of more by least squares (report/study/grid_convergence.h): on the screen, in
  /// converge.csv and levels.csv, and as curves against the size (refinement.svg). With an order that is known, also
  /// the value at h = 0 that follows from it, with its confidence interval. A level of several places of the lattice
  /// (report/study/lattice_places.h) has the means over its runs, and the scatter of one run is told.
  ///
  /// Throws InputError for what the user must change and what run_study throws for levels that came to no result.
  void converge(const ConvergeRequest &request);
} // namespace birdstrike
