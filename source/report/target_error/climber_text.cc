#include "report/target_error/climber.h"
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/report/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

/// What the climb says: of what it claims, and why it claims nothing.
namespace birdstrike
{
  namespace
  {
    std::string show_share(const double error, const double value)
    {
      return format_share(std::abs(error / value));
    }
  } // namespace

  void Climber::refuse() const
  {
    const Place  finest{axes[0].sizes.size() - 1, 0};
    const double value =
      runs.at(finest).value + axes[0].correction(finest.first) + axes[1].values.back() - axes[1].values.front();
    throw NumericalFailure(fmt::format(
      "The target error of {} is not reached, and none is claimed: {} is near {}.\n"
      "  {}.\n  {}.\n{}  Action: {}.",
      format_share(target.share), row.group + ": " + row.quantity, format_value(value, row.unit), describe_axis(0),
      describe_axis(1),
      axes[0].is_refined() && axes[1].is_refined() ? describe_interaction(seen_interaction(), row.unit) : "",
      advise()));
  }

  /// None where no run has both refined.
  std::optional<double> Climber::seen_interaction() const
  {
    const bool is_seen =
      std::ranges::any_of(runs, [](const auto &run) { return run.first.first > 0 && run.first.second > 0; });
    return is_seen ? std::optional(interaction) : std::nullopt;
  }

  /// What the ladders' bars allow, where they can be trusted.
  std::string Climber::advise() const
  {
    const double allowed = allowed_error();
    if (!axes[0].is_trusted(allowed) || !axes[1].is_trusted(allowed))
      return axes[0].known_orders && !axes[0].is_trusted(allowed)
               ? "another --bird-order, or none; birdstrike converge shows what a longer ladder has"
               : "a larger target, or a case whose ladders converge (birdstrike converge)";
    const double errors = axes[0].errors().back() + axes[1].errors().back() + interaction;
    return fmt::format("a target well above {}, or {} in the case: the finest levels are half of its own sizes",
                       format_share(target.share * errors / allowed), name_refinements(axes[0], axes[1]));
  }

  std::string Climber::describe_axis(const std::size_t a) const
  {
    if (!axes[a].is_refined())
      return axes[a].name + ": not refined, its error is in no bar";
    if (const auto fit = axes[a].limit())
      return fmt::format("{}: {} levels to {}, order {} as given{}: {} more takes the finest to h = 0, +- {}",
                         axes[a].name, axes[a].sizes.size(), format_quantity(axes[a].sizes.back(), "m"),
                         axes[a].known_orders->text(),
                         fit->rejects_order() ? fmt::format(", which they reject (p = {:.2g})", fit->p_value) : "",
                         format_value(axes[a].correction(axes[a].sizes.size() - 1), row.unit),
                         show_share(fit->half_interval, fit->limit));
    const GridConvergence made = axes[a].estimate();
    return fmt::format(
      "{}: {} levels to {}, {}{}{}{}", axes[a].name, axes[a].sizes.size(), format_quantity(axes[a].sizes.back(), "m"),
      birdstrike::describe(made.trend), std::isnan(made.order) ? "" : fmt::format(", order {:.2f}", made.order),
      made.n_fitted > 3 ? " by least squares" : "", ", +- " + show_share(axes[a].bar(), axes[a].values.back()));
  }

  std::string Climber::size_of(const std::size_t axis, const std::size_t level) const
  {
    return levels[axis].size() > 1 ? fmt::format("{}", levels[axis][level].size) : "";
  }

  std::string Climber::as_csv() const
  {
    std::string text = "particle spacing [m],size of an element [m]," + csv_heading(row) + ",run time [s],folder\n";
    for (const auto &[place, known] : runs)
      text += fmt::format("{},{},{},{},{}\n", size_of(0, place.first), size_of(1, place.second), known.value,
                          known.seconds, csv_field(known.folder.string()));
    return text;
  }

  std::string Climber::warnings_as_text() const
  {
    std::vector<WarnedRun> all;
    for (const auto &[place, known] : runs)
      all.push_back(known.warned);
    std::string text;
    for (const std::string &line : digest_warnings(all))
      text += line + "\n";
    return text;
  }

  std::string Climber::describe(const Answer &answer) const
  {
    const double added = axes[0].correction(answer.place.first);
    return fmt::format(
      "{}: {} {} +- {}{}\n  of the bird {}, of the mesh {}, of both together {}\n  {}\n  {}\n  {} runs; this "
      "one in {}",
      row.group, row.quantity, format_value(answer.value, row.unit), show_share(answer.bar(), answer.value),
      added != 0. ? "\n  a run's " + format_value(answer.value - added, row.unit) + ", and " +
                      format_value(added, row.unit) + " to h = 0 of the particles"
                  : "",
      show_share(answer.bird, answer.value), show_share(answer.mesh, answer.value),
      show_share(answer.interaction, answer.value), describe_axis(0), describe_axis(1), runs.size(),
      runs.at(answer.place).folder.string());
  }
} // namespace birdstrike
