#include "report/target_error/climber.h"
#include "report/comparison/case_run.h"
#include "report/study/section_masses.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/io/case_parameters.h>

#include <spdlog/logger.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t n_first_levels = 3; ///< the last of them is the case's own
    constexpr std::size_t most_levels    = 5; ///< half the case's sizes; a sixth of the bird takes thrice all before it
    constexpr double      ratio          = std::numbers::sqrt2; ///< of sizes; Celik et al. advise at least 1.3

    /// One level where there is nothing to refine.
    std::vector<LadderLevel> make_levels(const CaseParameters &parameters, const std::size_t axis)
    {
      const Refinement         refinement = axis == 0 ? Refinement::particles : Refinement::mesh;
      std::vector<LadderLevel> made;
      try
        {
          for (std::size_t k = 0; k < most_levels; ++k)
            made.push_back(
              make_level(parameters, refinement,
                         std::pow(ratio, static_cast<double>(n_first_levels - 1) - static_cast<double>(k))));
        }
      catch (const InputError &)
        {
          return {{0., {}}};
        }
      const auto is_same = [](const LadderLevel &a, const LadderLevel &b) { return !(b.size < a.size); };
      if (std::ranges::adjacent_find(made, is_same) != made.end())
        throw InputError(
          "The mesh is too coarse to have two coarser ones beside it.\n  Action: more Blade/Mesh/Elements "
          "along span and chord.");
      return made;
    }
  } // namespace

  Climber::Climber(const TargetRequest &request, const RunTimeForecast &forecast,
                   const std::filesystem::path &directory)
    : request(request), forecast(forecast), directory(directory), target(read_error_target(request.target))
  {
    require_known(target.quantity);
    CaseParameters parameters;
    parameters.read(request.prm_file, request.overrides);
    axes[0].name         = "bird";
    axes[1].name         = "mesh";
    axes[0].known_orders = read_orders(request.bird_order, "--bird-order");
    for (std::size_t a = 0; a < 2; ++a)
      levels[a] = make_levels(parameters, a);
    if (axes[0].known_orders && levels[0].size() == 1)
      throw InputError("--bird-order: there is no bird whose particles could be refined.\n  Action: leave it out.");
    if (levels[0].size() == 1 && levels[1].size() == 1)
      throw InputError("There is neither a bird nor a built-in mesh that could be refined.\n  Action: run the case "
                       "without --target-error.");
  }

  Climber::Answer Climber::climb()
  {
    begin();
    while (true)
      {
        const double allowed = allowed_error();
        if (axes[0].is_trusted(allowed) && axes[1].is_trusted(allowed))
          if (const auto choice = choose(allowed - interaction))
            {
              const Answer answer = look_at(*choice);
              if (answer.bar() <= target.share * std::abs(answer.value))
                return answer;
              continue; // with the interaction that has been seen, choices are fewer
            }
        extend(allowed);
      }
  }

  /// Runs those that are not known yet, and reads the quantity.
  void Climber::run(const std::vector<Place> &places)
  {
    std::vector<StudyPoint> points;
    std::vector<Place>      wanted;
    for (const Place &place : places)
      if (!runs.contains(place))
        {
          wanted.push_back(place);
          points.push_back(point_at(place));
        }
    if (points.empty())
      return;
    RunOptions options{request.prm_file, request.overrides, 0, "", "climb"};
    auto       made = plan_runs(points, directory, options);
    run_points(made, options);
    for (std::size_t k = 0; k < made.size(); ++k)
      {
        if (!made[k].is_done)
          throw NumericalFailure("The target error cannot be claimed: " + made[k].point.name + " " + made[k].state);
        const RunRecord record = read_record(made[k].folder);
        const auto      rows   = ComparisonTable({{made[k].point.name, record}}).rows();
        row                    = find_row(rows, target.quantity);
        if (!(std::abs(row.values[0]) > 0.))
          throw NumericalFailure("The target error cannot be claimed: " + row.group + ": " + row.quantity +
                                 " is zero, or none, with " + made[k].point.name + ".");
        if (row.is_rising(0))
          throw NumericalFailure(
            "The target error cannot be claimed: " + row.group + ": " + row.quantity + " still rises at the end of " +
            made[k].point.name +
            ", or the bird still pushes there: it may be no peak yet.\n  Action: a later Time/End time.");
        const double seconds = record.summary().number("cost/wall");
        runs.emplace(wanted[k], KnownRun{row.values[0],
                                         seconds,
                                         made[k].folder,
                                         {"'" + made[k].point.name + "'", record.summary().warnings()}});
      }
    std::vector<std::filesystem::path> folders;
    for (const auto &[place, known] : runs)
      folders.push_back(known.folder);
    if (const std::string why = describe_changing_sections(folders); !why.empty())
      throw NumericalFailure("The target error cannot be claimed: " + why);
  }

  void Climber::add_level(const std::size_t axis)
  {
    const std::size_t level = axes[axis].sizes.size();
    const Place       place = axis == 0 ? Place(level, 0) : Place(0, level);
    run({place});
    axes[axis].sizes.push_back(levels[axis][level].size);
    axes[axis].values.push_back(runs.at(place).value);
  }

  /// The coarsest run alone, which tells whether the quantity is one; then the first levels of both ladders.
  void Climber::begin()
  {
    run({{0, 0}});
    std::vector<Place> places;
    for (std::size_t k = 1; k < n_first_levels; ++k)
      for (const Place &place : {Place(k, 0), Place(0, k)})
        if (levels[place.first > 0 ? 0 : 1].size() > 1)
          places.push_back(place);
    run(places);
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t k = 0; k < std::min(n_first_levels, levels[a].size()); ++k)
        add_level(a);
  }

  /// The cheapest.
  std::optional<Climber::Place> Climber::choose(const double allowed)
  {
    std::optional<Place> best;
    for (const ClimbChoice &choice : find_choices(axes[0], axes[1], allowed))
      if (const Place place(choice.bird, choice.mesh); !best || cost(place) < cost(*best))
        best = place;
    return best;
  }

  Climber::Answer Climber::look_at(const Place &place)
  {
    run({place});
    const double value = runs.at(place).value;
    const double sum   = runs.at({place.first, 0}).value + runs.at({0, place.second}).value - runs.at({0, 0}).value;
    const double aside = axes[0].share_beyond(place.first) * std::abs(value - sum);
    interaction        = std::max(interaction, aside);
    return {place, value + axes[0].correction(place.first), axes[0].errors()[place.first],
            axes[1].errors()[place.second], aside};
  }

  /// One more level: first of a ladder that cannot be trusted, else of the one that gains most for its time.
  void Climber::extend(const double allowed)
  {
    std::optional<std::size_t> best;
    double                     best_gain = -1.;
    for (std::size_t a = 0; a < 2; ++a)
      {
        const std::size_t next     = axes[a].sizes.size();
        const bool        is_ended = !axes[a].is_refined() || next >= levels[a].size();
        if (is_ended && !axes[a].is_trusted(allowed))
          refuse(); // whatever the other one would gain
        if (is_ended)
          continue;
        const double distrust = axes[a].is_trusted(allowed) ? 0. : 1e6; // before any gain
        const double gain =
          distrust + axes[a].expected_gain() / allowed / cost(a == 0 ? Place(next, 0) : Place(0, next));
        if (gain > best_gain)
          {
            best      = a;
            best_gain = gain;
          }
      }
    if (!best)
      refuse();
    log().info("{} is refined further: {}", axes[*best].name, describe_axis(*best));
    add_level(*best);
  }

  /// Of the smallest value that was seen or may be claimed, so that it is allowed of any.
  double Climber::allowed_error() const
  {
    const std::size_t n_levels = axes[0].values.size();
    double            smallest = std::abs(runs.begin()->second.value);
    for (const auto &[place, known] : runs)
      for (const double value : {known.value, known.value + axes[0].correction(std::min(place.first, n_levels - 1))})
        smallest = std::min(smallest, std::abs(value));
    return target.share * smallest;
  }

  StudyPoint Climber::point_at(const Place &place) const
  {
    StudyPoint point;
    for (const auto &[axis, level] : {std::pair(0, place.first), std::pair(1, place.second)})
      {
        const LadderLevel &each = levels[static_cast<std::size_t>(axis)][level];
        point.overrides.insert(point.overrides.end(), each.overrides.begin(), each.overrides.end());
      }
    point.name   = LadderLevel{0., point.overrides}.name();
    point.folder = make_folder_name(point.name);
    point.at     = {0};
    return point;
  }

  double Climber::cost(const Place &place)
  {
    if (!forecasts.contains(place))
      {
        std::vector<std::string> overrides = request.overrides;
        const StudyPoint         point     = point_at(place);
        overrides.insert(overrides.end(), point.overrides.begin(), point.overrides.end());
        forecasts[place] = forecast(request.prm_file, overrides);
      }
    return forecasts[place];
  }
} // namespace birdstrike
