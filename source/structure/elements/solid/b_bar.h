#pragma once

#include "structure/elements/solid/geometry.h"

#include <cmath>

namespace birdstrike
{
  /// Fully integrated brick: 2 x 2 x 2 Gauss points; of the gradient at a point the trace is replaced by that of the
  /// mean gradient over the current volume (B-bar, Hughes 1980; mean dilatation, Nagtegaal, Parks & Rice 1974), so that
  /// plastic flow and nu near 1/2 do not lock. The shear of a brick that bends stays: one layer is (2/3 + (L/h)^2/2)/(1
  /// + nu) times as stiff as the beam, with edges L along the bent line and h across it (39 times at L/h = 10).
  namespace b_bar_solid
  {
    inline constexpr int n_points = 8;

    /// Coordinate of point p in direction k: -1/sqrt(3) or 1/sqrt(3), the first direction running fastest.
    inline double coordinate(const int p, const int k)
    {
      return ((p >> k & 1) ? 1. : -1.) / std::sqrt(3.);
    }

    /// Derivatives by the natural coordinates at a point, of the modes: times eight.
    template <class Number>
    struct Derivatives
    {
      Vector3<Number> d[3];

      [[gnu::always_inline]] Derivatives(const SolidModes<Number> &f, const int p)
      {
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k)
          {
            const auto [i, j] = following(k);
            const double xi = coordinate(p, i), xj = coordinate(p, j);
            d[k] = f.linear[k] + Number(xi) * f.twist[j] + Number(xj) * f.twist[i] + Number(xi * xj) * f.last;
          }
      }
    };

    /// Jacobian at a point: cofactors c_k = x_,i x x_,j (times 64) and determinant (times 512).
    template <class Number>
    struct Jacobian
    {
      Vector3<Number> cofactor[3];
      Number          det;

      [[gnu::always_inline]] explicit Jacobian(const Derivatives<Number> &x)
      {
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k)
          {
            const auto [i, j] = following(k);
            cofactor[k]       = x.d[i].cross(x.d[j]);
          }
        det = x.d[0].dot(cofactor[0]);
      }

      /// grad u with the trace replaced.
      [[gnu::always_inline]] Matrix3<Number> compute_gradient(const Derivatives<Number> &u,
                                                              const Number              &mean_trace) const
      {
        const Number    inverse = Number(1.) / det;
        Matrix3<Number> g;
#pragma GCC unroll 3
        for (int r = 0; r < 3; ++r)
#pragma GCC unroll 3
          for (int c = 0; c < 3; ++c)
            g(r, c) = inverse * (u.d[0][r] * cofactor[0][c] + u.d[1][r] * cofactor[1][c] + u.d[2][r] * cofactor[2][c]);
        const Number correction = (1. / 3.) * (mean_trace - (g(0, 0) + g(1, 1) + g(2, 2)));
#pragma GCC unroll 3
        for (int c = 0; c < 3; ++c)
          g(c, c) += correction;
        return g;
      }
    };

    /// Adds the forces on modes of the deviator of Kirchhoff's stress at a point to `force`, and its part p V_0p of the
    /// mean pressure's work to `pressure` (times 512). `rest_det` is the determinant of the undeformed brick there,
    /// `stretch` the latter over the present one.
    template <class Number>
    [[gnu::always_inline]] inline void add_point_forces(const Jacobian<Number> &jacobian, const Number &rest_det,
                                                        const Number &stretch, const Number (&s)[6], const int p,
                                                        SolidModes<Number> &force, Number &pressure)
    {
      const Number mean = (1. / 3.) * (s[0] + s[1] + s[2]), scale = (1. / 512.) * stretch;
      pressure += mean * rest_det;
      const Number a = scale * (s[0] - mean), b = scale * (s[1] - mean), c = scale * (s[2] - mean);
      const Number ab = scale * s[3], bc = scale * s[4], ca = scale * s[5];
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        {
          const auto [i, j]         = following(k);
          const double           xi = coordinate(p, i), xj = coordinate(p, j);
          const Vector3<Number> &n = jacobian.cofactor[k];
          Vector3<Number>        t;
          t << a * n[0] + ab * n[1] + ca * n[2], ab * n[0] + b * n[1] + bc * n[2], ca * n[0] + bc * n[1] + c * n[2];
          force.linear[k] += t;
          force.twist[j] += Number(xi) * t;
          force.twist[i] += Number(xj) * t;
          force.last += Number(xi * xj) * t;
        }
    }
  } // namespace b_bar_solid
} // namespace birdstrike
