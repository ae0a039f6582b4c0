#include "report/target_error/climber.h"
#include "report/comparison/written_table.h"
#include "report/study/lattice_places.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>

#include <spdlog/logger.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace birdstrike
{
  namespace
  {
    /// The last of them is the case's own.
    constexpr std::size_t n_first_levels = 3;
  } // namespace

  Climber::Climber(const TargetRequest &request, const RunTimeForecast &forecast,
                   const std::filesystem::path &directory)
    : request(request)
    , forecast(forecast)
    , target(read_error_target(request.target))
    , quantity(find_quantity(target.quantity))
    , known(request, directory, quantity)
  {
    for (std::size_t a = 0; a < axes.size(); ++a)
      axes[a].is_there = known.is_there(a);
    axes[0].name         = "bird";
    axes[1].name         = "mesh";
    axes[0].known_orders = read_orders(request.bird_order, "--bird-order");
    if (axes[0].known_orders && known.n_levels(0) == 1)
      throw InputError("--bird-order: there is no bird whose particles could be refined.\n  Action: leave it out.");
  }

  Climber::Answer Climber::climb()
  {
    begin();
    while (true)
      {
        if (are_trusted())
          if (const auto answer = find_answer(); answer && are_trusted()) // its runs may have smaller values
            return *answer;
        extend(allowed_error());
      }
  }

  bool Climber::are_trusted() const
  {
    const double allowed = allowed_error();
    return axes[0].is_trusted(allowed) && axes[1].is_trusted(allowed);
  }

  /// The cheapest pair of levels that these ladders and what both together add allow, of which every run tells more.
  /// Where that alone is in the way the finest pair is run, from which the least of it is to go.
  std::optional<Climber::Answer> Climber::find_answer()
  {
    const Levels     finest(axes[0].sizes.size() - 1, axes[1].sizes.size() - 1);
    std::set<Levels> looked_at; // never twice by the same, whatever round-off says
    while (true)
      {
        auto choice = choose(allowed_error() - whole_interaction().value_or(0.), looked_at);
        if (!choice && !looked_at.contains(finest) && choose(allowed_error(), {}))
          choice = finest;
        if (!choice)
          return std::nullopt;
        const std::size_t n_seen = asides.size();
        const Answer      answer = look_at(*choice);
        if (answer.bar() <= target.share * std::abs(answer.value))
          return answer;
        if (asides.size() > n_seen)
          looked_at.clear();
        looked_at.insert(*choice);
      }
  }

  void Climber::add_level(const std::size_t axis)
  {
    const std::size_t level = axes[axis].sizes.size();
    const Levels      at    = axis == 0 ? Levels(level, 0) : Levels(0, level);
    known.run({at});
    axes[axis].sizes.push_back(known.size(axis, level));
    axes[axis].values.push_back(known.value(at));
    axes[axis].noise = interval_of_mean(known.values(at));
  }

  /// The coarsest run alone, which tells whether the quantity is one; then the first levels of both ladders.
  void Climber::begin()
  {
    known.run({{0, 0}});
    std::vector<Levels> first;
    for (std::size_t k = 1; k < n_first_levels; ++k)
      for (const Levels &at : {Levels(k, 0), Levels(0, k)})
        if (known.n_levels(at.first > 0 ? 0 : 1) > 1)
          first.push_back(at);
    known.run(first);
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t k = 0; k < std::min(n_first_levels, known.n_levels(a)); ++k)
        add_level(a);
  }

  /// The cheapest that is not looked at yet.
  std::optional<Climber::Levels> Climber::choose(const double allowed, const std::set<Levels> &looked_at)
  {
    std::optional<Levels> best;
    for (const ClimbChoice &choice : find_choices(axes[0], axes[1], allowed))
      if (const Levels at(choice.bird, choice.mesh); !looked_at.contains(at) && (!best || cost(at) < cost(*best)))
        best = at;
    return best;
  }

  /// Seen there; place by place, since the scatter of one has the other; no less than its mean is known by.
  double Climber::look_at_interaction(const Levels &at) const
  {
    std::vector<double> aside = known.values(at);
    for (std::size_t place = 0; place < aside.size(); ++place)
      aside[place] -=
        known.values({at.first, 0})[place] + known.values({0, at.second})[place] - known.values({0, 0})[place];
    const double mean = mean_over_places(aside, aside.size()).at(0).mean;
    return std::max(std::abs(mean), interval_of_mean(aside));
  }

  std::optional<double> Climber::whole_interaction() const
  {
    std::vector<SeenInteraction> seen;
    for (const auto &[at, aside] : asides)
      seen.push_back({{at.first, at.second}, aside});
    return extrapolate_interaction(axes[0], axes[1], seen);
  }

  Climber::Answer Climber::look_at(const Levels &at)
  {
    known.run({at});
    if (at.first > 0 && at.second > 0)
      asides[at] = look_at_interaction(at);
    return {at, known.value(at) + axes[0].correction(at.first), axes[0].errors()[at.first], axes[1].errors()[at.second],
            whole_interaction().value_or(0.)};
  }

  /// One more level: first of a ladder that cannot be trusted, else of the one that gains most for its time.
  void Climber::extend(const double allowed)
  {
    std::optional<std::size_t> best;
    double                     best_gain = -1.;
    for (std::size_t a = 0; a < 2; ++a)
      {
        const std::size_t next     = axes[a].sizes.size();
        const bool        is_ended = !axes[a].is_refined() || next >= known.n_levels(a);
        if (is_ended && !axes[a].is_trusted(allowed))
          refuse(); // whatever the other one would gain
        if (is_ended)
          continue;
        const double distrust = axes[a].is_trusted(allowed) ? 0. : 1e6; // before any gain
        const double gain =
          distrust + axes[a].expected_gain() / allowed / cost(a == 0 ? Levels(next, 0) : Levels(0, next));
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
    double            smallest = std::numeric_limits<double>::infinity();
    for (const Levels &at : known.all())
      for (const double added : {0., axes[0].correction(std::min(at.first, n_levels - 1))})
        smallest = std::min(smallest, std::abs(known.value(at) + added));
    return target.share * smallest;
  }

  double Climber::cost(const Levels &at)
  {
    if (!forecasts.contains(at))
      {
        std::vector<std::string>       overrides = request.overrides;
        const std::vector<std::string> of_levels = known.overrides_at(at);
        overrides.insert(overrides.end(), of_levels.begin(), of_levels.end());
        forecasts[at] = forecast(request.prm_file, overrides);
      }
    return forecasts[at];
  }

  std::vector<std::string> Climber::find_lost_tables(const std::filesystem::path &csv) const
  {
    const WrittenTable table(csv);
    for (const std::string &heading : table.headings())
      if (heading.find(": ") != std::string::npos && !heading.starts_with(quantity.name() + " ["))
        return {heading.substr(0, heading.find(" ["))};
    return {};
  }

  const LevelRuns &Climber::runs() const
  {
    return known;
  }
} // namespace birdstrike
