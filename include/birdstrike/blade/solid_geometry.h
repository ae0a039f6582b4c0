#pragma once

#include <birdstrike/core/lane_rows.h>

#include <array>

namespace birdstrike
{
  /// The modes of a trilinear field on a brick with corners (xi_1, xi_2, xi_3), each -1 or 1, the first running
  /// fastest; times eight, so that neither way takes a multiplication:
  ///   8 f = f_0 + sum_k xi_k linear_k + xi_2 xi_3 twist_1 + xi_3 xi_1 twist_2 + xi_1 xi_2 twist_3 + xi_1 xi_2 xi_3
  ///   last.
  /// f_0 moves or loads nothing within the element and is left out. The modes are orthogonal at the corners: the power
  /// of forces with modes F (their sum at every corner) on velocities with modes v is the sum of F.v.
  template <class Number>
  struct SolidModes
  {
    Vector3<Number> linear[3], twist[3], last;

    [[gnu::always_inline]] static SolidModes of_corners(const Vector3<Number> (&f)[8])
    {
      SolidModes m;
      for (int c = 0; c < 3; ++c)
        {
          // along xi_1, then xi_2, then xi_3
          const Number a0 = f[1][c] + f[0][c], a1 = f[3][c] + f[2][c], a2 = f[5][c] + f[4][c], a3 = f[7][c] + f[6][c];
          const Number b0 = f[1][c] - f[0][c], b1 = f[3][c] - f[2][c], b2 = f[5][c] - f[4][c], b3 = f[7][c] - f[6][c];
          const Number aa0 = a1 + a0, aa1 = a3 + a2, ab0 = a1 - a0, ab1 = a3 - a2;
          const Number ba0 = b1 + b0, ba1 = b3 + b2, bb0 = b1 - b0, bb1 = b3 - b2;
          m.linear[0][c] = ba1 + ba0;
          m.linear[1][c] = ab1 + ab0;
          m.linear[2][c] = aa1 - aa0;
          m.twist[0][c]  = ab1 - ab0;
          m.twist[1][c]  = ba1 - ba0;
          m.twist[2][c]  = bb1 + bb0;
          m.last[c]      = bb1 - bb0;
        }
      return m;
    }

    /// The sum of the modes at every corner.
    [[gnu::always_inline]] void sum_at_corners(Vector3<Number> (&f)[8]) const
    {
      for (int c = 0; c < 3; ++c)
        {
          const Number aa1 = linear[2][c], aa0 = -linear[2][c];
          const Number ab1 = linear[1][c] + twist[0][c], ab0 = linear[1][c] - twist[0][c];
          const Number ba1 = linear[0][c] + twist[1][c], ba0 = linear[0][c] - twist[1][c];
          const Number bb1 = twist[2][c] + last[c], bb0 = twist[2][c] - last[c];
          const Number a3 = aa1 + ab1, a2 = aa1 - ab1, a1 = aa0 + ab0, a0 = aa0 - ab0;
          const Number b3 = ba1 + bb1, b2 = ba1 - bb1, b1 = ba0 + bb0, b0 = ba0 - bb0;
          f[7][c] = a3 + b3;
          f[6][c] = a3 - b3;
          f[5][c] = a2 + b2;
          f[4][c] = a2 - b2;
          f[3][c] = a1 + b1;
          f[2][c] = a1 - b1;
          f[1][c] = a0 + b0;
          f[0][c] = a0 - b0;
        }
    }
  };

  /// Coordinates i, j that follow k cyclically.
  struct Following
  {
    int i, j;
  };
  constexpr Following following(const int k)
  {
    return {(k + 1) % 3, (k + 2) % 3};
  }

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
    SolidModes<Number> x;         ///< m
    Vector3<Number>    linear[3]; ///< c of the linear modes, m^2
    Vector3<Number>    twist[3];  ///< c of the twist modes, m^2
    Number             det;       ///< D, 64 times the volume, m^3
    Number             inverse_det;

    [[gnu::always_inline]] explicit SolidGeometry(const SolidModes<Number> &modes) : x(modes)
    {
      const Number    third = 1. / 3.;
      Vector3<Number> q[3];
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
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
          g(r, c) = inverse_det *
                    (u.linear[0][r] * linear[0][c] + u.linear[1][r] * linear[1][c] + u.linear[2][r] * linear[2][c] +
                     u.twist[0][r] * twist[0][c] + u.twist[1][r] * twist[1][c] + u.twist[2][r] * twist[2][c]);
      return g;
    }

    /// The transpose: adds the forces on modes that do the work sum_ij s_ij (mean grad u)_ij D.
    [[gnu::always_inline]] void add_mean_forces(const Matrix3<Number> &s, SolidModes<Number> &force) const
    {
      for (int k = 0; k < 3; ++k)
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

  /// At t^{n+1/2}: x - u/2.
  template <class Number>
  [[gnu::always_inline]] inline SolidModes<Number> compute_midpoint_modes(const SolidModes<Number> &x,
                                                                          const SolidModes<Number> &u)
  {
    const Number       half = 0.5;
    SolidModes<Number> m;
    for (int k = 0; k < 3; ++k)
      {
        m.linear[k] = x.linear[k] - half * u.linear[k];
        m.twist[k]  = x.twist[k] - half * u.twist[k];
      }
    m.last = x.last - half * u.last;
    return m;
  }
} // namespace birdstrike
