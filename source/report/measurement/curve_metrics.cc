#include "report/measurement/curve_metrics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace birdstrike
{
  namespace
  {
    using Curve = std::span<const double>;

    void check(const Curve measured, const Curve computed)
    {
      if (measured.size() != computed.size() || measured.size() < 10)
        throw std::invalid_argument(
          "Curves are compared by at least ten samples each, as many of one as of the other.");
      if (std::ranges::all_of(measured, [](const double y) { return y == 0.; }))
        throw std::invalid_argument("The measured curve is zero everywhere: nothing can be compared with it.");
    }

    double product(const Curve a, const Curve b)
    {
      double sum = 0.;
      for (std::size_t k = 0; k < a.size(); ++k)
        sum += a[k] * b[k] * (k == 0 || k + 1 == a.size() ? 0.5 : 1.);
      return sum;
    }

    double score(const double error, const double largest)
    {
      return std::max(0., 1. - error / largest);
    }

    /// |a - b|_1/|b|_1; curves without any slope agree.
    double difference(const Curve a, const Curve b)
    {
      double apart = 0., size = 0.;
      for (std::size_t k = 0; k < a.size(); ++k)
        {
          apart += std::abs(a[k] - b[k]);
          size += std::abs(b[k]);
        }
      return apart == 0. ? 0. : apart / size;
    }

    double rate_corridor(const Curve measured, const Curve computed)
    {
      constexpr double inner = 0.05, outer = 0.5; // of the largest value
      double           largest = 0., sum = 0.;
      for (const double y : measured)
        largest = std::max(largest, std::abs(y));
      for (std::size_t k = 0; k < measured.size(); ++k)
        {
          const double rest =
            std::clamp((outer - std::abs(computed[k] - measured[k]) / largest) / (outer - inner), 0., 1.);
          sum += rest * rest;
        }
      return sum / double(measured.size());
    }

    constexpr double no_change    = 1e-12; ///< of its mean: a curve that changes by less is constant
    constexpr double no_advantage = 1e-9;  ///< of a correlation: round-off, and what a file rounds

    /// Normalised cross-correlation about the means; -1 where one of the curves is constant.
    double correlate(const Curve a, const Curve b)
    {
      const double n = double(a.size()), mean_a = std::accumulate(a.begin(), a.end(), 0.) / n,
                   mean_b = std::accumulate(b.begin(), b.end(), 0.) / n;
      double ab = 0., aa = 0., bb = 0.;
      for (std::size_t k = 0; k < a.size(); ++k)
        {
          ab += (a[k] - mean_a) * (b[k] - mean_b);
          aa += (a[k] - mean_a) * (a[k] - mean_a);
          bb += (b[k] - mean_b) * (b[k] - mean_b);
        }
      const auto is_constant = [n](const double variation, const double mean) {
        return variation <= n * std::pow(no_change * mean, 2);
      };
      return is_constant(aa, mean_a) || is_constant(bb, mean_b) ? -1. : ab / std::sqrt(aa * bb);
    }

    constexpr double largest_shift = 0.2;

    struct Shifted
    {
      Curve       measured, computed;
      std::size_t n; ///< samples
    };

    /// A computed curve that comes late is looked at first: of equal correlations the smallest shift to the left
    /// counts. Straight lines, exponentials and periods correlate by 1 with what they are shifted by.
    Shifted shift(const Curve measured, const Curve computed)
    {
      Shifted    best{measured, computed, 0};
      double     highest = correlate(measured, computed);
      const auto n_most  = static_cast<std::size_t>(largest_shift * double(measured.size()));
      for (std::size_t n = 1; n <= n_most; ++n)
        for (const bool is_late : {true, false})
          {
            const std::size_t rest = measured.size() - n;
            const Shifted     now{measured.subspan(is_late ? 0 : n, rest), computed.subspan(is_late ? n : 0, rest), n};
            if (const double found = correlate(now.measured, now.computed); found > highest + no_advantage)
              {
                highest = found;
                best    = now;
              }
          }
      return best;
    }

    /// Dynamic time warping (Sakoe and Chiba 1978) with steps (1, 0), (0, 1), (1, 1) of weight one.
    double compute_warped_difference(const Curve measured, const Curve computed)
    {
      const std::size_t n = measured.size();
      // strictly less than a tenth of the length apart
      const auto          width    = static_cast<std::size_t>(std::ceil(0.1 * double(n))) - 1;
      constexpr double    infinity = std::numeric_limits<double>::infinity();
      std::vector<double> cost(n * n, infinity);
      const auto          at = [&](const std::size_t i, const std::size_t j) -> double          &{ return cost[i * n + j]; };
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i > width ? i - width : 0; j < std::min(n, i + width + 1); ++j)
          {
            const double before = std::min({i > 0 ? at(i - 1, j) : infinity, j > 0 ? at(i, j - 1) : infinity,
                                            i > 0 && j > 0 ? at(i - 1, j - 1) : infinity});
            const double apart  = computed[i] - measured[j];
            at(i, j)            = apart * apart + (i + j > 0 ? before : 0.);
          }
      std::vector<double> c, m;
      for (std::size_t i = n - 1, j = n - 1;;)
        {
          c.push_back(computed[i]);
          m.push_back(measured[j]);
          if (i == 0 && j == 0)
            return difference(c, m);
          const double diagonal = i > 0 && j > 0 ? at(i - 1, j - 1) : infinity, up = i > 0 ? at(i - 1, j) : infinity,
                       left      = j > 0 ? at(i, j - 1) : infinity;
          const bool is_diagonal = diagonal <= std::min(up, left), is_up = !is_diagonal && up <= left;
          i -= is_diagonal || is_up ? 1 : 0;
          j -= is_diagonal || !is_up ? 1 : 0;
        }
    }

    /// Slopes over a unit step, smoothed.
    std::vector<double> compute_slopes(const Curve y)
    {
      const std::size_t   n = y.size();
      std::vector<double> raw(n), smooth(n);
      for (std::size_t k = 0; k < n; ++k)
        {
          const std::size_t before = k > 0 ? k - 1 : 0, after = std::min(k + 1, n - 1);
          raw[k] = (y[after] - y[before]) / double(after - before);
        }
      for (std::size_t k = 0; k < n; ++k)
        {
          const std::size_t half = std::min({std::size_t(4), k, n - 1 - k});
          smooth[k] =
            std::accumulate(raw.begin() + std::ptrdiff_t(k - half), raw.begin() + std::ptrdiff_t(k + half + 1), 0.) /
            double(2 * half + 1);
        }
      return smooth;
    }
  } // namespace

  SpragueGeers compute_sprague_geers(const std::span<const double> measured, const std::span<const double> computed)
  {
    check(measured, computed);
    const double mm = product(measured, measured), cc = product(computed, computed);
    SpragueGeers result;
    result.magnitude = std::sqrt(cc / mm) - 1.;
    // of parallel curves the cosine may be 1 + 1e-16, and acos(1 - 1e-16) is 1e-8: they are told by their difference
    double apart = 0.;
    for (std::size_t k = 0; k < measured.size() && cc > 0.; ++k)
      {
        const double d = computed[k] / std::sqrt(cc) - measured[k] / std::sqrt(mm);
        apart += d * d * (k == 0 || k + 1 == measured.size() ? 0.5 : 1.);
      }
    // |u - v| = 2 sin(angle/2) of unit vectors; a computed curve that is zero everywhere is at a right angle
    result.phase         = cc > 0. ? 2. * std::asin(std::min(1., 0.5 * std::sqrt(apart))) / std::numbers::pi : 0.5;
    result.comprehensive = std::hypot(result.magnitude, result.phase);
    return result;
  }

  const char *IsoRating::grade() const
  {
    return overall > 0.94 ? "excellent" : overall > 0.80 ? "good" : overall > 0.58 ? "fair" : "poor";
  }

  IsoRating compute_iso_rating(const std::span<const double> measured, const std::span<const double> computed)
  {
    check(measured, computed);
    const Shifted shifted = shift(measured, computed);
    IsoRating     rating;
    rating.corridor  = rate_corridor(measured, computed);
    rating.phase     = score(double(shifted.n), largest_shift * double(measured.size()));
    rating.magnitude = score(compute_warped_difference(shifted.measured, shifted.computed), 0.5);
    rating.slope     = score(difference(compute_slopes(shifted.computed), compute_slopes(shifted.measured)), 2.);
    rating.overall   = 0.4 * rating.corridor + 0.2 * (rating.phase + rating.magnitude + rating.slope);
    return rating;
  }
} // namespace birdstrike
