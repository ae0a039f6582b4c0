#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// How far a value on a finite grid may be from that on an infinitely fine one.
///
/// I. Celik, U. Ghia, P. Roache, C. Freitas, H. Coleman, P. Raad: Procedure for estimation and reporting of uncertainty
/// due to discretization in CFD applications, J. Fluids Eng. 130 (2008) 078001; P. Roache: Perspective: a method for
/// uniform reporting of grid refinement studies, J. Fluids Eng. 116 (1994) 405; factors of safety where the observed
/// order is not the method's: W. Oberkampf, C. Roy: Verification and validation in scientific computing, Cambridge
/// (2010), section 8.7. Four or more grids by least squares: report/study/error_fit.h.
///
/// Grids are numbered from the finest, 1, on; r21 = h2/h1 > 1 is a ratio of sizes, e32 = f3 - f2 a change.
namespace birdstrike
{
  /// The order p > 0 with  e32/e21 = r21^p (r32^p - s)/(r21^p - s),  s = sign(e32/e21):  Celik's equation (3), whose
  /// right-hand side grows with p, so that it has one root or none. NaN where there is none (changes grow from grid to
  /// grid as no power of h does) or a change is zero.
  double compute_observed_order(double f1, double f2, double f3, double r21, double r32);

  /// (r21^p f1 - f2)/(r21^p - 1), Richardson's value, whose leading error is gone.
  double extrapolate(double f1, double f2, double r21, double p);

  enum class Trend
  {
    asymptotic,     ///< the values come closer as a power of h does, and the grids agree on it
    not_asymptotic, ///< they come closer, but not yet, or not by a power that the method has
    oscillating,    ///< changes alternate
    scattered,      ///< a fit of four or more leaves more scatter than trend: about one level, as far as can be seen
    diverging,      ///< changes grow
    settled,        ///< all changes are below `unchanged`
    unknown         ///< a value is missing
  };

  std::string describe(Trend trend);

  struct GridConvergence
  {
    Trend       trend = Trend::unknown;
    double      order;              ///< observed, p; NaN: none
    double      extrapolated;       ///< the limit by the order that is used; NaN: none
    double      change;             ///< |f2 - f1|/|f1|
    double      extrapolated_error; ///< |f_ext - f1|/|f_ext|
    double      gci;                ///< grid convergence index of the finest grid, bar/|f1|
    double      bar;       ///< half of the error bar of the finest grid's value, of its unit; NaN: none can be given
    double      ratio;     ///< GCI32/(r21^p GCI21), 1 in the asymptotic range; NaN: not of three grids
    double      deviation; ///< standard deviation of the fit, of the values' unit; NaN: not by least squares
    std::size_t n_fitted;  ///< grids that the estimate is of; 0: none

    bool is_trusted() const; ///< asymptotic, settled or scattered: what is left to go is in the bar, or the scatter

    std::string method() const; ///< "three levels", "least squares over 5 levels"; "-": no estimate
  };

  /// `sizes` and `values` from the finest on; grids whose value is NaN are left out, the finest apart: nothing can be
  /// said without it, or without two others.
  ///
  /// Three grids: the order that is used is the observed one between 0.5 and 2, that of elements, particles and time
  /// steps for smooth answers. The bar is
  ///
  ///   F |f2 - f1|/(r21^p - 1),  F = 1.25 in the asymptotic range, else 3
  ///
  /// and where there is no order 3 max(|f2 - f1|, |f3 - f1|), none where changes grow. The range is asymptotic where
  /// the observed order is 0.5 at least and GCI32/(r21^p GCI21) lies between 0.8 and 1.25 with the order that is used.
  ///
  /// Four and more: the bar is U of error_fit.h, with sigma and Delta from there. The range is asymptotic, and F is
  /// 1.25, where the fitted order is from 0.5 to 2.1 and sigma < Delta. With four grids, which leave the fit of a power
  /// one degree of freedom, so that its sigma says little, changes must also be of one sign and the orders of grids 1,
  /// 2, 3 and 2, 3, 4 within 0.5: stricter than the paper. Grids diverge, without a bar, where the fitted order is 0 or
  /// less and either that power's sigma < Delta or the changes are of one sign; else they scatter where sigma >= Delta
  /// and signs alternate, with the bar of that case, three times at least what it counts.
  ///
  /// The three finest within 1e-4 of each other have settled, whatever coarser ones do: the bar is 3 max(|f2 - f1|,
  /// |f3 - f1|).
  ///
  /// Throws std::logic_error for fewer than three grids or sizes that do not grow.
  GridConvergence estimate_convergence(std::span<const double> sizes, std::span<const double> values);
} // namespace birdstrike
