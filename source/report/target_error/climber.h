#pragma once

#include "report/comparison/warning_digest.h"
#include "report/study/refinement.h"
#include "report/study/study_runs.h"
#include "report/target_error/climb.h"
#include <birdstrike/report/target_error.h>

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace birdstrike
{
  /// Climbs the ladders of bird and mesh of one case until a run is within its target error.
  ///
  /// Each ladder runs with the other direction at its coarsest. What a run at levels (i, j) of both differs from the
  /// sum of the two ladders' changes is counted as a third part of its error; later choices leave room for the largest
  /// such part that was seen. Every run is one of plan_runs and run_points.
  class Climber
  {
  public:
    using Place = std::pair<std::size_t, std::size_t>; ///< levels of bird and mesh

    /// A value that can be claimed, with the parts of its error bar.
    struct Answer
    {
      Place  place;
      double value; ///< of the run, corrected
      double bird, mesh, interaction;

      double bar() const
      {
        return bird + mesh + interaction;
      }
    };

    Climber(const TargetRequest &request, const RunTimeForecast &forecast, const std::filesystem::path &directory);

    Answer climb(); ///< throws NumericalFailure where nothing can be claimed

    std::string describe(const Answer &answer) const;
    std::string warnings_as_text() const; ///< of all runs, a line a code
    std::string as_csv() const;           ///< a row a run

  private:
    struct KnownRun
    {
      double                value, seconds;
      std::filesystem::path folder;
      WarnedRun             warned;
    };

    const TargetRequest                     request;
    const RunTimeForecast                  &forecast;
    const std::filesystem::path             directory;
    const ErrorTarget                       target;
    std::array<ClimbAxis, 2>                axes; ///< bird, mesh
    std::array<std::vector<LadderLevel>, 2> levels;
    std::map<Place, KnownRun>               runs;
    std::map<Place, double>                 forecasts; ///< s
    ComparisonRow                           row;
    double                                  interaction = 0.; ///< the largest that was seen

    void                  begin();
    void                  run(const std::vector<Place> &places);
    void                  add_level(std::size_t axis);
    std::optional<Place>  choose(double allowed);
    Answer                look_at(const Place &place);
    void                  extend(double allowed);
    [[noreturn]] void     refuse() const;
    std::optional<double> seen_interaction() const;
    std::string           advise() const;

    double      allowed_error() const;
    StudyPoint  point_at(const Place &place) const;
    double      cost(const Place &place);
    std::string describe_axis(std::size_t a) const;
    std::string size_of(std::size_t axis, std::size_t level) const;
  };
} // namespace birdstrike
