#pragma once

#include <birdstrike/material/elasticity.h>
#include <birdstrike/material/hardening.h>
#include <birdstrike/material/plane_stress_return.h>

namespace birdstrike
{
  /// Adds lambda tr(e) I + 2 G e to a stress (Pa).
  template <class Number>
  inline void add_elastic_stress(const Elasticity &elasticity, const Matrix3<Number> &strain, Matrix3<Number> &stress)
  {
    const double g      = elasticity.shear_modulus();
    const Number volume = (elasticity.bulk_modulus() - 2. / 3. * g) * (strain(0, 0) + strain(1, 1) + strain(2, 2));
    stress += 2. * g * strain;
    for (int i = 0; i < 3; ++i)
      stress(i, i) += volume;
  }

  /// Von Mises stress sqrt(3/2 s:s) (Pa).
  template <class Number>
  inline Number von_mises(const Matrix3<Number> &stress)
  {
    const Number    mean = (stress(0, 0) + stress(1, 1) + stress(2, 2)) / Number(3.);
    Matrix3<Number> s    = stress;
    for (int i = 0; i < 3; ++i)
      s(i, i) -= mean;
    return sqrt(1.5 * s.cwiseProduct(s).sum());
  }

  /// J2 radial return in three dimensions (Wilkins 1964; Simo & Hughes 1998, box 3.1): q_trial - 3 G dp = s_y(p + dp).
  /// Newton on dp, concave in dp from the left: monotone; ends when all lanes have |f| < 1e-13 s_y. `stress` is the
  /// elastic trial in, admissible out (Pa); `yield` the static flow stress at `p`.
  template <class Number>
  inline PlasticIncrement<Number> radial_return(const Elasticity &elasticity, const Hardening &hardening,
                                                const Number &p, const Number &yield, const double dt,
                                                Matrix3<Number> &stress)
  {
    const Number q_trial = von_mises(stress);
    const auto   yields  = q_trial > yield;
    if (!any(yields))
      return {Number(0.), yield, Number(0.)};
    const double       three_g = 3. * elasticity.shear_modulus();
    Number             dp      = select(yields, Number(1e-12), Number(0.));
    FlowStress<Number> flow{yield, Number(0.)};
    for (unsigned int iteration = 0; iteration < 50; ++iteration)
      {
        flow                  = compute_flow_stress(hardening, p, dp, dt, Number(1.));
        const Number residual = q_trial - three_g * dp - flow.value;
        if (!any(yields && (abs(residual) > 1e-13 * flow.value)))
          break;
        dp = select(yields, max(Number(dp + residual / (three_g + flow.slope)), Number(0.1 * dp)), Number(0.));
      }
    const Number    mean  = (stress(0, 0) + stress(1, 1) + stress(2, 2)) / Number(3.);
    const Number    scale = select(yields, Number(1.) - three_g * dp / q_trial, Number(1.));
    Matrix3<Number> s     = stress;
    for (int i = 0; i < 3; ++i)
      s(i, i) -= mean;
    stress = s * scale;
    for (int i = 0; i < 3; ++i)
      stress(i, i) += mean;
    return {dp, select(yields, flow.value, yield), flow.slope};
  }

  /// R s R^T with the rotation of a step from the antisymmetric part w of the midpoint displacement gradient,
  /// R = (I - w/2)^{-1} (I + w/2) (Hughes & Winget 1980, eq. 22): objective for any angle.
  template <class Number>
  inline Matrix3<Number> rotate_hughes_winget(const Matrix3<Number> &w, const Matrix3<Number> &stress)
  {
    // with the axial vector v of w/2: R = I + 2/(1 + v.v) (V + V V)
    Vector3<Number> v;
    v << 0.5 * w(2, 1), 0.5 * w(0, 2), 0.5 * w(1, 0);
    Matrix3<Number> V;
    V << Number(0.), -v[2], v[1], v[2], Number(0.), -v[0], -v[1], v[0], Number(0.);
    const Number    factor = Number(2.) / (Number(1.) + v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    Matrix3<Number> R      = factor * (V + V * V);
    for (int i = 0; i < 3; ++i)
      R(i, i) += Number(1.);
    return R * stress * R.transpose();
  }
} // namespace birdstrike
