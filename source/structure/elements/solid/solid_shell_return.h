#pragma once

#include "structure/elements/thickness_points.h"
#include <birdstrike/material/elasticity.h>
#include <birdstrike/material/hardening.h>

namespace birdstrike
{
  /// J2 return of all points through the thickness of a solid-shell at once, with one stress across the section.
  ///
  /// The stress s across the thickness is the same at all points (what equilibrium of a free face asks: it does not
  /// bend the section), the strain across varies freely about its given mean. J2 does not see a hydrostatic stress:
  /// relative to s each point is in plane stress, with transverse shear. Let T be the trace of its trial stress
  /// relative to s, r^2 what its other components make of von Mises' square, z^2 that of what varies in the plane of
  /// the element. If s moves by d from its elastic trial, the hydrostatic part takes d/(3 K) of the strains in the
  /// plane, and with chi = dp/q (Simo & Taylor 1986)
  ///   q^2 = 1/4 f^2 (T - 2 B d)^2 + g^2 r^2 + h^2 z^2,   B = (1 - 2 nu)/(1 - nu),
  ///   f = 1/(1 + E chi/(2 (1 - nu))),  g = 1/(1 + 3 G chi),  h = 1/(1 + 4 G chi).
  /// h is the rate of what counts by 4/9 in q^2 but by 1/3 in the work (see SolidFlow). Unknown are chi at each point,
  /// from q = s_y(p + chi q), and d, from the pressure, which stays elastic:
  ///   3 d + mean of [f (T - 2 B d) - T] = 0,
  /// which makes of points that are all alike the radial return in three dimensions.
  ///
  /// Solved by Newton for all unknowns at once: the matrix is an arrow, whose slope of the second equation lies between
  /// 3 - 2 B and 3 whatever the points do. Steps of chi are those of plane_stress_return; d then follows exactly from
  /// the factors f, so the pressure is kept by any iterate and d stays within the range of T/3. Starts at chi = 0 with
  /// perfect plasticity, ends with the step after q is within 1e-7 of s_y (quadratic: what is left is round-off); that
  /// is the third or fourth. Each lane ends by itself: what it gets does not depend on its neighbours.
  template <class Number>
  struct SolidShellReturn
  {
    using Mask = decltype(Number() > Number());

    struct Point
    {
      Number trace, rest, varying;                      ///< T (Pa), r^2, z^2 (Pa^2) of the trial
      Number plastic_strain, yield, softening;          ///< before the step; yield is static (Pa)
      Number chi;                                       ///< dp/q, 1/Pa
      Number trace_factor, rest_factor, varying_factor; ///< f, g, h
      Number step, step_by_shift;                       ///< of chi, and what a shift of s adds to it
    };
    Number shift = Number(0.); ///< d, Pa
    Point  point[max_thickness_points];

    SolidShellReturn(const Elasticity &elasticity, const Hardening &hardening, const ThicknessPoints &rule)
      : hardening(hardening)
      , rule(rule)
      , trace_rate(elasticity.young / (2. * (1. - elasticity.poisson)))
      , rest_rate(3. * elasticity.shear_modulus())
      , varying_rate(4. * elasticity.shear_modulus())
      , shift_factor((1. - 2. * elasticity.poisson) / (1. - elasticity.poisson))
    {
    }

    /// T at the present shift.
    Number shifted_trace(const Point &p) const
    {
      return p.trace - (2. * shift_factor) * shift;
    }

    /// q^2 of a point with its present factors (Pa^2).
    Number square(const Point &p) const
    {
      const Number trace = shifted_trace(p) * p.trace_factor;
      return 0.25 * trace * trace + p.rest * p.rest_factor * p.rest_factor +
             p.varying * p.varying_factor * p.varying_factor;
    }

    /// From the trial to chi, factors and shift, once, of the lanes that yield.
    void solve(const double dt, const Mask &yields)
    {
      for (unsigned int k = 0; k < rule.n; ++k)
        {
          point[k].chi          = Number(0.);
          point[k].trace_factor = point[k].rest_factor = point[k].varying_factor = Number(1.);
        }
      Mask goes_on = yields;
      for (unsigned int iteration = 0; any(goes_on) && iteration < 80; ++iteration)
        {
          // what the points' steps make of the pressure, and its slope
          Number     residual = Number(0.), slope = Number(3.);
          const Mask steps = goes_on;
          goes_on          = Mask(false);
          for (unsigned int k = 0; k < rule.n; ++k)
            goes_on = linearize(point[k], 0.5 * rule.weight[k], dt, residual, slope) || goes_on;
          goes_on           = goes_on && steps;
          const Number move = -residual / slope;
          for (unsigned int k = 0; k < rule.n; ++k)
            step(point[k], move, iteration, steps);
          update_shift();
        }
      for (unsigned int k = 0; k < rule.n; ++k) // those that another point's flow has unloaded
        point[k].chi = select(trace_rate * point[k].chi > Number(smallest), point[k].chi, Number(0.));
    }

