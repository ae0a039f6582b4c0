#pragma once

#include "structure/elements/solid/modes.h"

namespace birdstrike
{
  /// Volume and mean gradient of a brick.
  ///
  /// The mean of grad u over the element is exact (Flanagan & Belytschko 1981: the derivative of the volume): with the
  /// modes of x and u
  ///   mean grad u = 1/D sum_m u_m c_m^T,   D = 64 V,
  /// over the linear and twist modes, where c is quadratic in x. What is linear in x has its exact gradient, whatever
  /// the shape: the patch test holds.
  template <class Number>
  struct SolidGeometry
  {
    const SolidModes<Number> &x;         ///< m; it must outlive this
    Vector3<Number>           linear[3]; ///< c of the linear modes, m^2
    Vector3<Number>           twist[3];  ///< c of the twist modes, m^2
    Number                    det;       ///< D, 64 times the volume, m^3
    Number                    inverse_det;

    explicit SolidGeometry(SolidModes<Number> &&) = delete;
    [[gnu::always_inline]] explicit SolidGeometry(const SolidModes<Number> &modes) : x(modes)
    {
      const Number    third = 1. / 3.;
      Vector3<Number> q[3];
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        {
          const auto [i, j] = following(k);
          q[k]              = third * x.twist[j].cross(x.twist[i]);
          linear[k]         = x.linear[i].cross(x.linear[j]) + q[k];
          twist[k]          = third * (x.linear[j].cross(x.twist[i]) - x.linear[i].cross(x.twist[j]));
        }
      det         = x.linear[0].dot(linear[0]) + x.linear[1].dot(q[1]) + x.linear[2].dot(q[2]);
      inverse_det = Number(1.) / det;
    }

    Number volume() const
    {
      return (1. / 64.) * det;
    }

    [[gnu::always_inline]] Matrix3<Number> compute_mean_gradient(const SolidModes<Number> &u) const
    {
      Matrix3<Number> g;
#pragma GCC unroll 3
      for (int r = 0; r < 3; ++r)
#pragma GCC unroll 3
        for (int c = 0; c < 3; ++c)
          g(r, c) = inverse_det *
                    (u.linear[0][r] * linear[0][c] + u.linear[1][r] * linear[1][c] + u.linear[2][r] * linear[2][c] +
                     u.twist[0][r] * twist[0][c] + u.twist[1][r] * twist[1][c] + u.twist[2][r] * twist[2][c]);
      return g;
    }

    /// The transpose: adds the forces on modes that do the work sum_ij s_ij (mean grad u)_ij D.
    [[gnu::always_inline]] void add_mean_forces(const Matrix3<Number> &s, SolidModes<Number> &force) const
    {
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
#pragma GCC unroll 3
        for (int r = 0; r < 3; ++r)
          {
            force.linear[k][r] += s(r, 0) * linear[k][0] + s(r, 1) * linear[k][1] + s(r, 2) * linear[k][2];
            force.twist[k][r] += s(r, 0) * twist[k][0] + s(r, 1) * twist[k][1] + s(r, 2) * twist[k][2];
          }
    }

    /// Volume over the largest face, the height of a slab; the length of the bulk viscosity (m).
    [[gnu::always_inline]] Number compute_height() const
    {
      const Number a = linear[0].dot(linear[0]), b = linear[1].dot(linear[1]), c = linear[2].dot(linear[2]);
      return 0.25 * det * inverse_root(max(max(a, b), c));
    }
  };
} // namespace birdstrike
