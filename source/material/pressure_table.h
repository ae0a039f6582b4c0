#pragma once

#include <birdstrike/core/number.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// Pressure of a compression mu = rho/rho0 - 1 by cubics between points (Hermite), with slope and energy of the same
  /// cubics, so that what density stores is exactly what pressure has done. Below zero and beyond the last point the
  /// pressure goes on with its slope there. Monotone, with a slope above zero everywhere, where the slopes at both ends
  /// of a piece are between 0 and three times its secant (Fritsch & Carlson 1980). Uniform bins lead to the piece.
  class PressureTable
  {
  public:
    struct Point
    {
      double mu, pressure, slope; ///< -, Pa, Pa: dp/dmu
    };

    /// At least two points of growing mu and pressure, the first at (0, 0).
    explicit PressureTable(const std::vector<Point> &points);

    /// Slopes for points that have none: inside, the weighted harmonic mean of both secants (Fritsch & Butland 1984),
    /// second order and below three times either; at zero secant^2 over the slope at the other end, and at the last
    /// point 2 secant - slope, where these lie between half a secant and two, else those without curvature.
    static void choose_slopes(std::vector<Point> &points);

    double pressure(double mu) const; ///< Pa
    double slope(double mu) const;    ///< dp/dmu, Pa
    Lanes  pressure(Lanes mu) const;
    Lanes  slope(Lanes mu) const;

    /// Integral of p/(1 + m)^2 dm from 0 to mu, Pa: by Gauss, 8 points a piece, to round-off for pieces that are
    /// shorter than half their 1 + mu (1e-12 up to a whole one), in closed form where p is straight.
    double energy(double mu) const;

    double last_mu() const
    {
      return pieces.back().start;
    }

  private:
    struct Piece
    {
      double start;                     ///< mu
      double value, first, half, sixth; ///< p = value + s (first + s (half + s sixth)), s = mu - start
      double stored;                    ///< the integral up to start
    };

    std::size_t find(double mu) const;

    std::vector<Piece>         pieces; ///< tension, those between points, what lies beyond
    std::vector<std::uint16_t> first_in_bin;
    double                     bins_per_mu = 0.;
  };
} // namespace birdstrike
