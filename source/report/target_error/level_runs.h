#pragma once

#include "report/comparison/comparison_table.h"
#include "report/comparison/warning_digest.h"
#include "report/study/lattice_places.h"
#include "report/study/refinement.h"
#include <birdstrike/report/target_error.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace birdstrike
{
  /// Runs of one case with its bird and its mesh at levels of refinement, each pair of levels at as many places of the
  /// lattice (report/study/lattice_places.h) as were asked for, and the mean over them of one quantity.
  ///
  /// Every run is one of plan_runs and run_points: it keeps its folder, and is reused.
  class LevelRuns
  {
  public:
    using Levels = std::pair<std::size_t, std::size_t>; ///< of bird and mesh, the coarsest first

    /// Throws InputError for a mesh too coarse to have coarser ones, no bird or half a bird at several places, and
    /// where neither bird nor mesh can be refined.
    LevelRuns(const TargetRequest &request, const std::filesystem::path &directory, const std::string &quantity);

    /// How many there are of the bird (0) and the mesh (1), and h of one (m); a single one where nothing can be
    /// refined.
    std::size_t n_levels(std::size_t axis) const;
    double      size(std::size_t axis, std::size_t level) const;

    /// "Section/Entry=value" of the first place.
    std::vector<std::string> overrides_at(const Levels &at) const;

    /// Runs those that are not known yet, and reads the quantity. Throws NumericalFailure where a run has none, or one
    /// that still rises, and where levels are of different blades; what run_points throws.
    void run(const std::vector<Levels> &wanted);

    std::size_t n_places() const;
    std::size_t n_runs() const;
    double      value(const Levels &at) const; ///< mean over places; of levels that were run

    std::vector<Levels>          all() const;                    ///< that were run
    const std::filesystem::path &folder(const Levels &at) const; ///< of the first place
    const ComparisonRow         &quantity() const;               ///< its name and unit
    std::string                  as_csv() const;                 ///< a row a run
    std::string                  warnings_as_text() const;       ///< of all runs, a line a code

    /// Standard deviation of one run, these levels alike; 0 of one place.
    double deviation(const std::vector<Levels> &of) const;

    /// Half the 95 % confidence interval of a mean of one of these levels (Student's t, their variances pooled); 0 of
    /// one place.
    double mean_interval(const std::vector<Levels> &of) const;

  private:
    struct KnownRun
    {
      double                value, seconds;
      std::filesystem::path folder;
      WarnedRun             warned;
    };

    const TargetRequest                     request;
    const std::filesystem::path             directory;
    const std::string                       asked; ///< the quantity, as it was typed
    std::array<std::vector<LadderLevel>, 2> levels;
    LadderPlaces                            places;
    std::map<Levels, std::vector<KnownRun>> runs; ///< by place
    std::map<Levels, PlaceMean>             mean_of;
    ComparisonRow                           row;

    StudyPoint point_at(const Levels &at, std::size_t place) const;
    KnownRun   read(const StudyPoint &point, const std::filesystem::path &folder);
    void       require_one_blade() const;
  };
} // namespace birdstrike
