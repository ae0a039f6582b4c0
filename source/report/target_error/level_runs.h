#pragma once

#include "report/comparison/comparison_table.h"
#include "report/comparison/warning_digest.h"
#include "report/study/refinement.h"
#include "report/target_error/asked_quantity.h"
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

    /// Throws InputError for a mesh too coarse to have coarser ones, where neither bird nor mesh can be refined, and as
    /// make_lattice_places does.
    LevelRuns(const TargetRequest &request, const std::filesystem::path &directory, const AskedQuantity &quantity);

    bool is_there(std::size_t axis) const; ///< a bird (0), a mesh (1), whether it can be refined or not

    /// How many there are of the bird (0) and the mesh (1), and h of one (m); a single one where nothing can be
    /// refined.
    std::size_t n_levels(std::size_t axis) const;
    double      size(std::size_t axis, std::size_t level) const;

    /// "Section/Entry=value" of the first place.
    std::vector<std::string> overrides_at(const Levels &at) const;

    /// Runs those that are not known yet, and reads the quantity of all that are done. Then throws NumericalFailure
    /// where one is not, has no value, or one that still rises, and where levels are of different blades; InputError
    /// where the runs have no such quantity; what plan_runs and run_points throw.
    void run(const std::vector<Levels> &wanted);

    std::size_t n_places() const;
    std::size_t n_runs() const;
    double      value(const Levels &at) const; ///< mean over places; of levels that were run

    const std::vector<double> &values(const Levels &at) const; ///< by place

    std::vector<Levels>          all() const;                    ///< that were run
    const std::filesystem::path &folder(const Levels &at) const; ///< of the first place
    const ComparisonRow         &quantity() const;               ///< its name and unit
    std::string                  as_csv() const;                 ///< a row a run
    std::string                  warnings_as_text() const;       ///< of all runs, a line a code

  private:
    struct KnownRun
    {
      std::size_t           place;
      double                value, seconds;
      std::filesystem::path folder;
      WarnedRun             warned;
    };

    const TargetRequest                     request;
    const std::filesystem::path             directory;
    const AskedQuantity                     asked;
    std::array<bool, 2>                     are_there{};
    std::array<std::vector<LadderLevel>, 2> levels;
    LadderPlaces                            places;
    std::map<Levels, std::vector<KnownRun>> runs;      ///< by place
    std::map<Levels, std::vector<double>>   values_of; ///< by place, where all have one
    ComparisonRow                           row;

    StudyPoint point_at(const Levels &at, std::size_t place) const;
    KnownRun   read(const StudyPoint &point, const std::filesystem::path &folder);
    void       require_one_blade() const;
  };
} // namespace birdstrike
