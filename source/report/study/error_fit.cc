#include "report/study/error_fit.h"

#include <Eigen/Dense>

#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace birdstrike
{
  namespace
  {
    constexpr double absent       = std::numeric_limits<double>::quiet_NaN();
    constexpr double lowest_order = 0.5, highest_order = 2.;
    constexpr int    n_orders             = 200; ///< on either side of zero
    constexpr double factor_without_trend = 3.;
    constexpr double significance         = 0.05;
    constexpr int    n_orders_of_range    = 20;
    constexpr double round_off            = 1e-12; ///< of changes: what is left of values that are a power

    using Values = Eigen::Map<const Eigen::VectorXd>;

    Values as_vector(const std::span<const double> values)
    {
      return {values.data(), static_cast<Eigen::Index>(values.size())};
    }

    int n_unknowns(const Expansion expansion)
    {
      return expansion == Expansion::first || expansion == Expansion::second ? 2 : 3;
    }

    /// (x^p - 1)/p, ln x at p = 0: spans the same as x^p beside a constant, and is smooth in p.
    Eigen::VectorXd power_of(const Eigen::VectorXd &x, const double p)
    {
      return x.unaryExpr(
        [p](const double each) { return p == 0. ? std::log(each) : std::expm1(p * std::log(each)) / p; });
    }

    /// Coefficients of a constant and the columns, and what they leave.
    struct LinearFit
    {
      Eigen::VectorXd coefficients, residuals;
      double          sum; ///< of squares, weighted
    };

    LinearFit solve(const Eigen::MatrixXd &columns, const Eigen::VectorXd &phi, const Eigen::VectorXd &weights)
    {
      Eigen::MatrixXd matrix(columns.rows(), columns.cols() + 1);
      matrix << Eigen::VectorXd::Ones(columns.rows()), columns;
      const Eigen::VectorXd roots = weights.cwiseSqrt();
      LinearFit             made;
      made.coefficients = (roots.asDiagonal() * matrix).colPivHouseholderQr().solve(roots.cwiseProduct(phi));
      made.residuals    = phi - matrix * made.coefficients;
      made.sum          = weights.dot(made.residuals.cwiseAbs2());
      return made;
    }

    /// Where a function of one minimum in between is smallest: golden section.
    template <typename Function>
    double find_smallest(const Function &function, double low, double high)
    {
      constexpr double share = 1. / std::numbers::phi;
      while (high - low > 1e-13 * largest_order)
        {
          const double left = high - share * (high - low), right = low + share * (high - low);
          if (function(left) < function(right))
            high = right;
          else
            low = left;
        }
      return 0.5 * (low + high);
    }

    /// Of the smallest sum of squares: there may be several, so that all orders are looked at first.
    double find_order(const Eigen::VectorXd &x, const Eigen::VectorXd &phi, const Eigen::VectorXd &weights)
    {
      const auto sum_at = [&](const double p) { return solve(power_of(x, p), phi, weights).sum; };
      double     best = 0., smallest = std::numeric_limits<double>::infinity();
      for (int k = -n_orders; k <= n_orders; ++k)
        if (const double p = largest_order * k / n_orders, sum = sum_at(p); sum < smallest)
          {
            best     = p;
            smallest = sum;
          }
      const double step = largest_order / n_orders;
      return find_smallest(sum_at, std::max(best - step, -largest_order), std::min(best + step, largest_order));
    }

    /// Without the constant; `order` is that of a power.
    Eigen::MatrixXd columns_of(const Expansion expansion, const Eigen::VectorXd &x, const double order)
    {
      switch (expansion)
        {
        case Expansion::power:
          return power_of(x, order);
        case Expansion::first:
          return x;
        case Expansion::second:
          return x.cwiseAbs2();
        case Expansion::first_and_second:
          {
            Eigen::MatrixXd both(x.size(), 2);
            both << x, x.cwiseAbs2();
            return both;
          }
        }
      throw std::logic_error("no expansion");
    }

    /// Of beta = 0 in phi_0 + alpha x + beta x ln x, where phi_0 + alpha x leaves `sum` of squares.
    double test_power(const Eigen::VectorXd &x, const Eigen::VectorXd &phi, const double sum)
    {
      const double freedom = static_cast<double>(x.size()) - 3.;
      if (freedom < 1.)
        return absent;
      if (std::sqrt(sum) <= round_off * (phi.maxCoeff() - phi.minCoeff()))
        return 1.;
      Eigen::MatrixXd both(x.size(), 2);
      both << x, x.cwiseProduct(x.array().log().matrix());
      const double with_it = solve(both, phi, Eigen::VectorXd::Ones(x.size())).sum;
      const double t       = std::sqrt(std::max(sum - with_it, 0.) / (with_it / freedom)); // infinite where it is exact
      return 2. * boost::math::cdf(boost::math::complement(boost::math::students_t(freedom), t));
    }

    bool is_in_range(const ErrorFit &fit)
    {
      return fit.order >= lowest_order && fit.order <= highest_order;
    }

    /// With the smallest deviation.
    const ErrorFit &best_of(const std::span<const ErrorFit> fits)
    {
      return *std::ranges::min_element(fits, {}, &ErrorFit::deviation);
    }
  } // namespace

  ErrorFit fit_expansion(const Expansion expansion, const std::span<const double> sizes,
                         const std::span<const double> values, const std::span<const double> weights)
  {
    const int n = static_cast<int>(values.size()), unknowns = n_unknowns(expansion);
    if (n <= unknowns || sizes.size() != values.size() || weights.size() != values.size())
      throw std::logic_error("A fit takes more values than it has unknowns, with a size and a weight each.");
    const Eigen::VectorXd x = as_vector(sizes) / sizes[0], w = as_vector(weights);
    const Eigen::VectorXd phi      = as_vector(values).array() - values[0]; // round-off is that of changes
    const bool            is_power = expansion == Expansion::power;
    const double          order    = is_power ? find_order(x, phi, w) : absent;
    const LinearFit       fit      = solve(columns_of(expansion, x, order), phi, w);
    // At h_1, x = 1: the power's column is zero there and -1/p at h = 0; those of the others are 1 and 0.
    const double of_columns = fit.coefficients.tail(fit.coefficients.size() - 1).sum();
    const double error      = is_power ? of_columns / order : of_columns;
    const double deviation  = std::sqrt(n * fit.sum / (n - unknowns));
    return {expansion,        order,    is_power ? deviation : absent, values[0] - fit.residuals[0] - error, error,
            fit.residuals[0], deviation};
  }

  ErrorFit fit_error(const std::span<const double> sizes, const std::span<const double> values)
  {
    const double        n = static_cast<double>(values.size());
    std::vector<double> alike(values.size(), 1. / n), by_size;
    double              sum = 0.;
    for (const double size : sizes)
      sum += 1. / size;
    for (const double size : sizes)
      by_size.push_back(1. / size / sum);
    std::vector<ErrorFit> fits;
    const auto            add = [&](const Expansion expansion) {
      for (const auto &weights : {alike, by_size})
        fits.push_back(fit_expansion(expansion, sizes, values, weights));
    };
    add(Expansion::power);
    const auto outside = std::ranges::stable_partition(fits, is_in_range);
    if (outside.begin() != fits.begin())
      return best_of({fits.begin(), outside.begin()});
    const ErrorFit power = best_of(fits);
    fits.clear();
    add(Expansion::first);
    add(Expansion::second);
    if (power.order < lowest_order && (is_monotone(values) || power.deviation < data_range(values)))
      add(Expansion::first_and_second);
    ErrorFit best        = best_of(fits);
    best.order           = power.order;
    best.power_deviation = power.power_deviation;
    return best;
  }

  bool is_monotone(const std::span<const double> values)
  {
    return std::ranges::is_sorted(values, std::less<>()) || std::ranges::is_sorted(values, std::greater<>());
  }

  double data_range(const std::span<const double> values)
  {
    const auto [smallest, largest] = std::ranges::minmax(values);
    return (largest - smallest) / static_cast<double>(values.size() - 1);
  }

  bool KnownOrderFit::rejects_order() const
  {
    return p_value < significance;
  }

  KnownOrderFit fit_known_order(const double order, const std::span<const double> sizes,
                                const std::span<const double> values)
  {
    const std::size_t n = values.size();
    if (n < 3 || sizes.size() != n || !(order > 0.))
      throw std::logic_error("A limit takes three values, with a size each, and a positive order.");
    const double          freedom = static_cast<double>(n) - 2.;
    const Eigen::VectorXd x = as_vector(sizes).unaryExpr([&](const double h) { return std::pow(h / sizes[0], order); });
    const Eigen::VectorXd phi   = as_vector(values).array() - values[0]; // round-off is that of changes
    const LinearFit       fit   = solve(x, phi, Eigen::VectorXd::Ones(x.size()));
    const double          mean  = x.mean();
    const double          share = 1. / static_cast<double>(n) + mean * mean / (x.array() - mean).square().sum();
    const double          t     = boost::math::quantile(boost::math::students_t(freedom), 0.975);
    return {values[0] + fit.coefficients[0], t * std::sqrt(fit.sum / freedom * share), test_power(x, phi, fit.sum)};
  }

  std::string OrderRange::text() const
  {
    return low == high ? fmt::format("{:g}", low) : fmt::format("{:g}:{:g}", low, high);
  }

  KnownOrderFit fit_order_range(const OrderRange &orders, const std::span<const double> sizes,
                                const std::span<const double> values)
  {
    if (orders.low == orders.high)
      return fit_known_order(orders.low, sizes, values);
    std::vector<KnownOrderFit> fits;
    for (int k = 0; k <= n_orders_of_range; ++k)
      fits.push_back(fit_known_order(orders.low + (orders.high - orders.low) * k / n_orders_of_range, sizes, values));
    const auto   kept = std::ranges::stable_partition(fits, [](const auto &fit) { return !fit.rejects_order(); });
    const auto   end  = kept.begin() == fits.begin() ? fits.end() : kept.begin();
    double       low = std::numeric_limits<double>::infinity(), high = -low;
    const double p_value = std::ranges::max_element(fits, {}, &KnownOrderFit::p_value)->p_value;
    for (auto fit = fits.begin(); fit != end; ++fit)
      {
        low  = std::min(low, fit->limit - fit->half_interval);
        high = std::max(high, fit->limit + fit->half_interval);
      }
    return {0.5 * (low + high), 0.5 * (high - low), p_value};
  }

  double uncertainty(const ErrorFit &fit, const double range, const double factor)
  {
    const double rest = fit.deviation + std::abs(fit.residual);
    return fit.deviation < range ? factor * std::abs(fit.error) + rest
                                 : factor_without_trend * fit.deviation / range * (std::abs(fit.error) + rest);
  }
} // namespace birdstrike
