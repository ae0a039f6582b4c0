#pragma once

#include "structure/elements/shell/laminate/law.h"
#include "structure/elements/shell/step_bound.h"

namespace birdstrike
{
  namespace step_bound
  {
    /// The contravariant metric S = sum c^a c^a of [-1, 1] in the laminate's axes, 1/m^2.
    template <class Number>
    struct TurnedMetric
    {
      Number xx, yy, xy;

      [[gnu::always_inline]] TurnedMetric(const ShellGeometry<Number> &g, const LaminateAxes<Number> &axes)
      {
        const Number c = axes.c, s = axes.s;
        const Number x1 = c * g.c1x + s * g.c1y, y1 = c * g.c1y - s * g.c1x;
        const Number x2 = c * g.c2x + s * g.c2y, y2 = c * g.c2y - s * g.c2x;
        xx = 16. * (x1 * x1 + x2 * x2);
        yy = 16. * (y1 * y1 + y2 * y2);
        xy = 16. * (x1 * y1 + x2 * y2);
      }
    };

    /// Upper bound (Pa/m^2) of the largest eigenvalue of the stiffness C, a block of Laminate's that begins at `first`,
    /// on the strain sym(c^a u_a) of unit masses on the u_a: of the 3 x 3 product of C and the metric of such strains,
    /// whose characteristic polynomial has real roots; Newton's method from above stays above.
    template <class Number>
    [[gnu::always_inline]] inline Number largest_of_block(const double (&C)[6][6], const int first,
                                                          const TurnedMetric<Number> &S)
    {
      const auto of = [&](const int i, const int j) { return C[first + i][first + j]; };
      // on (e_11, e_22, sqrt(2) e_12) the metric is (xx, 0, xy/sqrt 2; 0, yy, xy/sqrt 2; ., ., (xx + yy)/2)
      const double r2 = std::sqrt(2.), c00 = of(0, 0), c01 = of(0, 1), c11 = of(1, 1), c02 = r2 * of(0, 2),
                   c12 = r2 * of(1, 2), c22 = 2. * of(2, 2);
      const Number h = (1. / r2) * S.xy, m = 0.5 * (S.xx + S.yy);
      const Number m00 = c00 * S.xx + c02 * h, m01 = c01 * S.yy + c02 * h, m02 = (c00 + c01) * h + c02 * m;
      const Number m10 = c01 * S.xx + c12 * h, m11 = c11 * S.yy + c12 * h, m12 = (c01 + c11) * h + c12 * m;
      const Number m20 = c02 * S.xx + c22 * h, m21 = c12 * S.yy + c22 * h, m22 = (c02 + c12) * h + c22 * m;
      const Number T = m00 + m11 + m22;
      const Number P = m00 * m11 - m01 * m10 + m00 * m22 - m02 * m20 + m11 * m22 - m12 * m21;
      const Number D = m00 * (m11 * m22 - m12 * m21) - m01 * (m10 * m22 - m12 * m20) + m02 * (m10 * m21 - m11 * m20);
      Number       x = (1. / 3.) * T + (2. / 3.) * root(max(Number(T * T - 3. * P), Number(0.)));
      for (int k = 0; k < 3; ++k)
        {
          const Number value = ((x - T) * x + P) * x - D, slope = (3. * x - 2. * T) * x + P;
          // at a threefold root both are nothing
          x -= max(value, Number(0.)) / max(slope, Number(1e-12 * x * x));
        }
      return x;
    }

    /// The larger eigenvalue of the acoustic tensor S_ik C_ijkl.
    template <class Number>
    [[gnu::always_inline]] inline Number largest_acoustic(const double (&C)[6][6], const int first,
                                                          const TurnedMetric<Number> &S)
    {
      const auto   of = [&](const int i, const int j) { return C[first + i][first + j]; };
      const Number xx = of(0, 0) * S.xx + 2. * of(0, 2) * S.xy + of(2, 2) * S.yy;
      const Number yy = of(2, 2) * S.xx + 2. * of(1, 2) * S.xy + of(1, 1) * S.yy;
      const Number xy = of(0, 2) * S.xx + (of(0, 1) + of(2, 2)) * S.xy + of(1, 2) * S.yy;
      const Number d  = xx - yy;
      return 0.5 * (xx + yy + root(Number(d * d + 4. * xy * xy)));
    }
  } // namespace step_bound

  /// compute_eigenvalue_bound() of a laminate whose plies have not failed, in which failing takes from every stiffness:
  /// membrane and bending by the largest eigenvalues of A and D on the element's own metric, shear by the larger one of
  /// H, stabilisation by its moduli. Membrane and bending couple by not more than the root of `Laminate::coupling` of
  /// their geometric mean.
  template <bool is_fully_integrated, class Number>
  [[gnu::always_inline]] inline Number
  compute_laminate_bound(const ShellGeometry<Number> &g, const Number &thickness, const Number &inverse_mass,
                         const Number &radius2, const Laminate &law, const LaminateElement<Number> &element,
                         const LaminateAxes<Number> &axes, const Number &contraction)
  {
    using namespace step_bound;
    const Terms<Number>        terms(g, thickness, inverse_mass, radius2, contraction);
    const TurnedMetric<Number> S(g, axes);
    const Number               scale = terms.inverse_density, share = g.a12 * g.a12 * g.l1 * g.l2;

    const Number membrane = scale * largest_of_block(law.stiffness, 0, S);
    const Number linear   = (16. / 3.) * scale * terms.skew_1 *
                          combine(Number(element.membrane[0] * g.l1), Number(element.membrane[1] * g.l2), share);
    const Number flat_membrane = combine(membrane, linear, terms.cos2);

    // of the strain at z = t/2: a quarter of the thickness squared
    const Number of_bending = 3. * terms.t2 * terms.inverse_r;
    const Number mean       = scale * largest_of_block(law.stiffness, 3, S);
    Number       rest;
    if constexpr (is_fully_integrated)
      rest = scale * terms.third_over_j(g) * terms.skew_1 * largest_acoustic(law.stiffness, 3, S);
    else
      rest = (16. / 3.) * scale * terms.skew_1 *
             combine(Number(element.bending[0] * g.l1), Number(element.bending[1] * g.l2), share);
    const Number bending = of_bending * combine(mean, rest, terms.cos2);
    const Number bent  = terms.template with_shear<is_fully_integrated>(g, Number(law.largest_shear * scale), bending);
    const Number apart = flat_membrane - bent;
    const Number both =
      0.5 * (flat_membrane + bent + root(Number(apart * apart + (4. * law.coupling) * flat_membrane * bending)));
    return terms.with_warp(g, radius2, flat_membrane, bent, both);
  }
} // namespace birdstrike
