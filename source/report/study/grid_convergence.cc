#include "report/study/grid_convergence.h"
#include "report/study/error_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

namespace birdstrike
{
  namespace
  {
    constexpr double absent               = std::numeric_limits<double>::quiet_NaN();
    constexpr double unchanged            = 1e-4; ///< of the value: below, an order would be one of round-off
    constexpr double lowest_order         = 0.5;
    constexpr double highest_order        = 2.;
    constexpr double highest_fitted_order = 2.1;
    constexpr double factor_of_safety = 1.25, factor_without_trust = 3.;
    constexpr double largest_ratio = 1.25; ///< of GCIs, or 1/1.25
    constexpr double same_order    = 0.5;

    /// r21^p (r32^p - s)/(r21^p - s); for p = 0 its limit.
    double ratio_of_changes(const double p, const double r21, const double r32, const double s)
    {
      return p == 0. && s > 0. ? std::log(r32) / std::log(r21)
                               : std::pow(r21, p) * (std::pow(r32, p) - s) / (std::pow(r21, p) - s);
    }

    /// Of four grids: whether both of their threes have one order.
    bool have_one_order(const std::span<const double> h, const std::span<const double> f)
    {
      const double fine   = compute_observed_order(f[0], f[1], f[2], h[1] / h[0], h[2] / h[1]),
                   coarse = compute_observed_order(f[1], f[2], f[3], h[2] / h[1], h[3] / h[2]);
      return is_monotone(f) && std::abs(fine - coarse) <= same_order; // false for NaN
    }

    void set_limit(GridConvergence &made, const double limit, const double f1)
    {
      made.extrapolated       = limit;
      made.extrapolated_error = std::abs((limit - f1) / limit);
    }

    /// The rest of an estimate of three grids whose order is there.
    void complete(GridConvergence &made, const std::span<const double> h, const std::span<const double> f)
    {
      const double r21 = h[1] / h[0], r32 = h[2] / h[1], p = std::clamp(made.order, lowest_order, highest_order);
      const double gci32 = std::abs(f[2] - f[1]) / std::abs(f[1]) / (std::pow(r32, p) - 1.),
                   gci21 = std::abs(f[1] - f[0]) / std::abs(f[0]) / (std::pow(r21, p) - 1.);
      made.ratio         = gci32 / (std::pow(r21, p) * gci21);
      const bool is_asymptotic =
        made.order >= lowest_order && made.ratio <= largest_ratio && made.ratio >= 1. / largest_ratio;
      made.trend = is_asymptotic ? Trend::asymptotic : Trend::not_asymptotic;
      set_limit(made, extrapolate(f[0], f[1], r21, p), f[0]);
      made.bar = (is_asymptotic ? factor_of_safety : factor_without_trust) * std::abs(made.extrapolated - f[0]);
    }

    void estimate_by_three(GridConvergence &made, const std::span<const double> h, const std::span<const double> f)
    {
      made.order = compute_observed_order(f[0], f[1], f[2], h[1] / h[0], h[2] / h[1]);
      if (made.change <= unchanged)
        made.trend = Trend::not_asymptotic; // the last change is none, and no power of h
      else if (std::isnan(made.order))
        {
          made.trend = Trend::diverging;
          made.bar   = absent;
        }
      else if (!is_monotone(f))
        made.trend = Trend::oscillating;
      else
        complete(made, h, f);
    }

    /// False where the sum of squares falls to an end of the orders: one grid stands alone.
    bool has_order(const ErrorFit &fit)
    {
      return std::abs(fit.order) < 0.999 * largest_order;
    }

    Trend trend_of(const ErrorFit &fit, const double range, const std::span<const double> h,
                   const std::span<const double> f)
    {
      const bool is_hidden = fit.deviation >= range;
      if (fit.order <= 0. && (fit.power_deviation < range || is_monotone(f)))
        return Trend::diverging;
      if (is_hidden)
        return is_monotone(f) ? Trend::not_asymptotic : Trend::scattered;
      const bool is_power = fit.order >= lowest_order && fit.order < highest_fitted_order;
      return is_power && (f.size() > 4 || have_one_order(h, f)) ? Trend::asymptotic : Trend::not_asymptotic;
    }

