#pragma once

#include "structure/elements/shell/section.h"

namespace birdstrike
{
  namespace step_bound
  {
    template <class Number>
    [[gnu::always_inline]] inline Number root(const Number &a)
    {
      return a * inverse_root(max(a, Number(1e-300)));
    }
    template <class Number>
    [[gnu::always_inline]] inline Number combine(const Number &a, const Number &b, const Number &cos2)
    {
      const Number d = a - b;
      return 0.5 * (a + b + root(Number(d * d + 4. * a * b * cos2)));
    }

    /// What the bound has of an element's shape and mass, whatever its material.
    template <class Number>
    struct Terms
    {
      Number trace, det, spread, s_max; ///< of S, 1/m^2
      Number skew, skew_1, tilt, t2, inverse_density;
      Number inverse_r, cos2, cos2_tilt;

      [[gnu::always_inline]] Terms(const ShellGeometry<Number> &g, const Number &thickness, const Number &inverse_mass,
                                   const Number &radius2, const Number &contraction)
      {
        const Number one = 1., half = 0.5;
        inverse_density = thickness * g.area * contraction * inverse_mass;
        // base vectors of [-1, 1]: a quarter as long, see ShellModes
        const Number g11 = 16. * g.g11, g22 = 16. * g.g22;
        trace  = g11 + g22;
        det    = (256. * g.inverse_det) * g.inverse_det;
        spread = max(Number(trace * trace - 4. * det), Number(0.));
        s_max  = half * (trace + root(spread));
        skew   = g.alpha * g.alpha + g.beta * g.beta;
        tilt   = (1. / 16.) * g.x.m3.dot(g.x.m3) * trace;
        t2     = thickness * thickness * (1. / 12.);
        // theta x d of a director longer than one moves as with less inertia
        const Number longest =
          max(max(Number(g.director[0].dot(g.director[0])), Number(g.director[1].dot(g.director[1]))),
              max(Number(g.director[2].dot(g.director[2])), Number(g.director[3].dot(g.director[3]))));
        // three quotients with one division
        const Number tilt_1    = one + 2. * tilt;
        skew_1                 = one + skew;
        const Number skew_tilt = skew_1 * tilt_1;
        const Number quotient  = one / (skew_tilt * radius2);
        const Number rest      = radius2 * quotient;
        inverse_r              = longest * skew_tilt * quotient;
        cos2                   = skew * tilt_1 * rest;
        cos2_tilt              = 2. * tilt * skew_1 * rest;
      }

      /// Of full integration, 1/(3 j).
      [[gnu::always_inline]] Number third_over_j(const ShellGeometry<Number> &g) const
      {
        const Number j = max(Number(Number(1.) - root_third * (abs(g.alpha) + abs(g.beta))), Number(1e-6));
        return (1. / 3.) / j;
      }

      /// The rows of transverse shear, of `shear_scale` = its modulus over the density, beside those of bending.
      template <bool is_fully_integrated>
      [[gnu::always_inline]] Number with_shear(const ShellGeometry<Number> &g, const Number &shear_scale,
                                               const Number &bending) const
      {
        const Number one   = 1.;
        const Number shear = shear_scale * (s_max + (one + tilt) * inverse_r);
        Number       linear_shear, shared = cos2_tilt;
        if constexpr (is_fully_integrated)
          {
            const Number variation =
              root_third * root(Number(g.beta * g.beta * g.g11 + g.alpha * g.alpha * g.g22 +
                                       2. * g.alpha * g.beta * g.inverse_det * g.inverse_det * g.a12));
            const Number b1 = g.g1 + variation, b2 = g.g2 + variation, a33 = 3. * g.x.m3.dot(g.x.m3);
            linear_shear =
              shear_scale * third_over_j(g) *
              (skew_1 * trace + max(Number(b1 * b1 * (g.a11 + a33)), Number(b2 * b2 * (g.a22 + a33))) * inverse_r);
            shared = min(Number(cos2 + cos2_tilt), one);
          }
        else
          linear_shear =
            (1. / 3.) * shear_scale * (trace + (max(Number(g.g11 * g.a11), Number(g.g22 * g.a22)) + tilt) * inverse_r);
        return combine(shear, Number(linear_shear + bending), shared);
      }

      /// What warp and initial curvature add to `largest` of both.
      [[gnu::always_inline]] Number with_warp(const ShellGeometry<Number> &g, const Number &radius2,
                                              const Number &flat_membrane, const Number &bent,
                                              const Number &largest) const
      {
        const Number curvature =
          (g.d.m1.dot(g.d.m1) + g.d.m2.dot(g.d.m2) + g.d.m3.dot(g.d.m3)) * ((1. / 16.) * max(t2, radius2)) * s_max;
        const Number warp = (1. / 16.) * g.warp * g.warp * s_max;
        return largest * (Number(1.) + warp + 2. * curvature) + root(Number(curvature * flat_membrane * bent));
      }

