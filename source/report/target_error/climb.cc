#include "report/target_error/climb.h"
#include "report/target_error/asked_quantity.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/report/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace birdstrike
{
  namespace
  {
    constexpr double largest_share        = 0.5;
    constexpr double small_bar            = 0.5; ///< of what is allowed: then even a bar without an order will do
    constexpr double factor_without_order = 3.;

    /// Of four levels the test of an order that is wrong by one rejects a half at best (scatter of 6 % of the change).
    constexpr std::size_t fewest_of_a_test = 5;

    /// Particles and elements have no higher one: more is a sign of three levels that are not in the asymptotic range.
    constexpr double highest_order_of_three = 2.1; ///< as of fits

    bool is_trusted_here(const GridConvergence &made)
    {
      const bool is_too_good =
        made.n_fitted == 3 && made.trend == Trend::asymptotic && made.order > highest_order_of_three;
      return made.is_trusted() && !is_too_good;
    }

    double largest_change(const std::vector<double> &values)
    {
      const std::size_t n       = std::min<std::size_t>(values.size(), 3);
      double            largest = 0.;
      for (std::size_t k = values.size() - n; k < values.size(); ++k)
        largest = std::max(largest, std::abs(values[k] - values.back()));
      return largest;
    }
  } // namespace

  ErrorTarget read_error_target(const std::string &text)
  {
    const auto refuse = [&](const std::string &what) {
      throw InputError("--target-error '" + text + "': " + what +
                       "\n  Allowed: a quantity of the run and an error, \"tip peak = 2 %\", \"impulse = 0.5 %\".");
    };
    const std::size_t equals = text.find('='), percent = text.find('%');
    if (equals == std::string::npos || words_in(text.substr(0, equals)).empty())
      refuse("no quantity.");
    double            value  = 0.;
    const std::size_t begin  = std::min(text.find_first_not_of(' ', equals + 1), text.size());
    const auto [end, error]  = std::from_chars(text.data() + begin, text.data() + text.size(), value);
    const std::string behind = {end, text.data() + text.size()};
    if (error != std::errc() || percent == std::string::npos || words_in(behind).size() > 0 ||
        behind.find_first_not_of(" %") != std::string::npos)
      refuse("no error in percent.");
    if (!(value > 0.) || value > 100. * largest_share)
      refuse(fmt::format("an error of {:g} %; above 0, at most {:g} %.", value, 100. * largest_share));
    const std::string quantity = text.substr(0, equals);
    return {quantity.substr(0, quantity.find_last_not_of(' ') + 1), 0.01 * value};
  }

  bool ClimbAxis::is_refined() const
  {
    return sizes.size() > 1;
  }

  bool ClimbAxis::is_unknown() const
  {
    return is_there && !is_refined();
  }

  GridConvergence ClimbAxis::estimate() const
  {
    const std::vector<double> h(sizes.rbegin(), sizes.rend()), f(values.rbegin(), values.rend());
    return estimate_convergence(h, f);
  }

  std::optional<KnownOrderFit> ClimbAxis::limit() const
  {
    if (!known_orders || values.size() < fewest_of_an_interval)
      return std::nullopt;
    const std::vector<double> h(sizes.rbegin(), sizes.rend()), f(values.rbegin(), values.rend());
    return fit_order_range(*known_orders, h, f);
  }

  double ClimbAxis::correction(const std::size_t level) const
  {
    const auto fit = limit();
    return fit && level + 1 == values.size() ? fit->limit - values[level] : 0.;
  }

  double ClimbAxis::share_beyond(const std::size_t level) const
  {
    double     to_level = 0., to_end = 0.;
    const auto last = values.size() - 1;
    for (std::size_t k = 1; k <= last; ++k)
      {
        const double way = std::abs(values[k] + correction(k) - values.front());
        to_end           = std::max(to_end, way);
        if (k <= level)
          to_level = std::max(to_level, std::abs(values[k] - values.front()));
      }
    if (to_level > 0.)
      return std::max(1., to_end / to_level);
    return to_end > 0. ? std::numeric_limits<double>::infinity() : 1.;
  }

  double ClimbAxis::bar() const
  {
    if (const auto fit = limit())
      return std::max(noise, fit->half_interval);
    const GridConvergence made  = estimate();
    const double          apart = factor_without_order * largest_change(values);
    if (made.n_fitted > 3)
      return std::max(noise, std::isnan(made.bar) ? apart : made.bar);
    return noise + (is_trusted_here(made) ? made.bar : apart);
  }

  bool ClimbAxis::is_bar_noise() const
  {
    return noise > 0. && bar() == noise;
  }

  std::vector<double> ClimbAxis::errors() const
  {
    std::vector<double> all(sizes.size(), 0.);
    if (!is_refined())
      return all;
    const double of_finest = bar();
    if (const auto fit = limit())
      {
        for (std::size_t k = 0; k < sizes.size(); ++k)
          all[k] = std::abs(values[k] + correction(k) - fit->limit) + of_finest;
        return all;
      }
    double farthest = 0.;
    for (std::size_t k = sizes.size(); k-- > 0;)
      {
        farthest = std::max(farthest, std::abs(values[k] - values.back()));
        all[k]   = farthest + of_finest;
      }
    return all;
  }

  bool ClimbAxis::is_trusted(const double allowed) const
  {
    if (known_orders && is_refined())
      {
        const auto  fit   = limit();
        const Trend trend = estimate().trend;
        return fit && values.size() >= fewest_of_a_test && fit->limit * values.back() > 0. &&
               (trend == Trend::settled || (!fit->rejects_order() && trend != Trend::diverging));
      }
    return !is_refined() || is_trusted_here(estimate()) || bar() <= small_bar * allowed;
  }

  double ClimbAxis::expected_gain() const
  {
    const GridConvergence made  = estimate();
    const double          order = std::isnan(made.order) ? 1. : std::clamp(made.order, 0.5, 2.);
    const double          ratio = sizes[sizes.size() - 2] / sizes.back();
    const double error = limit() ? bar() : std::isnan(made.bar) ? std::abs(values.back() - values.front()) : made.bar;
    return error * (1. - std::pow(ratio, -order));
  }

  std::optional<double> extrapolate_interaction(const ClimbAxis &bird, const ClimbAxis &mesh,
                                                const std::vector<SeenInteraction> &seen)
  {
    if (seen.empty())
      return std::nullopt;
    double least = std::numeric_limits<double>::infinity(), whole = 0.;
    for (const SeenInteraction &each : seen)
      {
        const double share = bird.share_beyond(each.levels.bird) * mesh.share_beyond(each.levels.mesh);
        if (share < least)
          whole = 0.;
        least = std::min(least, share);
        if (share == least && std::isfinite(share))
          whole = std::max(whole, share * each.size);
      }
    for (const SeenInteraction &each : seen)
      whole = std::max(whole, each.size);
    return whole;
  }

  std::string describe_interaction(const std::optional<double> interaction, const std::string &unit)
  {
    if (interaction)
      return "  What both together add to it: " + format_value(*interaction, unit) + ".\n";
    return "  Bird and mesh refined together were not run: the value is the sum of both ladders.\n";
  }

  std::string name_refinements(const ClimbAxis &bird, const ClimbAxis &mesh)
  {
    const std::string smaller = bird.is_refined() ? "a smaller Bird/Particle spacing" : "";
    const std::string more    = mesh.is_refined() ? "more Blade/Mesh/Elements along span and chord" : "";
    return smaller + (smaller.empty() || more.empty() ? "" : " and ") + more;
  }

  std::vector<ClimbChoice> find_choices(const ClimbAxis &bird, const ClimbAxis &mesh, const double allowed)
  {
    const std::vector<double> of_bird = bird.errors(), of_mesh = mesh.errors();
    std::vector<ClimbChoice>  choices;
    for (std::size_t i = bird.is_refined() ? 1 : 0; i < of_bird.size(); ++i)
      for (std::size_t j = mesh.is_refined() ? 1 : 0; j < of_mesh.size(); ++j)
        if (of_bird[i] + of_mesh[j] <= allowed)
          {
            choices.push_back({i, j});
            break;
          }
    return choices;
  }
} // namespace birdstrike
