#pragma once

#include <birdstrike/blade/shell_section.h>

namespace birdstrike
{
  /// Upper bound of the largest eigenvalue omega^2 (1/s^2) of one free element of the default formulation, with a
  /// quarter of its mass on each node and inertia m max(t^2/12, A/8); the assembled omega_max is not larger (Irons &
  /// Treharne 1971).
  ///
  /// In the mode coordinates of ShellModes the mass matrix is m on u and m r on the directors, r = max(t^2/12, A/8), so
  /// with S = g^ab (contravariant metric) and D = E/(1 - nu^2):
  ///   membrane:          D/(2 rho) (tr S + sqrt(tr^2 S - 4 (1 - nu^2) det S))
  ///   bending:           t^2/(12 r) times that
  ///   transverse shear:  kappa G/rho (S_max + (1 + |a3|^2 tr S)/r)
  /// and the linear parts with a third of the corresponding values; rows that share a mode are combined by
  /// lambda <= (a + b)/2 + sqrt((a - b)^2/4 + a b cos^2). Warp and initial curvature add a factor.
  template <class Number>
  inline Number compute_eigenvalue_bound(const ShellGeometry<Number> &g, const Number &thickness, const Number &mass,
                                         const ShellSectionLaw &law)
  {
    const Elasticity &elasticity = law.elasticity;
    const double      kappa_g    = law.shear_modulus;
    const Number      density    = mass / (thickness * g.area);

    const auto combine = [](const Number &a, const Number &b, const Number &cos2) {
      const Number d = a - b;
      return 0.5 * (a + b + sqrt(d * d + 4. * a * b * cos2));
    };
    const double nu  = elasticity.poisson;
    const Number g11 = g.c1x * g.c1x + g.c1y * g.c1y, g22 = g.c2x * g.c2x + g.c2y * g.c2y;
    const Number a11 = g.x.m1.dot(g.x.m1), a22 = g.x.m2.dot(g.x.m2);
    const Number trace = g11 + g22, det = Number(16.) / (g.area * g.area);
    const Number s_max = 0.5 * (trace + sqrt(max(Number(trace * trace - 4. * det), Number(0.))));
    const Number skew  = g.alpha * g.alpha + g.beta * g.beta;
    const Number cos2  = skew / (Number(1.) + skew);
    const Number t2    = thickness * thickness / Number(12.);
    // theta x d of a director longer than one moves as with less inertia
    const Number longest = max(max(Number(g.director[0].dot(g.director[0])), Number(g.director[1].dot(g.director[1]))),
                               max(Number(g.director[2].dot(g.director[2])), Number(g.director[3].dot(g.director[3]))));
    const Number r       = max(t2, Number(g.area / Number(8.))) / longest;

    const Number root     = sqrt(max(Number(trace * trace - 4. * (1. - nu * nu) * det), Number(0.)));
    const Number membrane = (0.5 * elasticity.plate_modulus() / density) * (trace + root);
    // both directions; p and q share u_gamma by the cosine of a1 and a2
    const Number angle           = g.x.m1.dot(g.x.m2);
    const Number linear_membrane = (elasticity.young / (3. * density)) * (Number(1.) + skew) *
                                   combine(Number(1.) / a11, Number(1.) / a22, Number(angle * angle / (a11 * a22)));
    const Number flat_membrane = combine(membrane, linear_membrane, cos2);

    const Number tilt  = g.x.m3.dot(g.x.m3) * trace;
    const Number shear = (kappa_g / density) * (s_max + (Number(1.) + tilt) / r);
    const Number linear_shear =
      (kappa_g / (3. * density)) * (trace + (max(Number(g11 * a11), Number(g22 * a22)) + tilt) / r);
    const Number bending = (t2 / r) * flat_membrane;
    const Number plate   = combine(shear, linear_shear + bending, Number(2. * tilt / (Number(1.) + 2. * tilt)));

    const Number curvature = (g.d.m1.dot(g.d.m1) + g.d.m2.dot(g.d.m2) + g.d.m3.dot(g.d.m3)) * r * s_max;
    const Number warp      = g.warp * g.warp * s_max;
    return max(flat_membrane, plate) * (Number(1.) + warp + 2. * curvature) +
           sqrt(curvature) * sqrt(flat_membrane * plate);
  }
} // namespace birdstrike
