#pragma once

#include <birdstrike/core/number.h>

#include <array>

namespace birdstrike
{
  /// Constants of the law for one step.
  struct ContactLaw
  {
    double stiffness_scale = 1.;
    double damping_scale   = 1.;
    double stability_share = 0.4;
    double friction        = 0.;
    double hugoniot_slope  = 0.; ///< s in p = rho c u (1 + s u/c)
    double step            = 0.; ///< s
  };

  /// One point in touch with one facet.
  template <class Number>
  struct Touch
  {
    Number          penetration;  ///< d, m, > 0
    Number          size;         ///< V^(1/3), m
    Number          density;      ///< kg/m^3
    Number          sound_speed;  ///< m/s
    Number          reduced_mass; ///< kg
    Vector3<Number> normal;       ///< from the facet to the point
    Vector3<Number> velocity;     ///< of the point relative to the facet's closest point, m/s
  };

  template <class Number>
  struct ContactForce
  {
    Vector3<Number> force;             ///< on the point, N
    Number          normal_force;      ///< its part along the normal, N, >= 0
    Number          stored_energy;     ///< k d^2 / 2, J
    Number          dissipation_power; ///< of damper and friction, W
  };

  /// 1/m_red = 1/m + sum_k w_k^2 / m_k: the inverse mass that two opposite unit forces feel, on the point and, shared
  /// by the weights w_k, on the nodes. The nodes' inverse masses are zero where they are held.
  template <class Number>
  Number compute_reduced_mass(const Number &mass, const std::array<Number, 4> &weights,
                              const std::array<Number, 4> &inverse_masses)
  {
    Number inverse = Number(1.) / mass;
    for (unsigned int k = 0; k < 4; ++k)
      inverse += weights[k] * weights[k] * inverse_masses[k];
    return Number(1.) / inverse;
  }

  /// F = k d + A rho c max(u, 0) (1 + s u/c),  k = min(rho c^2 A / V^(1/3), share m_red / dt^2),  A = V^(2/3),
  /// with the approach speed u. A soft body's own modulus sets the stiffness: the pressure p of a column is carried at
  /// d = p V^(1/3) / (rho c^2), a tenth of a spacing at shock pressures, where a metal's modulus would be thirty times
  /// too stiff for the step. The damper is the pressure rho (c + s u) u behind a shock that the surface drives into the
  /// body (Rankine-Hugoniot with U_s = c + s u), so the first touch needs no overlap.
  ///
  /// The damper lags by half a step; limited to m_red u / dt it cannot reverse u. With a = k dt^2/m and b = its share
  /// of m_red u / dt the leapfrog is stable for a + 2 b < 4; here a <= 0.4 and b <= 1.
  ///
  /// Friction opposes the slip with mu F_n, limited likewise so that it stops the slip and does not reverse it.
  template <class Number>
  ContactForce<Number> compute_contact_force(const ContactLaw &law, const Touch<Number> &touch)
  {
    const Number zero(0.), step(law.step);
    const Number inertia     = touch.reduced_mass / step;
    const Number normal_rate = touch.velocity.dot(touch.normal), approach = max(zero, -normal_rate);
    const Number area = touch.size * touch.size;

    const Number stiffness =
      min(Number(law.stiffness_scale) * touch.density * touch.sound_speed * touch.sound_speed * touch.size,
          Number(law.stability_share) * inertia / step);
    const Number shock = Number(law.damping_scale) * area * touch.density * approach *
                         (touch.sound_speed + Number(law.hugoniot_slope) * approach);
    const Number damping = min(shock, inertia * approach);

    ContactForce<Number> result;
    result.normal_force      = stiffness * touch.penetration + damping;
    result.force             = result.normal_force * touch.normal;
    result.stored_energy     = Number(0.5) * stiffness * touch.penetration * touch.penetration;
    result.dissipation_power = damping * approach;
    if (law.friction > 0.)
      {
        const Vector3<Number> slip  = touch.velocity - normal_rate * touch.normal;
        const Number          speed = sqrt(slip.dot(slip));
        const Number          drag  = min(Number(law.friction) * result.normal_force, inertia * speed);
        result.force -= (drag / max(speed, Number(1e-300))) * slip;
        result.dissipation_power += drag * speed;
      }
    return result;
  }
} // namespace birdstrike