  private:
    static constexpr double smallest = 1e-13; ///< of E chi/(2 (1 - nu)): less than round-off of the stress
    /// Never more than nine tenths of the way back to zero. Where a kink (the threshold of a rate) throws Newton to and
    /// fro, the way shrinks until it stays; trials of more than twice the yield stress may stay 1e-5 off.
    [[gnu::always_inline]] void step(Point &p, const Number &move, const unsigned int iteration,
                                     const Mask &steps) const
    {
      const Number target = max(Number(p.chi + p.step + p.step_by_shift * move), Number(0.1 * p.chi));
      const double most   = iteration < 8 ? 1e300 : std::exp2(24. * std::pow(0.75, iteration - 8.));
      const Number held   = min(max(target, Number((1. / most) * p.chi)), Number(p.chi * most));
      p.chi               = select(steps, select(p.chi > Number(0.), held, target), p.chi);
    }

    /// Factors of the points, and the shift that keeps the pressure with them.
    [[gnu::always_inline]] void update_shift()
    {
      Number lost = Number(0.), slope = Number(3.);
      for (unsigned int k = 0; k < rule.n; ++k)
        {
          Point       &p = point[k];
          const double w = 0.5 * rule.weight[k];
          // three quotients with one division
          const Number one = 1., d0 = one + trace_rate * p.chi, d1 = one + rest_rate * p.chi;
          const Number d2 = one + varying_rate * p.chi, d01 = d0 * d1, inverse = one / (d01 * d2), i01 = inverse * d2;
          p.trace_factor   = i01 * d1;
          p.rest_factor    = i01 * d0;
          p.varying_factor = inverse * d01;
          lost += w * (one - p.trace_factor) * p.trace;
          slope -= (2. * shift_factor * w) * p.trace_factor;
        }
      shift = lost / slope;
    }

    /// Newton's step of a point; adds its share to the equation of the pressure. True where it is not converged.
    [[gnu::always_inline]] Mask linearize(Point &p, const double weight, const double dt, Number &residual,
                                          Number &slope) const
    {
      const Number trace = shifted_trace(p), f = p.trace_factor, f2 = f * f;
      const Number trace2 = 0.25 * trace * trace * f2, rest2 = p.rest * p.rest_factor * p.rest_factor;
      const Number varying2 = p.varying * p.varying_factor * p.varying_factor;
      const Number q2 = trace2 + rest2 + varying2, q = sqrt(q2);
      const auto   flows  = p.chi > Number(0.);
      const auto   yields = flows || q2 > p.yield * p.yield;
      const Number fall   = // -q dq/dchi
        trace_rate * trace2 * f + rest_rate * rest2 * p.rest_factor + varying_rate * varying2 * p.varying_factor;
      const auto flow = compute_flow_stress(hardening, p.plastic_strain, Number(p.chi * q), dt, p.softening);
      // laws with a vertical tangent start from perfect plasticity
      const Number y = flow.value, y2 = y * y, rise = select(flows, flow.slope, Number(0.));
      // h = 1/q - 1/y times q^3 y^2, and its slopes
      const Number inverse = Number(1.) / (fall * y2 + rise * (q2 - p.chi * fall) * q2);
      p.step               = select(yields, q2 * y * (q - y) * inverse, Number(0.));
      p.step_by_shift =
        select(yields, (0.5 * shift_factor) * trace * f2 * (rise * p.chi * q2 - y2) * inverse, Number(0.));
      const Number change = (-weight * trace_rate) * f2 * trace;
      residual += change * p.step;
      slope += change * p.step_by_shift - (2. * shift_factor * weight) * f;
      // quadratic: what was below 1e-7 is round-off after this step
      return yields && (abs(q - y) > 1e-7 * y) && (trace_rate * p.chi > Number(smallest) || !flows);
    }

    const Hardening       &hardening;
    const ThicknessPoints &rule;
    double                 trace_rate, rest_rate, varying_rate, shift_factor;
  };
} // namespace birdstrike
