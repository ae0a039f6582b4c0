#pragma once

#include <birdstrike/core/number.h>

#include <array>
#include <cmath>

namespace birdstrike
{
  /// Constants of the law for one step.
  struct ContactLaw
  {
    double stiffness_scale = 1.;
    double damping_scale   = 1.;
    double friction        = 0.;
    double hugoniot_slope  = 0.; ///< s in p = rho c u (1 + s u/c)
    double step            = 0.; ///< s
    double shock_pressure  = 0.; ///< over rho0 c0^2: the Hugoniot pressure of the speed at which bird and blade close

    static constexpr double largest_shock_depth = 0.3; ///< over L

    /// beta L of ContactSpring: 4 s/3 or, where that would carry the shock deeper than 0.3 L, what carries it there.
    /// `softening` is rho0 c0^2 over the spring's modulus, more than 1 where the target is light.
    double hardening(const double softening = 1.) const
    {
      const double d = largest_shock_depth, p = softening * shock_pressure, usual = 4. / 3. * hugoniot_slope;
      const double rest = 1. - usual * d;
      if (p * rest * rest <= d * (1. - 0.5 * usual * d))
        return usual;
      const double b = p - 0.25 * d; // p (1 - y)^2 = d (1 - y/2)
      return (b - std::sqrt(b * b - p * (p - d))) / (p * d);
    }
  };

  /// One point in touch with one facet.
  template <class Number>
  struct Touch
  {
    Number          penetration;  ///< d, m, > 0
    Number          size;         ///< L = V^(1/3), m, of the undeformed point
    Number          modulus;      ///< rho0 c0^2, Pa, of the undeformed point, less where the target is light
    Number          hardening;    ///< beta L of ContactSpring
    Number          density;      ///< kg/m^3, now
    Number          sound_speed;  ///< m/s, now
    Number          reduced_mass; ///< kg, shared among all touches of point and nodes (compute_reduced_mass)
    Vector3<Number> normal;       ///< -grad d: from the facet to the point; not of length 1 where the thickness changes
    Vector3<Number> velocity;     ///< of the point relative to the facet's closest point, m/s
  };

  template <class Number>
  struct ContactForce
  {
    Vector3<Number> force;         ///< on the point, N
    Vector3<Number> dissipative;   ///< the part of damper and friction, N
    Number          normal_force;  ///< the force along the normal, N, >= 0
    Number          stored_energy; ///< of the spring, J
    Number          tangent;       ///< dF/dd of the spring, N/m
  };

  /// The spring: a potential of the depth d alone,
  ///
  ///   U = k d^2 / (2 (1 - y)),   F = k d (1 - y/2) / (1 - y)^2,   F' = k / (1 - y)^3,   y = beta d,
  ///   k = rho0 c0^2 L,   beta = 4 s / (3 L).
  ///
  /// It is a cell of the liquid, L long and of area L^2, compressed by eta = d/L: k is its stiffness, and beta makes
  /// the force follow its Hugoniot curve p = rho0 c0^2 eta/(1 - s eta)^2 to second order in eta, and be stiffer beyond.
  /// So the depth that carries a shock is 0.12 L at 177 m/s, 0.2 L at 500 m/s and 0.3 L at 1500 m/s in
  /// Murnaghan's liquid. A linear one would be pressed in twice as deep: beta is raised there so that the shock at the
  /// speed of the strike is carried 0.3 L deep (ContactLaw::hardening; no shipped strike is as fast). Beyond y = 3/4
  /// the force goes on along its tangent. Nothing in it changes with time or with the state of the liquid: what the
  /// spring gives it has received. A stiffer one would ask for shorter steps than the liquid itself, a metal's modulus
  /// for a thirtieth of them.
  template <class Number>
  struct ContactSpring
  {
    static constexpr double largest_ratio = 0.75; ///< of y

    ContactSpring(const Number &stiffness, const Number &beta, const Number &depth)
    {
      const Number y = min(beta * depth, Number(largest_ratio)), rest = Number(1.) / (Number(1.) - y);
      const Number d = min(depth, Number(largest_ratio) / max(beta, Number(1e-300))), beyond = depth - d;
      const Number at_end = stiffness * d * (Number(1.) - Number(0.5) * y) * rest * rest;
      tangent             = stiffness * rest * rest * rest;
      force               = at_end + tangent * beyond;
      energy              = Number(0.5) * stiffness * d * d * rest + (at_end + Number(0.5) * tangent * beyond) * beyond;
    }

