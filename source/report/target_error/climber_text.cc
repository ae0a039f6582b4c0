#include "report/study/lattice_places.h"
#include "report/target_error/climber.h"
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/report/text.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

/// What the climb says: of what it claims, and why it claims nothing.
namespace birdstrike
{
  namespace
  {
    constexpr double large_noise = 0.3; ///< of all errors: then more runs of a level help, too

    std::string show_share(const double error, const double value)
    {
      return format_share(std::abs(error / value));
    }

    std::string name_noise(const ClimbAxis &axis)
    {
      return axis.is_bar_noise() ? ", by the scatter of its finest level's runs" : "";
    }
  } // namespace

  bool Climber::is_whole_known() const
  {
    return std::ranges::none_of(axes, &ClimbAxis::is_unknown);
  }

  std::string Climber::describe_target() const
  {
    const bool is_mesh_unknown = known.is_there(1) && known.n_levels(1) == 1;
    return fmt::format("Target: {}, with an error of {} at most.{}", quantity.name(), format_share(target.share),
                       is_mesh_unknown ? " Mesh: unknown. It comes from a file and is not refined, so that the bird's "
                                         "error alone is estimated, and no error of the whole is claimed."
                                       : "");
  }

  void Climber::require_whole_error() const
  {
    if (!is_whole_known())
      throw NumericalFailure("The target error cannot be claimed: the error of the mesh is unknown, because the mesh "
                             "comes from a file.\n  Action: birdstrike study with finer files, --vary "
                             "\"Blade/Mesh/File=a.msh, b.msh\", shows the error of the mesh.");
  }

  void Climber::refuse() const
  {
    const Levels      finest{axes[0].sizes.size() - 1, 0};
    const std::string unit = known.quantity().unit;
    const double      value =
      known.value(finest) + axes[0].correction(finest.first) + axes[1].values.back() - axes[1].values.front();
    throw NumericalFailure(fmt::format(
      "The target error of {} is not reached, and none is claimed: {} is near {}.\n"
      "  {}.\n  {}.\n{}{}  Action: {}.",
      format_share(target.share), quantity.name(), format_value(value, unit), describe_axis(0), describe_axis(1),
      axes[0].is_refined() && axes[1].is_refined() ? describe_interaction(whole_interaction(), unit) : "",
      describe_places(), advise()));
  }

  /// What the ladders' bars allow, where they can be trusted.
  std::string Climber::advise() const
  {
    const double allowed = allowed_error();
    if (!axes[0].is_trusted(allowed) || !axes[1].is_trusted(allowed))
      return axes[0].known_orders && !axes[0].is_trusted(allowed)
               ? "another --bird-order, or none; birdstrike converge shows what a longer ladder has"
               : "a larger target, or a case whose ladders converge (birdstrike converge)";
    const double errors    = axes[0].errors().back() + axes[1].errors().back() + whole_interaction().value_or(0.);
    const double scattered = axes[0].noise + axes[1].noise;
    return fmt::format("a target well above {}, {}{} in the case: the finest levels are half of its own sizes",
                       format_share(target.share * errors / allowed),
                       scattered > large_noise * errors ? "more --places, or " : "or ",
                       name_refinements(axes[0], axes[1]));
  }

  std::string Climber::describe_axis(const std::size_t a) const
  {
    if (!axes[a].is_there)
      return axes[a].name + ": none, and no error of one";
    if (axes[a].is_unknown())
      return axes[a].name + ": unknown; it comes from a file and is not refined, its error is in no bar";
    if (const auto fit = axes[a].limit())
      return fmt::format("{}: {} levels to {}, order {} as given{}: {} more takes the finest to h = 0, +- {}",
                         axes[a].name, axes[a].sizes.size(), format_quantity(axes[a].sizes.back(), "m"),
                         axes[a].known_orders->text(),
                         fit->rejects_order() ? fmt::format(", which they reject (p = {:.2g})", fit->p_value) : "",
                         format_value(axes[a].correction(axes[a].sizes.size() - 1), known.quantity().unit),
                         show_share(axes[a].bar(), fit->limit) + name_noise(axes[a]));
    const GridConvergence made = axes[a].estimate();
    return fmt::format("{}: {} levels to {}, {}{}{}{}", axes[a].name, axes[a].sizes.size(),
                       format_quantity(axes[a].sizes.back(), "m"), birdstrike::describe(made.trend),
                       std::isnan(made.order) ? "" : fmt::format(", order {:.2f}", made.order),
                       made.n_fitted > 3 ? " by least squares" : "",
                       ", +- " + show_share(axes[a].bar(), axes[a].values.back()) + name_noise(axes[a]));
  }

