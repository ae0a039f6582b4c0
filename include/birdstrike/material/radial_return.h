#pragma once

#include <birdstrike/material/elasticity.h>
#include <birdstrike/material/hardening.h>
#include <birdstrike/material/plane_stress_return.h>

namespace birdstrike
{
  /// Symmetric tensors in three dimensions are arrays of xx, yy, zz, xy, yz, zx (tensor components, shear not doubled).

  /// Adds lambda tr(e) I + 2 G e to a stress (Pa).
  template <class Number>
  [[gnu::always_inline]] inline void add_elastic_stress(const Elasticity &elasticity, const Number (&strain)[6],
                                                        Number (&stress)[6])
  {
    const double two_g  = 2. * elasticity.shear_modulus();
    const Number volume = (elasticity.bulk_modulus() - two_g / 3.) * (strain[0] + strain[1] + strain[2]);
    for (int c = 0; c < 6; ++c)
      stress[c] += two_g * strain[c] + (c < 3 ? volume : Number(0.));
  }

  /// A third of the trace: minus the pressure (Pa).
  template <class Number>
  [[gnu::always_inline]] inline Number compute_mean_stress(const Number (&stress)[6])
  {
    return (1. / 3.) * (stress[0] + stress[1] + stress[2]);
  }

  /// Square of the von Mises stress, 3/2 s:s (Pa^2).
  template <class Number>
  [[gnu::always_inline]] inline Number von_mises_squared(const Number (&stress)[6])
  {
    const Number mean = compute_mean_stress(stress);
    const Number a = stress[0] - mean, b = stress[1] - mean, c = stress[2] - mean;
    return 1.5 * (a * a + b * b + c * c) + 3. * (stress[3] * stress[3] + stress[4] * stress[4] + stress[5] * stress[5]);
  }

  /// Von Mises stress sqrt(3/2 s:s) (Pa).
  template <class Number>
  inline Number von_mises(const Number (&stress)[6])
  {
    return sqrt(von_mises_squared(stress));
  }

  /// Elastic energy (J/m^3) of a stress: q^2/(6 G) + p^2/(2 K).
  template <class Number>
  [[gnu::always_inline]] inline Number compute_elastic_energy(const Elasticity &elasticity, const Number (&stress)[6])
  {
    const Number mean = compute_mean_stress(stress);
    return von_mises_squared(stress) / (6. * elasticity.shear_modulus()) +
           mean * mean / (2. * elasticity.bulk_modulus());
  }

  /// Scales the deviator of a stress.
  template <class Number>
  [[gnu::always_inline]] inline void scale_deviator(const Number &scale, Number (&stress)[6])
  {
    const Number mean = (Number(1.) - scale) * compute_mean_stress(stress);
    for (int c = 0; c < 6; ++c)
      stress[c] = stress[c] * scale + (c < 3 ? mean : Number(0.));
  }

  /// Solves q_trial - 3 G dp = s_y(p + dp) for the plastic strain dp of a step (Wilkins 1964; Simo & Hughes 1998, box
  /// 3.1), where q_trial (Pa) exceeds `yield`, the static flow stress at `p`. Newton's steps from perfect plasticity on
  /// a function that is convex or straight on the side of the reference rate where its zero lies; a lane keeps dp once
  /// |f| < 1e-13 s_y, so that its answer does not depend on the others. With linear hardening that is the second look,
  /// with a rate term at most the eleventh; 50 are the limit.
  template <class Number>
  inline PlasticIncrement<Number>
  compute_radial_increment(const Elasticity &elasticity, const Hardening &hardening, const Number &p,
                           const Number &yield, const Number &softening, const double dt, const Number &q_trial)
  {
    const auto         yields  = q_trial > yield;
    const double       three_g = 3. * elasticity.shear_modulus();
    const auto         fast    = is_fast_flow(hardening, p, dt, softening,
                                              [&](const Number &strain) { return Number(q_trial - three_g * strain); });
    Number             dp = select(yields, max(Number((q_trial - yield) * (1. / three_g)), Number(1e-12)), Number(0.));
    FlowStress<Number> flow{yield, Number(0.)};
    for (unsigned int iteration = 0;; ++iteration)
      {
        flow                  = compute_flow_stress(hardening, p, dp, dt, softening, fast);
        const Number residual = q_trial - three_g * dp - flow.value;
        const auto   open     = yields && (abs(residual) > 1e-13 * flow.value);
        if (iteration == 50 || !any(open))
          break;
        // never more than nine tenths of the way back to zero: dp > 0
        dp = select(open, max(Number(dp + residual / (three_g + flow.slope)), Number(0.1 * dp)), dp);
      }
    return {dp, select(yields, flow.value, yield), flow.slope};
  }