    void estimate_by_fit(GridConvergence &made, const std::span<const double> h, const std::span<const double> f)
    {
      const ErrorFit fit   = fit_error(h, f);
      const double   range = data_range(f);
      made.order           = has_order(fit) ? fit.order : absent;
      made.deviation       = fit.deviation;
      made.trend           = trend_of(fit, range, h, f);
      made.bar             = absent;
      if (made.trend == Trend::diverging)
        return;
      made.bar = uncertainty(fit, range, made.trend == Trend::asymptotic ? factor_of_safety : factor_without_trust);
      if (made.trend != Trend::scattered)
        set_limit(made, fit.limit, f[0]);
    }
  } // namespace

  double compute_observed_order(const double f1, const double f2, const double f3, const double r21, const double r32)
  {
    const double change = (f3 - f2) / (f2 - f1), s = change < 0. ? -1. : 1., wanted = std::abs(change);
    if (!std::isfinite(change) || wanted == 0.)
      return absent;
    double low = 0., high = 30.; // beyond, powers of 2 are lost in round-off
    if (!(std::abs(ratio_of_changes(low, r21, r32, s)) < wanted) || !(ratio_of_changes(high, r21, r32, s) > wanted))
      return absent;
    while (high - low > 1e-12 * high)
      {
        const double middle                                           = 0.5 * (low + high);
        (ratio_of_changes(middle, r21, r32, s) < wanted ? low : high) = middle;
      }
    return high;
  }

  double extrapolate(const double f1, const double f2, const double r21, const double p)
  {
    return f1 + (f1 - f2) / (std::pow(r21, p) - 1.);
  }

  std::string describe(const Trend trend)
  {
    switch (trend)
      {
      case Trend::asymptotic:
        return "converges";
      case Trend::not_asymptotic:
        return "not in the asymptotic range";
      case Trend::oscillating:
        return "oscillates";
      case Trend::scattered:
        return "scatters";
      case Trend::diverging:
        return "diverges";
      case Trend::settled:
        return "does not change";
      case Trend::unknown:
        return "a value is missing";
      }
    throw std::logic_error("no trend");
  }

  bool GridConvergence::is_trusted() const
  {
    return trend == Trend::asymptotic || trend == Trend::settled || trend == Trend::scattered;
  }

  std::string GridConvergence::method() const
  {
    if (n_fitted == 0)
      return "-";
    return n_fitted == 3 ? "three levels" : fmt::format("least squares over {} levels", n_fitted);
  }

  GridConvergence estimate_convergence(const std::span<const double> sizes, const std::span<const double> values)
  {
    if (sizes.size() < 3 || values.size() != sizes.size() || !std::ranges::is_sorted(sizes, std::less_equal<>()))
      throw std::logic_error("A convergence is that of three or more grids, from the finest on.");
    GridConvergence     made{Trend::unknown, absent, absent, absent, absent, absent, absent, absent, absent, 0};
    std::vector<double> h, f;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (std::isfinite(values[k]))
        {
          h.push_back(sizes[k]);
          f.push_back(values[k]);
        }
    if (!std::isfinite(values[0]) || f.size() < 3)
      return made;
    const double largest = std::max(std::abs(f[1] - f[0]), std::abs(f[2] - f[0]));
    made.change          = f[0] == f[1] ? 0. : std::abs((f[1] - f[0]) / f[0]);
    made.bar             = factor_without_trust * largest;
    made.n_fitted        = 3;
    if (largest <= unchanged * std::abs(f[0]))
      {
        made.order = compute_observed_order(f[0], f[1], f[2], h[1] / h[0], h[2] / h[1]);
        made.trend = Trend::settled;
      }
    else if (f.size() == 3)
      estimate_by_three(made, h, f);
    else
      {
        made.n_fitted = f.size();
        estimate_by_fit(made, h, f);
      }
    made.gci = made.bar == 0. ? 0. : made.bar / std::abs(f[0]);
    return made;
  }
} // namespace birdstrike
