#pragma once

#include <birdstrike/core/number.h>

#include <array>

namespace birdstrike
{
  /// det M times the inverse of a symmetric M.
  template <class Number>
  std::array<Number, 6> compute_cofactors(const std::array<Number, 6> &m)
  {
    const auto &[xx, yy, zz, xy, xz, yz] = m;
    return {yy * zz - yz * yz, xx * zz - xz * xz, xx * yy - xy * xy,
            xz * yz - xy * zz, xy * yz - xz * yy, xy * xz - yz * xx};
  }

  /// Correction matrix of the kernel gradient, B = M^-1 with M = sum_j V_j w x x^T (Bonet & Lok 1999), blended to the
  /// identity where M is near singular: B = 1 + s (M^-1 - 1), s = 0 below det M = 0.03, 1 above 0.1.
  /// det M is 1 inside, about 1/2 on a face, 1/4 on an edge, 1/8 at a corner: all of these are corrected fully.
  template <class Number>
  std::array<Number, 6> compute_correction(const std::array<Number, 6> &m)
  {
    constexpr double            none = 0.03, full = 0.1;
    const std::array<Number, 6> cofactors = compute_cofactors(m);
    const Number                det       = m[0] * cofactors[0] + m[3] * cofactors[3] + m[4] * cofactors[4];
    const Number                share     = min(max((det - none) * (1. / (full - none)), Number(0.)), Number(1.));
    const Number                scale     = share / max(det, Number(none)); // where det is less, share is 0
    std::array<Number, 6>       b;
    for (int k = 0; k < 6; ++k)
      b[k] = (k < 3 ? 1. - share : Number(0.)) + scale * cofactors[k];
    return b;
  }

  /// The same for stresses that no pressure stands for: s M^-1, s = 0 below det M = 0.003, 1 above 0.012. A blend to
  /// the identity strains whatever turns (a tenth of its spin at an edge of a cubic lattice, det M = 0.09, a third at a
  /// corner, 0.024), and its torques turn back; so edges and corners have the inverse, and spray no strength.
  template <class Number>
  std::array<Number, 6> compute_shear_correction(const std::array<Number, 6> &m)
  {
    constexpr double      none = 0.003, full = 0.012;
    std::array<Number, 6> b     = compute_cofactors(m);
    const Number          det   = m[0] * b[0] + m[3] * b[3] + m[4] * b[4];
    const Number          share = min(max((det - none) * (1. / (full - none)), Number(0.)), Number(1.));
    for (Number &entry : b)
      entry *= share / max(det, Number(none));
    return b;
  }
} // namespace birdstrike
