#pragma once

#include <birdstrike/material/radial_return.h>

namespace birdstrike
{
  /// Plastic flow of a one-point brick as a whole, on Ilyushin's surface for stress resultants (N/N_p and M/M_p in a
  /// circle): with the von Mises stress of the mean and those of the parts of the stress that vary in the element, each
  /// over the value at which its section is fully plastic,
  ///   q^2 = q_mean^2 + q_trace^2 + q_shear^2 + q_last^2 = s_y^2.
  /// By the associated flow every part decays with chi = dp/q, as in plane stress (Simo & Taylor 1986):
  ///   q_part = q_part,trial/(1 + a chi),
  /// a = 3 G of the mean; (4/3) E/(2 (1 - nu)) and 4 G of the traces and the rest of the plane stresses; 16/9 E of the
  /// uniaxial ones. The factors 4/3 and 16/9 are (2/3)^2/(1/3) and (4/9)^2/(1/9):
  /// what the surface weighs a part with, over its share in the work. With that the plastic work per volume is s_y dp.
  template <class Number>
  struct SolidFlow
  {
    Number strain, stress;                                       ///< dp, and the flow stress reached (Pa)
    Number mean_factor, trace_factor, shear_factor, last_factor; ///< q_part/q_part,trial
    Number rest;                                                 ///< share of the varying parts in q^2 and in the work

    /// `square`: of the trial (Pa^2), mean, trace, shear, last; `yield` the static flow stress at `p`. Newton on 1/q -
    /// 1/s_y, nearly linear in chi, on the side of the reference rate where its zero lies; all lanes go on until the
    /// last has |q/s_y - 1| < 1e-13, 30 steps are the limit.
    [[gnu::always_inline]] SolidFlow(const Elasticity &elasticity, const Hardening &hardening, const Number &p,
                                     const Number &yield, const Number &softening, const double dt,
                                     const Number (&square)[4])
    {
      const double young = elasticity.young, three_g = 3. * elasticity.shear_modulus();
      const double rate[4] = {three_g, 2. / 3. * young / (1. - elasticity.poisson), 4. / 3. * three_g,
                              16. / 9. * young};
      const Number one = 1., trial2 = square[0] + square[1] + square[2] + square[3], trial = sqrt(trial2);
      const auto   yields = trial > yield;
      // straight on from the trial: exact for the mean alone and perfect plasticity
      const Number slowing = rate[0] * square[0] + rate[1] * square[1] + rate[2] * square[2] + rate[3] * square[3];
      const Number start   = (trial - yield) * trial2 / (yield * slowing);
      Number       chi     = select(yields, max(start, Number(1e-12 / three_g)), Number(0.));
      const auto   fast    = is_fast_flow(hardening, p, dt, softening, [&](const Number &dp) {
        // where chi q = dp: a first guess and one more, the strain is small
        const Number first = compute_stress(square[0], square[1], square[2], square[3], rate, Number(dp / trial));
        return compute_stress(square[0], square[1], square[2], square[3], rate, Number(dp / first));
      });
      Number       factor[4], q = trial;
      FlowStress<Number> flow{yield, Number(0.)};
      for (unsigned int iteration = 0;; ++iteration)
        {
          // four quotients with one division
          const Number d0 = one + rate[0] * chi, d1 = one + rate[1] * chi, d2 = one + rate[2] * chi;
          const Number d3 = one + rate[3] * chi, d01 = d0 * d1, d23 = d2 * d3, inverse = one / (d01 * d23);
          const Number i01 = inverse * d23, i23 = inverse * d01;
          factor[0] = i01 * d1;
          factor[1] = i01 * d0;
          factor[2] = i23 * d3;
          factor[3] = i23 * d2;
          Number q2 = 0., slope = 0.;
          for (int part = 0; part < 4; ++part)
            {
              const Number now = square[part] * factor[part] * factor[part];
              q2 += now;
              slope += rate[part] * now * factor[part];
            }
          q                     = sqrt(q2);
          flow                  = compute_flow_stress(hardening, p, Number(chi * q), dt, softening, fast);
          const Number residual = q - flow.value;
          const auto   open     = yields && (abs(residual) > 1e-13 * flow.value);
          if (iteration == 30 || !any(open))
            break;
          // h = 1/q - 1/s, q' = -slope/q, h' = -q'/q^2 + s' (q + chi q')/s^2; never more than nine tenths back to zero
          const Number s2 = flow.value * flow.value, dq = -slope / q;
          const Number step = q * flow.value * residual / (-dq * s2 + flow.slope * (q + chi * dq) * q2);
          chi               = select(open, max(Number(chi + step), Number(0.1 * chi)), chi);
        }
      strain       = select(yields, Number(chi * q), Number(0.));
      stress       = flow.value;
      mean_factor  = factor[0];
      trace_factor = factor[1];
      shear_factor = factor[2];
      last_factor  = factor[3];
      rest         = one - square[0] * mean_factor * mean_factor / max(Number(q * q), Number(1e-300));
    }

  private:
    /// q at a chi. Apart and by value, for only laws with a rate term ask: the others keep their registers.
    [[gnu::noinline]] static Number compute_stress(const Number mean, const Number trace, const Number shear,
                                                   const Number last, const double (&rate)[4], const Number chi)
    {
      const Number one = 1., a = one + rate[0] * chi, b = one + rate[1] * chi, c = one + rate[2] * chi,
                   d = one + rate[3] * chi;
      return sqrt(Number(mean / (a * a) + trace / (b * b) + shear / (c * c) + last / (d * d)));
    }
  };
} // namespace birdstrike
