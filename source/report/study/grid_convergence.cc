#include "report/study/grid_convergence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace birdstrike
{
  namespace
  {
    constexpr double absent           = std::numeric_limits<double>::quiet_NaN();
    constexpr double unchanged        = 1e-4; ///< of the value: below, an order would be one of round-off
    constexpr double lowest_order     = 0.5;
    constexpr double highest_order    = 2.;
    constexpr double factor_of_safety = 1.25, factor_without_trust = 3.;
    constexpr double largest_ratio = 1.25; ///< of GCIs, or 1/1.25
    constexpr double same_order    = 0.5;

    /// r21^p (r32^p - s)/(r21^p - s); for p = 0 its limit.
    double ratio_of_changes(const double p, const double r21, const double r32, const double s)
    {
      return p == 0. && s > 0. ? std::log(r32) / std::log(r21)
                               : std::pow(r21, p) * (std::pow(r32, p) - s) / (std::pow(r21, p) - s);
    }

    bool agrees_with_fourth(const std::span<const double> h, const std::span<const double> f, const double order)
    {
      if (h.size() < 4)
        return true;
      const double before = compute_observed_order(f[1], f[2], f[3], h[2] / h[1], h[3] / h[2]);
      return std::abs(before - order) <= same_order; // false for NaN
    }

    /// The rest of an estimate whose order is there.
    void complete(GridConvergence &made, const std::span<const double> h, const std::span<const double> f)
    {
      const double r21 = h[1] / h[0], r32 = h[2] / h[1], p = std::clamp(made.order, lowest_order, highest_order);
      const double gci32       = std::abs(f[2] - f[1]) / std::abs(f[1]) / (std::pow(r32, p) - 1.),
                   gci21       = std::abs(f[1] - f[0]) / std::abs(f[0]) / (std::pow(r21, p) - 1.);
      made.ratio               = gci32 / (std::pow(r21, p) * gci21);
      const bool is_asymptotic = made.order >= lowest_order && made.ratio <= largest_ratio &&
                                 made.ratio >= 1. / largest_ratio && agrees_with_fourth(h, f, made.order);
      made.trend              = is_asymptotic ? Trend::asymptotic : Trend::not_asymptotic;
      made.extrapolated       = extrapolate(f[0], f[1], r21, p);
      made.extrapolated_error = std::abs((made.extrapolated - f[0]) / made.extrapolated);
      made.bar = (is_asymptotic ? factor_of_safety : factor_without_trust) * std::abs(made.extrapolated - f[0]);
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
    return trend == Trend::asymptotic || trend == Trend::settled;
  }

  GridConvergence estimate_convergence(const std::span<const double> sizes, const std::span<const double> values)
  {
    if (sizes.size() < 3 || values.size() != sizes.size() || !std::ranges::is_sorted(sizes, std::less_equal<>()))
      throw std::logic_error("A convergence is that of three or more grids, from the finest on.");
    GridConvergence made{Trend::unknown, absent, absent, absent, absent, absent, absent, absent};
    const double    f1 = values[0], f2 = values[1], f3 = values[2];
    if (!std::isfinite(f1) || !std::isfinite(f2) || !std::isfinite(f3))
      return made;
    const double largest = std::max(std::abs(f2 - f1), std::abs(f3 - f1));
    made.change          = f1 == f2 ? 0. : std::abs((f2 - f1) / f1);
    made.order           = compute_observed_order(f1, f2, f3, sizes[1] / sizes[0], sizes[2] / sizes[1]);
    made.bar             = factor_without_trust * largest;
    if (largest <= unchanged * std::abs(f1))
      made.trend = Trend::settled;
    else if (made.change <= unchanged)
      made.trend = Trend::not_asymptotic; // the last change is none, and no power of h
    else if (std::isnan(made.order))
      {
        made.trend = Trend::diverging;
        made.bar   = absent;
      }
    else if ((f3 - f2) * (f2 - f1) < 0.)
      made.trend = Trend::oscillating;
    else
      complete(made, sizes, values);
    made.gci = made.bar == 0. ? 0. : made.bar / std::abs(f1);
    return made;
  }
} // namespace birdstrike
