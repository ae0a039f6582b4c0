#pragma once

#include <span>
#include <string>

/// The error of the finest of four or more grids by least squares, for values with scatter.
///
/// L. Eça, M. Hoekstra: A procedure for the estimation of the numerical uncertainty of CFD calculations based on grid
/// refinement studies, J. Comput. Phys. 262 (2014) 104-130, appendices A and B. The rules are as three independent
/// implementations of that paper have them, cfd-verify (Oak Ridge National Laboratory), meteor-cfd and that of pi-BEM,
/// but where another reading is named.
///
/// Grids are numbered from the finest, 1, on; h are their sizes, phi the values, n their number.
namespace birdstrike
{
  enum class Expansion
  {
    power,           ///< phi_0 + alpha h^p, p unknown
    first,           ///< phi_0 + alpha h
    second,          ///< phi_0 + alpha h^2
    first_and_second ///< phi_0 + alpha_1 h + alpha_2 h^2
  };

  constexpr std::size_t fewest_of_an_interval = 4;   ///< values; of three, Student's factor is 13
  constexpr double      largest_order         = 10.; ///< either way, of the orders that are looked at

  struct ErrorFit
  {
    Expansion expansion;
    double    order;           ///< p of the power, observed, also where another expansion is used; NaN: not looked for
    double    power_deviation; ///< sigma of that power
    double    limit;           ///< phi_0, of the values' unit
    double    error;           ///< of the finest grid, fit(h_1) - phi_0
    double    residual;        ///< phi_1 - fit(h_1)
    double    deviation;       ///< sigma = sqrt(n sum w_i (phi_i - fit(h_i))^2/(n - number of unknowns)), sum w_i = 1
  };

  /// One expansion by weights whose sum is 1; sizes in any unit.
  ///
  /// The sum of squares of a power is a function of p alone, as phi_0 and alpha follow linearly; its smallest value is
  /// looked for among orders up to `largest_order`, which stands for all beyond. At p = 0 the power is ln h: its limit
  /// and error are infinite.
  ///
  /// Throws std::logic_error where there are no more values than unknowns, or not as many sizes and weights as values.
  ErrorFit fit_expansion(Expansion expansion, std::span<const double> sizes, std::span<const double> values,
                         std::span<const double> weights);

  /// The fit with the smallest deviation, weighted by 1/h_i (sum 1) or all alike, of
  ///
  ///   powers with 0.5 <= p <= 2, where there is one
  ///   the first and the second order, where p of the better power is above 2
  ///   these and their sum, where it is below 0.5 and the values do not scatter about it
  ///
  /// They scatter where they go both ways and the deviation of the power is not below data_range(). The paper takes the
  /// sum there too, and through scatter it extrapolates scatter: of ladders of five sizes 1.2 apart that are scatter
  /// alone nine in ten bars were below 43 times the scatter, now below 17 times; none missed the truth before or since.
  ///
  /// A power in the range comes before one of smaller deviation outside, as meteor-cfd reads the paper; cfd-verify
  /// looks at the range of the one with the smaller deviation alone. meteor-cfd fits no power where the three finest
  /// values oscillate; here and in cfd-verify the deviation speaks for itself.
  ///
  /// Throws std::logic_error for fewer than four values.
  ErrorFit fit_error(std::span<const double> sizes, std::span<const double> values);

  /// Whether values go one way.
  bool is_monotone(std::span<const double> values);

  /// Delta = (max phi_i - min phi_i)/(n - 1): a deviation as large hides the trend.
  double data_range(std::span<const double> values);

  /// Half of the error bar of the finest grid's value, of its unit, for a data range above 0:
  ///
  ///   U = F |error| + sigma + |residual|                    where sigma < Delta
  ///   U = 3 sigma/Delta (|error| + sigma + |residual|)      else
  ///
  /// F = 1.25 where 0.5 <= p < 2.1 and sigma < Delta, else 3, is the caller's to choose.
  double uncertainty(const ErrorFit &fit, double range, double factor);

  /// An order that is known, or bounds of it.
  struct OrderRange
  {
    double low, high;

    std::string text() const; ///< "1", "1:2"
  };

  /// phi_0 of phi_0 + alpha h^p with a p that is known.
  struct KnownOrderFit
  {
    double limit;         ///< phi_0, of the values' unit; of a range the middle of the interval
    double half_interval; ///< of the 95 % confidence interval of phi_0
    double p_value;       ///< of the test of the order; NaN of three values; of a range the largest

    bool rejects_order() const; ///< p_value below 5 %
  };

  /// By least squares, all values alike: the interval of a straight line's intercept over x = h^p,
  ///
  ///   t s sqrt(1/n + mean(x)^2/sum (x_i - mean(x))^2),  s^2 = sum (phi_i - fit(h_i))^2/(n - 2),
  ///
  /// t Student's 97.5 % quantile of n - 2 degrees of freedom (N. Draper, H. Smith: Applied regression analysis, Wiley
  /// 1998, section 1.4). It holds scatter alone: a wrong order is in no interval. The order is tested by a third term,
  /// beta x ln x, which is what a slightly different power adds (G. Box, P. Tidwell: Transformation of the independent
  /// variables, Technometrics 4 (1962) 531): p_value is that of beta = 0, of Student's t with n - 3 degrees of freedom.
  ///
  /// Throws std::logic_error for fewer than three values, another number of sizes, or an order that is not positive.
  KnownOrderFit fit_known_order(double order, std::span<const double> sizes, std::span<const double> values);

  /// The interval from the lowest to the highest end of those of all orders of a range that are not rejected, where all
  /// are of all: also what the order may be is in it. Of one order that order's own.
  KnownOrderFit fit_order_range(const OrderRange &orders, std::span<const double> sizes,
                                std::span<const double> values);
} // namespace birdstrike