  /// J2 radial return in three dimensions. `stress` is the elastic trial in, with the square q2 of its von Mises stress
  /// (Pa^2), admissible out (Pa); lanes within the yield surface keep theirs.
  template <class Number>
  [[gnu::always_inline]] inline PlasticIncrement<Number>
  radial_return(const Elasticity &elasticity, const Hardening &hardening, const Number &p, const Number &yield,
                const Number &softening, const double dt, const Number &q2, Number (&stress)[6])
  {
    const Number q      = sqrt(q2);
    const auto   result = compute_radial_increment(elasticity, hardening, p, yield, softening, dt, q);
    const Number factor = 3. * elasticity.shear_modulus() * result.strain;
    scale_deviator(Number(Number(1.) - factor / max(q, yield)), stress);
    return result;
  }

  /// The same; nothing but the square is computed where no lane yields.
  template <class Number>
  inline PlasticIncrement<Number> radial_return(const Elasticity &elasticity, const Hardening &hardening,
                                                const Number &p, const Number &yield, const Number &softening,
                                                const double dt, Number (&stress)[6])
  {
    const Number q2 = von_mises_squared(stress);
    if (!any(q2 > yield * yield))
      return {Number(0.), yield, Number(0.)};
    return radial_return(elasticity, hardening, p, yield, softening, dt, q2, stress);
  }

  /// Half the axial vector of the antisymmetric part of a gradient g of displacement, the rotation of a step.
  template <class Number>
  [[gnu::always_inline]] inline Vector3<Number> compute_half_spin(const Matrix3<Number> &g)
  {
    return {Number(0.25 * (g(2, 1) - g(1, 2))), Number(0.25 * (g(0, 2) - g(2, 0))), Number(0.25 * (g(1, 0) - g(0, 1)))};
  }

  /// R s R^T with the rotation of a step R = (I - V)^{-1} (I + V), V the antisymmetric matrix of the half spin v taken
  /// from the midpoint gradient (Hughes & Winget 1980, eq. 22): objective for any angle.
  template <class Number>
  [[gnu::always_inline]] inline void rotate_hughes_winget(const Vector3<Number> &v, Number (&s)[6])
  {
    // R = I + f (V + V V), f = 2/(1 + v.v), V V = v v^T - v.v I
    const Number square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2], f = Number(2.) / (Number(1.) + square);
    const Number d = Number(1.) - f * square, x = f * v[0], y = f * v[1], z = f * v[2];
    const Number xy = x * v[1], yz = y * v[2], zx = z * v[0];
    const Number R[3][3] = {
      {d + x * v[0], xy - z, zx + y}, {xy + z, d + y * v[1], yz - x}, {zx - y, yz + x, d + z * v[2]}};
    const Number S[3][3] = {{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}};
    Number       T[3][3];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        T[i][j] = R[i][0] * S[0][j] + R[i][1] * S[1][j] + R[i][2] * S[2][j];
    const auto entry = [&](const int i, const int j) __attribute__((always_inline))
    {
      return Number(T[i][0] * R[j][0] + T[i][1] * R[j][1] + T[i][2] * R[j][2]);
    };
    s[0] = entry(0, 0);
    s[1] = entry(1, 1);
    s[2] = entry(2, 2);
    s[3] = entry(0, 1);
    s[4] = entry(1, 2);
    s[5] = entry(2, 0);
  }

  /// The symmetric part of a midpoint gradient of displacement, turned by half the step's rotation (to first order in
  /// the spin, V e - e V) to where the rotated stress is: their sum is then of second order in the step, as the
  /// midpoint rule is.
  template <class Number>
  [[gnu::always_inline]] inline void compute_turned_strain(const Matrix3<Number> &g, const Vector3<Number> &v,
                                                           Number (&e)[6])
  {
    const Number half = 0.5, xx = g(0, 0), yy = g(1, 1), zz = g(2, 2), xy = half * (g(0, 1) + g(1, 0)),
                 yz = half * (g(1, 2) + g(2, 1)), zx = half * (g(2, 0) + g(0, 2)), two = 2.;
    e[0] = xx + two * (v[1] * zx - v[2] * xy);
    e[1] = yy + two * (v[2] * xy - v[0] * yz);
    e[2] = zz + two * (v[0] * yz - v[1] * zx);
    e[3] = xy + v[2] * (xx - yy) + v[1] * yz - v[0] * zx;
    e[4] = yz + v[0] * (yy - zz) + v[2] * zx - v[1] * xy;
    e[5] = zx + v[1] * (zz - xx) + v[0] * xy - v[2] * yz;
  }
} // namespace birdstrike
