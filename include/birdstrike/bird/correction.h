#pragma once

#include <birdstrike/bird/symmetric_tensor.h>

#include <algorithm>

namespace birdstrike
{
  /// Correction matrix of the kernel gradient, B = M^-1 with M = sum_j V_j w x x^T (Bonet & Lok 1999), blended to the
  /// identity where M is near singular: B = 1 + s (M^-1 - 1), s = 0 below det M = 0.03, 1 above 0.1.
  /// det M is 1 inside, about 1/2 on a face, 1/4 on an edge, 1/8 at a corner: all of these are corrected fully.
  inline SymmetricTensor compute_correction(const SymmetricTensor &m)
  {
    constexpr double none = 0.03, full = 0.1;
    const auto &[xx, yy, zz, xy, xz, yz] = m;
    const SymmetricTensor cofactors{yy * zz - yz * yz, xx * zz - xz * xz, xx * yy - xy * xy,
                                    xz * yz - xy * zz, xy * yz - xz * yy, xy * xz - yz * xx};
    const double          det   = xx * cofactors[0] + xy * cofactors[3] + xz * cofactors[4];
    const double          share = std::clamp((det - none) / (full - none), 0., 1.);
    SymmetricTensor       b{1., 1., 1., 0., 0., 0.};
    if (share > 0.)
      for (int k = 0; k < 6; ++k)
        b[k] += share * (cofactors[k] / det - b[k]);
    return b;
  }
} // namespace birdstrike