    Number force, tangent, energy; ///< N, N/m, J
  };

  /// The share of a spring's force that acts in the step in which its touch begins or ends: (1 + d/w)/2 at a depth d
  /// less than the way w of one step, 1 beyond. Leapfrog kicks with the force at the end of a step as if it had acted,
  /// or as if it went on to act, for all of it. On the part of the way that is outside, a spring of frequency omega
  /// would take (omega dt)^2/6 of the energy that its point brings, as a mean over where steps begin, and give as much
  /// to one that leaves, more slowly where a damper has acted. With the share what is too much before d is too little
  /// behind it: work over both steps is the spring's energy, impulse that of the force in time, exactly for a linear
  /// spring and even motion.
  template <class Number>
  Number share_of_partial_step(const Number &depth, const Number &way)
  {
    return Number(0.5) * (Number(1.) + min(depth / max(way, Number(1e-300)), Number(1.)));
  }

  /// 1/m_red = S_p/m_p + sum_k w_k S_k/m_k: the inverse mass that two opposite unit forces feel, on a point and, shared
  /// by the weights w_k, on nodes, where each touch owns the part of a mass that its weight is of the sum S of the
  /// weights of all touches there (mass splitting: Tonge, Benevolenski & Voroshilov, "Mass splitting for jitter-free
  /// parallel rigid body simulation", 2012). Impulses that take no more than all relative velocity of such parts take
  /// energy from each; joining the parts again takes more. So any number of dampers on one node together take, and
  /// never make, energy. `inverse_masses` are S_k/m_k, zero where nodes are held.
  template <class Number>
  Number compute_reduced_mass(const Number &inverse_mass, const std::array<Number, 4> &weights,
                              const std::array<Number, 4> &inverse_masses)
  {
    Number inverse = inverse_mass;
    for (unsigned int k = 0; k < 4; ++k)
      inverse += weights[k] * inverse_masses[k];
    return Number(1.) / inverse;
  }

  /// Spring, damper and friction on one point. The damper is the pressure rho (c + s u) u behind a shock that the
  /// surface drives into the liquid (Rankine-Hugoniot with U_s = c + s u) with the approach speed u, on the area L^2:
  /// the first touch needs no overlap. It lags by half a step; limited to m_red u / dt it cannot reverse u, and only
  /// takes. Friction opposes the slip with mu F_n, limited likewise so that it stops the slip and does not reverse it.
  /// Spring and damper act along -grad d, which is not of length 1 where the thickness changes (thickness_slope.h).
  ///
  /// The stable step of the springs is no part of this law: see TouchBounds.
  template <class Number>
  ContactForce<Number> compute_contact_force(const ContactLaw &law, const Touch<Number> &touch)
  {
    const Number zero(0.), slope(law.hugoniot_slope);
    const Number inertia     = touch.reduced_mass / Number(law.step);
    const Number squared     = touch.normal.dot(touch.normal); // of grad d
    const Number normal_rate = touch.velocity.dot(touch.normal), approach = max(zero, Number(-normal_rate));
    const Number area = touch.size * touch.size;

    const ContactSpring<Number> spring(Number(law.stiffness_scale) * touch.modulus * touch.size,
                                       touch.hardening / touch.size, touch.penetration);
    const Number                shock =
      Number(law.damping_scale) * area * touch.density * approach * (touch.sound_speed + slope * approach);
    const Number damping = min(shock, Number(inertia * approach / squared));
    const Number way     = max(normal_rate, Number(-normal_rate)) * Number(law.step);
    const Number pressed = share_of_partial_step(touch.penetration, way) * spring.force;

    ContactForce<Number> result;
    result.normal_force  = (pressed + damping) * sqrt(squared);
    result.dissipative   = damping * touch.normal;
    result.stored_energy = spring.energy;
    result.tangent       = spring.tangent * squared;
    if (law.friction > 0.)
      {
        const Vector3<Number> slip  = touch.velocity - (normal_rate / squared) * touch.normal;
        const Number          speed = sqrt(slip.dot(slip));
        const Number          drag  = min(Number(law.friction) * result.normal_force, Number(inertia * speed));
        result.dissipative -= (drag / max(speed, Number(1e-300))) * slip;
      }
    result.force = pressed * touch.normal + result.dissipative;
    return result;
  }
} // namespace birdstrike
