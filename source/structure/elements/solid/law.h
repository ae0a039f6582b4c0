#pragma once

#include "structure/elements/solid/flow.h"
#include "structure/elements/solid/point.h"
#include "structure/elements/solid/solid_section.h"
#include "structure/elements/solid/stabilisation.h"
#include <birdstrike/core/simd/flatten.h>

namespace birdstrike
{
  /// Stress of solid elements from strain increments: J2 with radial return, and the bulk viscosity.
  ///
  /// The stabilisation of the one-point brick flows with the mean (see SolidFlow), for its stresses are those at points
  /// within the element, relative to the mean: one brick carries the plastic moment, no more. While the mean flows at a
  /// rate e', this leaves a variation d' of the strain rate a stress of the order s_y d'/e', as the return of each
  /// point would: what is plastic gets soft without a tangent or a coefficient.
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
      return flow(q2, dt, point);
    }

    /// A step of a one-point element; returns the plastic work per volume (J/m^3).
    template <class Number>
    [[gnu::always_inline]] Number
    update_one_point(const Matrix3<Number> &gradient, const one_point_solid::Stabilisation<Number> &strain,
                     const double dt, SolidPoint<Number> &point, one_point_solid::Stabilisation<Number> &s) const
    {
      point.rotate_and_strain(elasticity, gradient);
      add_stress(elasticity, strain, s);
      const one_point_solid::FlowSquares<Number> squares(s);
      const Number mean = von_mises_squared(point.stress), q2 = mean + squares.trace + squares.shear + squares.last;
      if (!any(q2 > point.yield * point.yield))
        return Number(0.);
      return flow_together({mean, squares.trace, squares.shear, squares.last}, dt, point, s);
    }

    /// Artificial pressure (Pa) against dilatation at a rate (1/s): rho l (b1 c |rate| + b2^2 l rate^2), the square in
    /// compression only (von Neumann & Richtmyer 1950; Landshoff 1955), with the height l of the element (m). `drag`
    /// (m^2/s) is its tangent, -dp/d(rate)/rho, which a disturbance of the motion meets: of the square twice the
    /// secant.
    template <class Number>
    [[gnu::always_inline]] Number compute_viscous_pressure(const Number &rate, const Number &height, Number &drag) const
    {
      const Number compression = max(Number(-rate), Number(0.));
      const Number linear      = height * (linear_viscosity * wave_speed),
                   square      = (quadratic_viscosity * quadratic_viscosity) * height * height * compression;
      drag                     = linear + 2. * square;
      return -density * (linear + square) * rate;
    }

    /// 1 - T*^m after a plastic work (J/m^3).
    template <class Number>
    Number compute_softening(const Number &plastic_work) const
    {
      return thermal_softening(hardening, adiabatic_temperature(hardening, plastic_work));
    }

    /// Books plastic strain and work per volume of a step to a point, and the static flow stress that the next one
    /// starts from.
    template <class Number, class Point>
    void add_flow(const Number &strain, const Number &work, const double dt, Point &point) const
    {
      point.plastic_strain += strain;
      point.plastic_work += work;
      const Number softening = compute_softening(point.plastic_work);
      if (hardening.law == HardeningLaw::perfect)
        point.yield = hardening.yield * softening;
      else
        point.yield = compute_flow_stress(hardening, point.plastic_strain, Number(0.), dt, softening).value;
    }

  private:
    /// Radial return of a point, its q^2 given; returns the plastic work per volume.
    template <class Number>
    BIRDSTRIKE_FLATTEN [[gnu::noinline]] Number flow(const Number &q2, const double dt, SolidPoint<Number> &point) const
    {
      const auto   step = radial_return(elasticity, hardening, point.plastic_strain, point.yield,
                                        compute_softening(point.plastic_work), dt, q2, point.stress);
      const Number work = step.stress * step.strain;
      add_flow(step.strain, work, dt, point);
      return work;
    }

    /// Of a one-point element; returns the plastic work per volume.
    template <class Number>
    [[gnu::noinline]] Number flow_together(const Number (&squares)[4], const double dt, SolidPoint<Number> &point,
                                           one_point_solid::Stabilisation<Number> &s) const
    {
      const SolidFlow<Number> step(elasticity, hardening, point.plastic_strain, point.yield,
                                   compute_softening(point.plastic_work), dt, squares);
      const Number            work = step.stress * step.strain;
      add_flow(step.strain, work, dt, point);
      scale_deviator(step.mean_factor, point.stress);
      scale_back(step.trace_factor, step.shear_factor, step.last_factor, s);
      return work;
    }
  };
} // namespace birdstrike
