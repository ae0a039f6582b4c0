#pragma once

#include "structure/elements/solid/law.h"

#include <type_traits>

namespace birdstrike
{
  /// Selective mass scaling (see SolidElements::scale_masses): a factor over each axis of the element, 1 for all but
  /// one, and its inverse. A mode has the product of the factors of the axes that it changes sign over.
  template <class Number>
  struct MassFactors
  {
    Number axis[3], inverse[3];
  };
  struct Unscaled
  {
  };

  /// Upper bound of 2/dt (1/s) of one free brick with an eighth of its mass on each node; the assembled one is not
  /// larger (Irons & Treharne 1971).
  ///
  /// In the modes of SolidGeometry the mass is m on each, and the mean gradient is sum u_m b_m^T with S = sum b b^T and
  /// b = 8 c/D. The eigenvalues of its stiffness are those of lambda d d^T + 2 G diag(d^2), d^2 the principal values of
  /// S, and no shear exceeds them: the largest root of a cubic x^3 - a x^2 + b x - ... with three real roots,
  ///   a = (lambda + 2 G) tr S,   b = 4 G (G + lambda) I_2(S),
  /// is not above (a + 2 sqrt(a^2 - 3 b))/3, and equal to it for a cube and in the limit of a thin brick (0.734 L/c for
  /// the cube with nu = 0.3, where V/A_max/c is 1 and Flanagan & Belytschko's bound 0.577).
  ///
  /// What the mean gradient does not see is, for a parallelepiped, in other modes and less (at most: stabilisation
  /// 2/3 E/(1 - |nu|) S_max; 2 x 2 x 2 points 4/3 G S_max): up to here the bound is proven. A distorted one mixes them:
  /// with the distortion D = sum h.S.h of the twist and last modes h of the geometry the second grows by 1 + D, and the
  /// two are combined by lambda <= (a + b)/2 + sqrt((a - b)^2/4 + a b cos^2), cos^2 = min(1, D). These two constants
  /// are measured: of 9600 bricks, random up to 0.4 of an edge, tapered and twisted, aspects up to 12, nu up to 0.45,
  /// none had an exact step below the bound's; half of cos^2 would do.
  ///
  /// Scaled masses stay diagonal in these modes, factor w_m: S becomes sum b_m b_m^T/w_m, and what was proven stays so.
  /// The strains beyond the mean that a distorted brick has, u_m - (mean grad u) h_m, grow by w_m |S^{1/2} h_m|^2: D
  /// takes each mode w_m times (measured: none of 800 bricks, random as before, with factors up to 400, was below).
  ///
  /// With a drag on the dilatation (see SolidLaw::compute_viscous_pressure), which acts half a step late, dt solves
  /// omega^2 dt^2 + 2 beta dt = 4.
  ///
  /// Of stresses nothing is counted: a compressive principal Kirchhoff stress s adds s to lambda + 2 G, 0.3 % of the
  /// step where titanium yields, 1.7 % where a thin brick has lost 5 % of its volume.
  ///
  /// `inverse_mass`: 1/(least mass that the nodes carry for the element, kg). `rest_det`
  /// (m^3) is 64 times the volume that the moduli belong to: the undeformed one. `shape` gets D.
  template <class Number, class Scaling = Unscaled>
  [[gnu::always_inline]] inline Number
  compute_frequency_bound(const SolidGeometry<Number> &g, const Number &rest_det, const Number &inverse_mass,
                          const Number &drag, const SolidLaw &law, const SolidFormulation formulation,
                          const Scaling &scaling = {}, Number *const shape = nullptr)
  {
    const double shear = law.elasticity.shear_modulus(), young = law.elasticity.young;
    const double lambda = std::max(0., law.elasticity.bulk_modulus() - 2. / 3. * shear);
    const double rest =
      formulation == SolidFormulation::b_bar ? 4. / 3. * shear : 2. / 3. * young / (1. - law.elasticity.poisson);
    const Number zero = 0., one = 1., half = 0.5;

    const auto root = [](const Number &a) __attribute__((always_inline))
    {
      return Number(a * inverse_root(max(a, Number(1e-300))));
    };
    // a over the factor of the linear mode k, of the twist k
    const auto over_linear = [&](const int k, const Number &a) __attribute__((always_inline))
    {
      if constexpr (std::is_same_v<Scaling, Unscaled>)
        return (void) k, a;
      else
        return Number(a * scaling.inverse[k]);
    };
    const auto over_twist = [&](const int k, const Number &a) __attribute__((always_inline))
    {
      const auto [i, j] = following(k);
      return over_linear(i, over_linear(j, a));
    };
    // S/64, and with modes that are eight times too long D needs no factor
    const Number square = g.inverse_det * g.inverse_det;
    const auto   metric = [&](const int r, const int c) __attribute__((always_inline))
    {
      Number sum = over_linear(0, g.linear[0][r] * g.linear[0][c]);
      for (int k = 0; k < 3; ++k)
        sum += (k > 0 ? over_linear(k, g.linear[k][r] * g.linear[k][c]) : zero) +
               over_twist(k, g.twist[k][r] * g.twist[k][c]);
      return Number(square * sum);
    };
    const Number xx = metric(0, 0), yy = metric(1, 1), zz = metric(2, 2);
    const Number xy = metric(0, 1), yz = metric(1, 2), zx = metric(2, 0);
    const Number first  = xx + yy + zz;
    const Number second = xx * yy + yy * zz + zz * xx - xy * xy - yz * yz - zx * zx;
    const auto   norm   = [&](const Vector3<Number> &h) __attribute__((always_inline))
    {
      return Number(xx * h[0] * h[0] + yy * h[1] * h[1] + zz * h[2] * h[2] +
                    2. * (xy * h[0] * h[1] + yz * h[1] * h[2] + zx * h[2] * h[0]));
    };
    Number distortion;
    if constexpr (std::is_same_v<Scaling, Unscaled>)
      distortion = norm(g.x.twist[0]) + norm(g.x.twist[1]) + norm(g.x.twist[2]) + norm(g.x.last);
    else
      {
        distortion = scaling.axis[0] * scaling.axis[1] * scaling.axis[2] * norm(g.x.last);
        for (int k = 0; k < 3; ++k)
          distortion += scaling.axis[following(k).i] * scaling.axis[following(k).j] * norm(g.x.twist[k]);
      }

    if (shape)
      *shape = distortion;

    const Number scale = rest_det * inverse_mass; // 64/density
    const Number a     = (lambda + 2. * shear) * first;
    const Number b     = (4. * shear * (shear + lambda)) * second;
    const Number mean  = (1. / 3.) * (a + 2. * root(max(Number(a * a - 3. * b), zero)));
    const Number s_max = (1. / 3.) * (first + 2. * root(max(Number(first * first - 3. * second), zero)));
    const Number other = rest * s_max * (one + distortion);
    const Number cos2 = min(distortion, one), difference = mean - other;
    const Number omega2 =
      scale * (half * (mean + other + root(Number(difference * difference + 4. * mean * other * cos2))));
    const Number beta = law.density * drag * (g.det * inverse_mass) * first;
    return half * (beta + root(Number(beta * beta + 4. * omega2)));
  }
} // namespace birdstrike
