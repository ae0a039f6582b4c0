#pragma once

#include "report/target_error/climb.h"
#include "report/target_error/level_runs.h"
#include <birdstrike/report/target_error.h>

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace birdstrike
{
  /// Climbs the ladders of bird and mesh of one case until a run is within its target error.
  ///
  /// Each ladder runs with the other direction at its coarsest. What a run at levels (i, j) of both differs from the
  /// sum of the two ladders' changes, taken as far as both ladders go, is counted as a third part of
  /// its error. Values are those of LevelRuns.
  class Climber
  {
  public:
    using Levels = LevelRuns::Levels;

    /// A value that can be claimed, with the parts of its error bar.
    struct Answer
    {
      Levels levels;
      double value; ///< of the runs, corrected
      double bird, mesh, interaction;

      double bar() const
      {
        return bird + mesh + interaction;
      }
    };

    Climber(const TargetRequest &request, const RunTimeForecast &forecast, const std::filesystem::path &directory);

    Answer climb(); ///< throws NumericalFailure where nothing can be claimed

    /// The quantity of an earlier table in the folder, if it is another one.
    std::vector<std::string> find_lost_tables(const std::filesystem::path &csv) const;

    /// Which quantity is meant, and which error will stay unknown.
    std::string describe_target() const;

    std::string      describe(const Answer &answer) const;
    std::string      as_json(const Answer &answer) const; ///< an error that is unknown is null
    const LevelRuns &runs() const;

    /// Throws NumericalFailure where a part of the error is unknown.
    void require_whole_error() const;

  private:
    const TargetRequest      request;
    const RunTimeForecast   &forecast;
    const ErrorTarget        target;
    const AskedQuantity      quantity;
    LevelRuns                known;
    std::array<ClimbAxis, 2> axes;      ///< bird, mesh
    std::map<Levels, double> forecasts; ///< of a run, s
    std::map<Levels, double> asides;    ///< what runs with both refined differ from the sum of the ladders

    void                  begin();
    void                  add_level(std::size_t axis);
    bool                  are_trusted() const;
    std::optional<Answer> find_answer();
    std::optional<Levels> choose(double allowed, const std::set<Levels> &looked_at);
    Answer                look_at(const Levels &at);
    double                look_at_interaction(const Levels &at) const;
    std::optional<double> whole_interaction() const;
    void                  extend(double allowed);
    [[noreturn]] void     refuse() const;
    std::string           advise() const;
    bool                  is_whole_known() const;
    std::string           describe_errors(const Answer &answer) const;

    double      allowed_error() const;
    double      cost(const Levels &at);
    std::string describe_axis(std::size_t a) const;
    std::string describe_places() const;
    std::string describe_runs(const Levels &at) const;
  };
} // namespace birdstrike
