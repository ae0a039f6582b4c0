#pragma once

#include <birdstrike/blade/solid_elements.h>
#include <birdstrike/blade/solid_one_point.h>
#include <birdstrike/material/radial_return.h>

namespace birdstrike
{
  /// State of one point of a brick.
  template <class Number>
  struct SolidPoint
  {
    Number stress[6];      ///< xx, yy, zz, xy, yz, zx, Pa, global axes
    Number plastic_strain; ///< equivalent, -
    Number yield;          ///< Pa, static flow stress there
    Number plastic_work;   ///< J/m^3, what heats

    [[gnu::always_inline]] void rotate_and_strain(const Elasticity &elasticity, const Matrix3<Number> &gradient)
    {
      const Vector3<Number> spin = compute_half_spin(gradient);
      Number                strain[6];
      compute_turned_strain(gradient, spin, strain);
      rotate_hughes_winget(spin, stress);
      add_elastic_stress(elasticity, strain, stress);
    }
  };

  /// Work per volume (J/m^3) of one step.
  template <class Number>
  struct SolidWork
  {
    Number plastic, hourglass;
  };

  /// Stress of solid elements from strain increments: J2 with radial return, and the bulk viscosity.
  ///
  /// The stabilisation of the one-point brick flows with the mean: its stresses are those at points within the element,
  /// relative to the mean. An element yields when
  ///   q^2 = q_mean^2 + sum (2/3 q_k)^2 + ...
  /// exceeds the flow stress, where q_k are the von Mises stresses of the linear parts (Ilyushin's surface for stress
  /// resultants: M/M_p and N/N_p in a circle): one brick then carries the plastic moment, no more. The deviator of the
  /// mean and the stabilisation are returned together. While the mean flows at a rate e', this leaves a variation d' of
  /// the strain rate the stress 2/3 s_y d'/e', which is the linearised return at these points: what is plastic gets
  /// soft without a tangent or a coefficient.
  struct SolidLaw
  {
    explicit SolidLaw(const SolidSection &section)
      : elasticity(section.material.elasticity)
      , hardening(section.material.hardening)
      , density(section.material.density)
      , wave_speed(std::sqrt((elasticity.bulk_modulus() + 4. / 3. * elasticity.shear_modulus()) / density))
      , linear_viscosity(section.linear_viscosity)
      , quadratic_viscosity(section.quadratic_viscosity)
    {
    }

    Elasticity elasticity;
    Hardening  hardening;
    double     density;    ///< kg/m^3
    double     wave_speed; ///< of dilatation, m/s
    double     linear_viscosity, quadratic_viscosity;

    double initial_yield() const
    {
      return compute_flow_stress(hardening, 0., 0., 1., thermal_softening(hardening, hardening.initial_temperature))
        .value;
    }

    /// A step of one point; returns the plastic work per volume (J/m^3).
    template <class Number>
    [[gnu::always_inline]] Number update_point(const Matrix3<Number> &gradient, const double dt,
                                               SolidPoint<Number> &point) const
    {
      point.rotate_and_strain(elasticity, gradient);
      const Number q2 = von_mises_squared(point.stress);
      if (!any(q2 > point.yield * point.yield))
        return Number(0.);
      Number       work, none = Number(0.);
      const Number scale = flow(q2, none, dt, point, work);
      scale_deviator(scale, point.stress);
      return work;
    }

    /// A step of a one-point element.
    template <class Number>
    [[gnu::always_inline]] SolidWork<Number>
    update_one_point(const Matrix3<Number> &gradient, const one_point_solid::Axes<Number> &axes,
                     const one_point_solid::Stabilisation<Number> &strain, const double dt, SolidPoint<Number> &point,
                     one_point_solid::Stabilisation<Number> &s) const
    {
      point.rotate_and_strain(elasticity, gradient);
      const Number half = 0.5, before = compute_work(s, strain);
      add_stress(elasticity, axes, strain, s);
      const Number      rest = compute_flow_measure(axes, s), q2 = von_mises_squared(point.stress) + rest;
      SolidWork<Number> work{Number(0.), Number(0.)};
      if (any(q2 > point.yield * point.yield))
        {
          const Number scale = flow(q2, rest, dt, point, work.plastic);
          scale_deviator(scale, point.stress);
          work.hourglass = -0.75 * work.plastic * rest / max(Number(q2 - 0.25 * rest), Number(1e-300));
          scale_back(axes, elasticity.poisson, scale, s);
          work.hourglass = -0.75 * work.plastic * rest / max(Number(q2 - 0.25 * rest), Number(1e-300));
          for (int k = 0; k < 3; ++k)
            {
              s.last[k] *= scale;
              for (int c = 0; c < 3; ++c)
                s.linear[k][c] *= scale;
            }
        }
      work.hourglass += half * (before + compute_work(s, strain));
      return work;
    }

    /// Artificial pressure (Pa) against dilatation at a rate (1/s): rho l (b1 c |rate| + b2^2 l rate^2), the square in
    /// compression only (von Neumann & Richtmyer 1950; Landshoff 1955), with the height l of the element (m). `drag`
    /// (m^2/s) is the pressure over -rho rate.
    template <class Number>
    [[gnu::always_inline]] Number compute_viscous_pressure(const Number &rate, const Number &height, Number &drag) const
    {
      const Number compression = max(Number(-rate), Number(0.));
      drag =
        height * (linear_viscosity * wave_speed + (quadratic_viscosity * quadratic_viscosity) * height * compression);
      return -density * drag * rate;
    }

  private:
    /// Radial return of a stress measure q, q^2 given with the part of it that the stabilisation has; returns the
    /// factor of the deviator, and the work per volume s_y dp. The square of a linear stress is 1/3 in the mean, where
    /// the measure has 4/9: three quarters of that part are plastic work.
    template <class Number>
    [[gnu::noinline]] Number flow(const Number &q2, const Number &rest, const double dt, SolidPoint<Number> &point,
                                  Number &work) const
    {
      const Number softening = thermal_softening(hardening, adiabatic_temperature(hardening, point.plastic_work));
      const Number q         = sqrt(q2);
      const auto   step =
        compute_radial_increment(elasticity, hardening, point.plastic_strain, point.yield, softening, dt, q);
      work = step.stress * step.strain * (Number(1.) - 0.25 * rest / max(q2, Number(1e-300)));
      point.plastic_strain += step.strain;
      point.plastic_work += work;
      point.yield = compute_static_yield(point, dt);
      return Number(1.) - 3. * elasticity.shear_modulus() * step.strain / max(q, Number(1e-300));
    }

    /// The static flow stress that the next step starts from.
    template <class Number>
    Number compute_static_yield(const SolidPoint<Number> &point, const double dt) const
    {
      const Number softening = thermal_softening(hardening, adiabatic_temperature(hardening, point.plastic_work));
      if (hardening.law == HardeningLaw::perfect)
        return hardening.yield * softening;
      return compute_flow_stress(hardening, point.plastic_strain, Number(0.), dt, softening).value;
    }
  };
} // namespace birdstrike
