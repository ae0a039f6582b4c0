#pragma once

#include <birdstrike/core/simd/inverse_root.h>

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

    SolidModes() = default;
    [[gnu::always_inline]] explicit SolidModes(const Vector3<Number> (&f)[8])
    {
#pragma GCC unroll 3
      for (int c = 0; c < 3; ++c)
        {
          // along xi_1, then xi_2, then xi_3
          const Number a0 = f[1][c] + f[0][c], a1 = f[3][c] + f[2][c], a2 = f[5][c] + f[4][c], a3 = f[7][c] + f[6][c];
          const Number b0 = f[1][c] - f[0][c], b1 = f[3][c] - f[2][c], b2 = f[5][c] - f[4][c], b3 = f[7][c] - f[6][c];
          const Number aa0 = a1 + a0, aa1 = a3 + a2, ab0 = a1 - a0, ab1 = a3 - a2;
          const Number ba0 = b1 + b0, ba1 = b3 + b2, bb0 = b1 - b0, bb1 = b3 - b2;
          linear[0][c] = ba1 + ba0;
          linear[1][c] = ab1 + ab0;
          linear[2][c] = aa1 - aa0;
          twist[0][c]  = ab1 - ab0;
          twist[1][c]  = ba1 - ba0;
          twist[2][c]  = bb1 + bb0;
          last[c]      = bb1 - bb0;
        }
    }

    /// The sum of the modes at every corner.
    [[gnu::always_inline]] void sum_at_corners(Vector3<Number> (&f)[8]) const
    {
#pragma GCC unroll 3
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