    private:
      static constexpr double root_third = 0.57735026918962576;
    };
  } // namespace step_bound

  /// Upper bound of the largest eigenvalue omega^2 (1/s^2) of one free element of the covariant formulations, with a
  /// quarter of its mass on each node and inertia m r, r = max(t^2/12, A/8) of the element at rest (`radius2`, m^2);
  /// the assembled omega_max is not larger (Irons & Treharne 1971).
  ///
  /// In the mode coordinates of ShellModes the mass matrix is m on u and m r on the directors, so with S = g^ab
  /// (contravariant metric) and D = E/(1 - nu^2):
  ///   membrane:          D/(2 rho) (tr S + sqrt(tr^2 S - 4 (1 - nu^2) det S))
  ///   bending:           t^2/(12 r) times that
  ///   transverse shear:  kappa G/rho (S_max + (1 + |a3|^2 tr S)/r)
  /// and the linear parts with a third of the corresponding values; rows that share a mode are combined by
  /// lambda <= (a + b)/2 + sqrt((a - b)^2/4 + a b cos^2). Warp and initial curvature add a factor.
  ///
  /// Fully integrated, the same functions of (xi, eta) are split into mean and rest over the area. The membrane strain
  /// is assumed and its linear parts have not more than a third: the same bound. What varies more is divided by the
  /// smallest Jacobian j of the points (over that at the centre):
  ///   hourglass curvature: D/(6 rho j) ((1 - nu) tr S + (1 + nu) S_max),
  ///   linear shear:        kappa G/(3 rho j) (tr S + max_a (|c^a| + |beta c^1 - alpha c^2|/sqrt(3))^2
  ///                                                       (|a_a|^2 + 3 |a3|^2)/r),
  /// both exact for parallelograms.
  ///
  /// All terms grow with 1/rho: with 1/(least mass that the nodes carry for this element) as `inverse_mass` (1/kg) the
  /// bound holds for other shares than a quarter. Six roots and one division.
  ///
  /// The inertia is that of the element at rest, which its nodes keep: with r of the present area, which stretching
  /// makes larger, transverse shear would seem slower than it is (an element of 1.6 times its length and width: the
  /// step 12 % too long). Of stresses nothing is counted: a compressive principal stress s adds about s/E to
  /// omega^2/omega^2, 0.3 % of the step where titanium yields. Stresses are Kirchhoff's, so that the elements are as
  /// stiff as their undeformed volume: `contraction` of SectionLaw.
  template <bool is_fully_integrated, class Number>
  [[gnu::always_inline]] inline Number
  compute_eigenvalue_bound(const ShellGeometry<Number> &g, const Number &thickness, const Number &inverse_mass,
                           const Number &radius2, const ShellSectionLaw &law, const Number &contraction = Number(1.))
  {
    using namespace step_bound;
    const double young = law.elasticity.young, nu = law.elasticity.poisson, plate = law.elasticity.plate_modulus();
    const Terms<Number> terms(g, thickness, inverse_mass, radius2, contraction);
    const Number       &trace = terms.trace, &inverse_density = terms.inverse_density;

    const Number membrane =
      (0.5 * plate * inverse_density) * (trace + root(Number(terms.spread + 4. * nu * nu * terms.det)));
    // both directions; p and q share u_gamma by the cosine of a1 and a2
    const Number linear_membrane =
      (16. / 3. * young * inverse_density) * terms.skew_1 * combine(g.l1, g.l2, Number(g.a12 * g.a12 * g.l1 * g.l2));
    const Number flat_membrane = combine(membrane, linear_membrane, terms.cos2);

    const Number shear_scale = law.shear_modulus * inverse_density;
    Number       bending;
    if constexpr (is_fully_integrated)
      {
        const Number hourglass = (0.5 * plate * inverse_density) * terms.third_over_j(g) * terms.skew_1 *
                                 ((1. - nu) * trace + (1. + nu) * terms.s_max);
        bending = terms.t2 * terms.inverse_r * combine(membrane, hourglass, terms.cos2);
      }
    else
      bending = terms.t2 * terms.inverse_r * flat_membrane;
    const Number bent = terms.template with_shear<is_fully_integrated>(g, shear_scale, bending);
    return terms.with_warp(g, radius2, flat_membrane, bent, max(flat_membrane, bent));
  }
} // namespace birdstrike
