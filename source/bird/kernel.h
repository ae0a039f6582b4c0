#pragma once

#include <birdstrike/core/number.h>

#include <numbers>

namespace birdstrike
{
  /// Wendland C2 in three dimensions (Wendland 1995; Dehnen & Aly 2012), q = r/h < 2:
  ///   W = 21/(16 pi h^3) (1 - q/2)^4 (2q + 1),   -W'/r = 105/(16 pi h^5) (1 - q/2)^3.
  /// Lengths in m, W in 1/m^3, slope() = -W'/r in 1/m^5: grad_i W_ij = -slope * (x_i - x_j), without division by r.
  struct WendlandC2
  {
    explicit WendlandC2(const double h)
      : inverse_h(1. / h), norm(21. / (16. * std::numbers::pi * h * h * h)), slope_norm(5. * norm / (h * h))
    {
    }

    template <class Number>
    Number value(const Number &r) const
    {
      const Number q = r * inverse_h, t = max(1. - 0.5 * q, Number(0.)), t2 = t * t;
      return norm * t2 * t2 * (2. * q + 1.);
    }
    template <class Number>
    Number slope(const Number &r) const
    {
      const Number t = max(1. - (0.5 * inverse_h) * r, Number(0.));
      return slope_norm * t * t * t;
    }

    double inverse_h, norm, slope_norm;
  };

  /// Cubic spline M4 (Monaghan & Lattanzio 1985), q = r/h < 2, written as a difference of two cubes, s = 1/(4 pi h^3):
  ///   W = s [(2 - q)_+^3 - 4 (1 - q)_+^3],   -W'/r = 3 s/(h^2 q) [(2 - q)_+^2 - 4 (1 - q)_+^2].
  struct CubicSpline
  {
    explicit CubicSpline(const double h)
      : inverse_h(1. / h), norm(1. / (4. * std::numbers::pi * h * h * h)), slope_norm(3. * norm / (h * h))
    {
    }

    template <class Number>
    Number value(const Number &r) const
    {
      const Number q = r * inverse_h, a = max(2. - q, Number(0.)), b = max(1. - q, Number(0.));
      return norm * (a * a * a - 4. * b * b * b);
    }
    template <class Number>
    Number slope(const Number &r) const
    {
      const Number q = r * inverse_h, a = max(2. - q, Number(0.));
      // below q = 1 the bracket over q is 4 - 3q, which stays finite at q = 0
      return slope_norm * select(q < Number(1.), 4. - 3. * q, a * a / max(q, Number(1.)));
    }

    double inverse_h, norm, slope_norm;
  };
} // namespace birdstrike
