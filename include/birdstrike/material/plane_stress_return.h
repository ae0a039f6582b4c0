#pragma once

#include <birdstrike/material/elasticity.h>
#include <birdstrike/material/hardening.h>

namespace birdstrike
{
  /// Square of the von Mises stress (Pa^2) of a plane state (sxx, syy, sxy).
  template <class Number>
  inline Number von_mises_plane_squared(const Number (&s)[3])
  {
    return s[0] * s[0] - s[0] * s[1] + s[1] * s[1] + 3. * s[2] * s[2];
  }

  /// Von Mises stress (Pa) of a plane state.
  template <class Number>
  inline Number von_mises_plane(const Number (&s)[3])
  {
    return sqrt(von_mises_plane_squared(s));
  }

  /// What a return to the yield surface did.
  template <class Number>
  struct PlasticIncrement
  {
    Number strain; ///< increment of the equivalent plastic strain, -
    Number stress; ///< flow stress reached (Pa); where nothing yielded, the one that was passed in
    Number slope;  ///< hardening slope d stress / d strain (Pa) where it yielded
  };

  namespace internal
  {
    /// The trial state in the eigenvectors that elasticity and yield function share: q(chi)^2 = volumetric part + rest,
    ///   q^2 = 1/2 s_+^2 / (1 + E chi / (2 (1 - nu)))^2 + r^2 / (1 + 3 G chi)^2,
    /// s_+ = (sxx + syy)/sqrt(2), r^2 = 3/4 (sxx - syy)^2 + 3 sxy^2, chi = dp/q.
    template <class Number>
    struct PlaneTrial
    {
      Number plus, rest; ///< 1/2 s_+^2 and r^2 of the trial state
      double a, b;       ///< E / (2 (1 - nu)), 3 G

      /// q and dq/dchi
      void compute_stress(const Number &chi, Number &q, Number &dq) const
      {
        const Number f = Number(1.) / (Number(1.) + a * chi), g = Number(1.) / (Number(1.) + b * chi);
        const Number p2 = plus * f * f, r2 = rest * g * g;
        q  = sqrt(p2 + r2);
        dq = -(a * p2 * f + b * r2 * g) / q;
      }
    };
  } // namespace internal

  /// J2 plasticity in plane stress: takes the elastic trial stress back to the yield surface (Simo & Taylor 1986).
  ///
  /// Solved is h(chi) = 1/q(chi) - 1/s_y(p + chi q) = 0, nearly linear in chi (exactly so for nu = 1/2 and perfect
  /// plasticity), by Newton from the solution for nu = 1/2 and perfect plasticity, on the side of the reference rate
  /// where its zero lies. A lane keeps chi once |q/s_y - 1| < 1e-13, so that its answer does not depend on the others;
  /// three steps suffice without rate dependence, 30 are the limit. Lanes with q <= yield keep their stress. `yield` is
  /// the static flow stress at `p` (softened), `stress` trial in, admissible out (Pa).
  template <class Number>
  inline PlasticIncrement<Number> plane_stress_return(const Elasticity &elasticity, const Hardening &hardening,
                                                      const Number &p, const Number &yield, const Number &softening,
                                                      const double dt, Number (&stress)[3])
  {
    const Number q_trial = von_mises_plane(stress);
    const auto   yields  = q_trial > yield;
    if (!any(yields))
      return {Number(0.), yield, Number(0.)};

    const Number                       sum = stress[0] + stress[1], difference = stress[0] - stress[1];
    const double                       three_g = 3. * elasticity.shear_modulus();
    const internal::PlaneTrial<Number> trial{0.25 * sum * sum,
                                             0.75 * difference * difference + 3. * stress[2] * stress[2],
                                             elasticity.young / (2. * (1. - elasticity.poisson)), three_g};

    Number             chi = select(yields, max(q_trial / yield - Number(1.), Number(1e-12)) / three_g, Number(0.));
    Number             q   = q_trial, dq;
    FlowStress<Number> flow{yield, Number(0.)};
    const auto         fast = is_fast_flow(hardening, p, dt, softening, [&](const Number &dp) {
      Number left, slope; // where chi q = dp: a first guess and one more
      trial.compute_stress(Number(dp / q_trial), left, slope);
      trial.compute_stress(Number(dp / left), left, slope);
      return left;
    });
    for (unsigned int iteration = 0;; ++iteration)
      {
        trial.compute_stress(chi, q, dq);
        flow                  = compute_flow_stress(hardening, p, Number(chi * q), dt, softening, fast);
        const Number residual = q - flow.value;
        const auto   open     = yields && (abs(residual) > 1e-13 * flow.value);
        if (iteration == 30 || !any(open))
          break;
        // h = 1/q - 1/s, h' = -q'/q^2 + s' (q + chi q')/s^2
        const Number s2 = flow.value * flow.value, q2 = q * q;
        const Number step = q * flow.value * residual / (-dq * s2 + flow.slope * (q + chi * dq) * q2);
        // never more than nine tenths of the way back to zero: chi > 0
        chi = select(open, max(Number(chi + step), Number(0.1 * chi)), chi);
      }
    const Number f = Number(1.) / (Number(1.) + trial.a * chi), g = Number(1.) / (Number(1.) + trial.b * chi);
    stress[0] = select(yields, 0.5 * (sum * f + difference * g), stress[0]);
    stress[1] = select(yields, 0.5 * (sum * f - difference * g), stress[1]);
    stress[2] = select(yields, stress[2] * g, stress[2]);
    return {select(yields, Number(chi * q), Number(0.)), select(yields, flow.value, yield), flow.slope};
  }
} // namespace birdstrike
