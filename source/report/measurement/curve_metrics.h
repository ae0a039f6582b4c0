#pragma once

#include <span>

/// How near a computed curve is to a measured one. Both hold samples at the same equally spaced times (or places); the
/// measured one is the reference, so that exchanging them changes the figures. Raises std::invalid_argument for curves
/// of different lengths, of fewer than 10 samples, or a measured one that is zero everywhere.
namespace birdstrike
{
  /// Integral comparison of M. A. Sprague and T. L. Geers, "A spectral-element method for modelling cavitation in
  /// transient fluid-structure interaction", Int. J. Numer. Meth. Eng. 60 (2004) 2467-2499, with m measured, c
  /// computed:
  ///   M = sqrt(int c^2/int m^2) - 1,  P = acos(int m c/sqrt(int m^2 int c^2))/pi,  C = sqrt(M^2 + P^2).
  /// M does not see a shift in time, P no factor: P is 0 for curves of one shape and 1 for opposite ones.
  struct SpragueGeers
  {
    double magnitude = 0., phase = 0., comprehensive = 0.;
  };
  SpragueGeers compute_sprague_geers(std::span<const double> measured, std::span<const double> computed);

  /// ISO/TS 18571:2014, "Road vehicles - Objective rating metric for non-ambiguous signals": scores from 0 to 1.
  ///   corridor   Z = mean of 1 within 0.05 max|m| of the measured curve, 0 beyond 0.5 max|m|, between them
  ///              ((0.5 max|m| - |c - m|)/(0.45 max|m|))^2
  ///   phase      E_P = 1 - n/(0.2 N) with the shift of n samples, at most a fifth of all N, at which the correlation
  ///              coefficient of what overlaps is largest (the smallest such shift)
  ///   magnitude  E_M = 1 - e/0.5, e = |c_w - m_w|_1/|m_w|_1 of the curves thus shifted and then warped upon one
  ///   another
  ///              (dynamic time warping within a tenth of their length, squared differences)
  ///   slope      E_S = 1 - e/2, e = |c' - m'|_1/|m'|_1 of the shifted curves' central differences, each the mean of
  ///              nine (of seven, five, three and one towards the ends)
  ///   overall    R = 0.4 Z + 0.2 E_P + 0.2 E_M + 0.2 E_S
  /// Scores below zero are zero. The standard itself was not at hand: formulas and constants are those in which two
  /// open implementations that name it agree (they differ in the norm of e, of which that of absolute values is taken,
  /// as in its forerunner EEARTH: Z. Zhan, Y. Fu and R.-J. Yang, SAE 2011-01-0245). It asks for signals at 10 kHz of
  /// some tenth of a second; the number of samples is what counts.
  struct IsoRating
  {
    double corridor = 0., phase = 0., magnitude = 0., slope = 0., overall = 0.;

    /// Words of its table: R above 0.94 excellent, above 0.80 good, above 0.58 fair, else poor.
    const char *grade() const;
  };
  IsoRating compute_iso_rating(std::span<const double> measured, std::span<const double> computed);
} // namespace birdstrike
