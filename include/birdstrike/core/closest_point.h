#pragma once

#include <birdstrike/core/number.h>

#include <array>

namespace birdstrike
{
  /// The point q of a quadrilateral facet that is closest to p, as a weighted sum of the facet's nodes.
  template <class Number>
  struct ClosestPoint
  {
    Vector3<Number>       offset;           ///< p - q, m
    Number                distance_squared; ///< |p - q|^2, m^2
    std::array<Number, 4> weights;          ///< q = sum weights[k] x_k, sum weights = 1, weights >= 0
  };

  /// The facet is the fan of four triangles (c, x_k, x_k+1) about the mean c of its nodes: plane where the facet is
  /// plane, watertight across straight edges whatever the warp, and its closest point has a closed form without
  /// iteration (Ericson 2005, section 5.1.5, with all regions computed and the nearest selected, so that lanes do not
  /// part). Inside a triangle the weights are linear: (1 - s - t)/4 to each node, plus s to node k and t to node k + 1.
  /// They reproduce q exactly, so a force along p - q shared by them carries no moment.
  ///
  /// On edge k (x_k to x_k+1) the two other weights are exactly zero, on a corner the three others: the weights tell
  /// the feature. A triangle is a quadrilateral with its last node repeated.
  template <class Number>
  ClosestPoint<Number> compute_closest_point(const Vector3<Number> &p, const std::array<Vector3<Number>, 4> &x)
  {
    const Number          zero(0.), one(1.), tiny(1e-300);
    const Vector3<Number> c = Number(0.25) * ((x[0] + x[1]) + (x[2] + x[3])), w = p - c;

    std::array<Vector3<Number>, 4> a;
    std::array<Number, 4>          aa, wa;
#pragma GCC unroll 4
    for (unsigned int k = 0; k < 4; ++k)
      {
        a[k]  = x[k] - c;
        aa[k] = a[k].dot(a[k]);
        wa[k] = w.dot(a[k]);
      }

    ClosestPoint<Number> best;
    best.offset           = w;
    best.distance_squared = w.dot(w);
    Number best_s = zero, best_t = zero, best_k = zero;
    // left to itself the compiler calls this twelve times through memory: a fifth more for the whole of contact,
    // measured
    const auto consider = [&](const unsigned int k, const Number &s, const Number &t, const auto &is_valid)
      __attribute__((always_inline))
    {
      const Vector3<Number> r         = w - s * a[k] - t * a[(k + 1) % 4];
      const Number          rr        = r.dot(r);
      const auto            is_closer = is_valid && rr < best.distance_squared;
      best.distance_squared           = select(is_closer, rr, best.distance_squared);
      best_s                          = select(is_closer, s, best_s);
      best_t                          = select(is_closer, t, best_t);
      best_k                          = select(is_closer, Number(k), best_k);
      for (unsigned int d = 0; d < 3; ++d)
        best.offset[d] = select(is_closer, r[d], best.offset[d]);
    };

#pragma GCC unroll 4
    for (unsigned int k = 0; k < 4; ++k)
      {
        const unsigned int l = (k + 1) % 4;

        // the outer edge comes first: where inner regions tie with it, its exact zeros stand
        const Vector3<Number> e = a[l] - a[k];
        const Number          t = max(zero, min(one, (w - a[k]).dot(e) / max(e.dot(e), tiny)));
        // 1 - t is rounded; from it t is exact, so that 1 - s - t is zero and not a positive round-off
        const Number s = one - t;
        consider(k, s, one - s, zero < one);

        const Number spoke = max(zero, min(one, wa[k] / max(aa[k], tiny)));
        consider(k, spoke, zero, zero < one);

        const Number al = a[k].dot(a[l]), det = aa[k] * aa[l] - al * al;
        const Number f = (wa[k] * aa[l] - wa[l] * al) / max(det, tiny),
                     g = (wa[l] * aa[k] - wa[k] * al) / max(det, tiny);
        consider(k, f, g, det > Number(1e-14) * aa[k] * aa[l] && f >= zero && g >= zero && f + g <= one);
      }

#pragma GCC unroll 4
    for (unsigned int k = 0; k < 4; ++k)
      best.weights[k] = max(zero, one - best_s - best_t) * Number(0.25) + select(best_k == Number(k), best_s, zero) +
                        select(best_k == Number((k + 3) % 4), best_t, zero);
    return best;
  }

  /// Normal of a facet, not normalised: half the cross product of its diagonals, m^2.
  template <class Number>
  Vector3<Number> compute_area_vector(const std::array<Vector3<Number>, 4> &x)
  {
    const Vector3<Number> a = x[2] - x[0], b = x[3] - x[1];
    return Number(0.5) * a.cross(b);
  }
} // namespace birdstrike