  /// A line where values are means over places.
  std::string Climber::describe_places() const
  {
    if (known.n_places() == 1)
      return "";
    const auto show = [&](const Levels &at) {
      const double variance = mean_over_places(known.values(at), known.n_places()).at(0).variance;
      return show_share(std::sqrt(variance), known.value(at));
    };
    return fmt::format("  Values are means over {} places of the bird's lattice (Lattice shift): standard deviation of "
                       "one run {} at the coarsest levels, {} with the finest of the bird.\n",
                       known.n_places(), show({0, 0}), show({axes[0].sizes.size() - 1, 0}));
  }

  std::string Climber::describe_runs(const Levels &at) const
  {
    return fmt::format("  {} runs; {} in {}", known.n_runs(),
                       known.n_places() == 1 ? "this one" : "of this value the one with the case's own lattice",
                       known.folder(at).string());
  }

  /// "of the bird 2.1 %, mesh: unknown".
  std::string Climber::describe_errors(const Answer &answer) const
  {
    std::string text;
    const auto  add = [&](const std::string &part) { text += (text.empty() ? "" : ", ") + part; };
    for (std::size_t a = 0; a < axes.size(); ++a)
      if (axes[a].is_unknown())
        add(axes[a].name + ": unknown");
      else if (axes[a].is_there)
        add("of the " + axes[a].name + " " + show_share(a == 0 ? answer.bird : answer.mesh, answer.value));
    if (axes[0].is_refined() && axes[1].is_refined())
      add("of both together " + show_share(answer.interaction, answer.value));
    return text;
  }

  std::string Climber::describe(const Answer &answer) const
  {
    const double      added    = axes[0].correction(answer.levels.first);
    const std::string unit     = known.quantity().unit;
    const std::string headline = is_whole_known()
                                   ? fmt::format(" +- {}", show_share(answer.bar(), answer.value))
                                   : fmt::format("; {}; no error of the whole is claimed", describe_errors(answer));
    return fmt::format("{} {}{}{}\n  {}\n  {}\n  {}\n{}{}", quantity.name(), format_value(answer.value, unit), headline,
                       added != 0. ? (known.n_places() == 1 ? "\n  a run's " : "\n  the runs' ") +
                                       format_value(answer.value - added, unit) + ", and " + format_value(added, unit) +
                                       " to h = 0 of the particles"
                                   : "",
                       describe_errors(answer), describe_axis(0), describe_axis(1), describe_places(),
                       describe_runs(answer.levels));
  }

  std::string Climber::as_json(const Answer &answer) const
  {
    const auto known_or_null = [](const bool is_known, const double error) {
      return is_known ? nlohmann::ordered_json(error) : nlohmann::ordered_json(nullptr);
    };
    nlohmann::ordered_json json;
    json["quantity"] = quantity.name();
    json["unit"]     = known.quantity().unit;
    json["value"]    = answer.value;
    json["target"]   = target.share;
    json["error"]    = {{"whole", known_or_null(is_whole_known(), answer.bar())},
                        {"bird", known_or_null(!axes[0].is_unknown(), answer.bird)},
                        {"mesh", known_or_null(!axes[1].is_unknown(), answer.mesh)},
                        {"both_together", known_or_null(is_whole_known(), answer.interaction)}};
    json["run"]      = known.folder(answer.levels).string();
    return json.dump(2) + "\n";
  }
} // namespace birdstrike
