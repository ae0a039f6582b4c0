#pragma once

#include "structure/elements/point_failure.h"
#include "structure/elements/shell/stress.h"
#include "structure/elements/thickness_points.h"
#include <birdstrike/material/plane_stress_return.h>

#include <limits>
#include <type_traits>

namespace birdstrike
{
  /// Plasticity at points through the thickness of a shell, and the mean and linear stress that they carry.
  struct ThroughThickness
  {
    Elasticity      elasticity;
    Hardening       hardening;
    ThicknessPoints rule;

    /// Of a yielding section: means over the thickness of the tangent ratio and its square moment, and of the yield
    /// stress (Pa; without limit while no point has flowed).
    template <class Number>
    struct Tangent
    {
      Number membrane, bending, yield;
    };

    double initial_yield() const
    {
      return compute_flow_stress(hardening, 0., 0., 1., thermal_softening(hardening, hardening.initial_temperature))
        .value;
    }

    /// Points of a stress state as it stands.
    template <class Number>
    void promote(const SectionStress<Number> &s, ShellPoint<Number> *points) const
    {
      for (unsigned int k = 0; k < rule.n; ++k)
        {
          for (int c = 0; c < 3; ++c)
            points[k].stress[c] = s.mean[c] + rule.position[k] * s.outer[c];
          points[k].plastic_strain = points[k].plastic_work = Number(0.);
          points[k].yield                                   = Number(initial_yield());
        }
    }

    /// One step of the points; `s` gets their stress. `failing`: FailingPoints, or NeverFails.
    template <class Number, class Failing = NeverFails>
    Tangent<Number> update_points(const SectionVector<Number> &e, const double dt, SectionStress<Number> &s,
                                  ShellPoint<Number> *points, Number &plastic_work, Failing &&failing = {}) const
    {
      Tangent<Number> tangent{Number(0.), Number(0.), Number(0.)};
      Number          plastic_strain = Number(0.); // sum over the points
      for (int c = 0; c < 3; ++c)
        s.mean[c] = s.outer[c] = Number(0.);
      for (unsigned int k = 0; k < rule.n; ++k)
        {
          ShellPoint<Number> &point = points[k];
          const double        z = rule.position[k], w = 0.5 * rule.weight[k];
          const Number        arm       = 0.5 * z * s.thickness;
          const Number        strain[3] = {e.membrane[0] + arm * e.curvature[0], e.membrane[1] + arm * e.curvature[1],
                                           e.membrane[2] + arm * e.curvature[2]};
          add_plane_stress(elasticity, strain, point.stress);
          const Number softening = thermal_softening(hardening, adiabatic_temperature(hardening, point.plastic_work));
          auto         step =
            plane_stress_return(elasticity, hardening, point.plastic_strain, point.yield, softening, dt, point.stress);
          if constexpr (std::decay_t<Failing>::can_fail)
            failing.update(k, point, step);
          const auto   yields = step.strain > Number(0.);
          const Number work   = step.stress * step.strain;
          point.plastic_strain += step.strain;
          point.plastic_work += work;
          plastic_work += w * s.thickness * work;
          update_yield(point, dt);
          Number ratio = select(yields, step.slope / (elasticity.young + step.slope), Number(1.)), flow = point.yield;
          if constexpr (std::decay_t<Failing>::can_fail)
            {
              ratio *= failing.carries;
              flow *= failing.carries;
            }
          tangent.membrane += w * ratio;
          tangent.bending += 3. * w * z * z * ratio;
          tangent.yield += w * flow;
          plastic_strain += point.plastic_strain;
          add_stress(k, point, s);
        }
      // lanes that hold points for their neighbours' sake alone do what they would without
      tangent.yield = select(plastic_strain > Number(0.), tangent.yield, std::numeric_limits<double>::max());
      return tangent;
    }

    /// The share of point k in mean and linear stress.
    template <class Number>
    [[gnu::always_inline]] void add_stress(const unsigned int k, const ShellPoint<Number> &point,
                                           SectionStress<Number> &s) const
    {
      const double z = rule.position[k], w = 0.5 * rule.weight[k];
      for (int c = 0; c < 3; ++c)
        {
          s.mean[c] += w * point.stress[c];
          s.outer[c] += 3. * w * z * point.stress[c];
        }
    }

  private:
    /// The static flow stress that the next step starts from.
    template <class Number>
    void update_yield(ShellPoint<Number> &point, const double dt) const
    {
      const Number softening = thermal_softening(hardening, adiabatic_temperature(hardening, point.plastic_work));
      if (hardening.law == HardeningLaw::perfect)
        point.yield = hardening.yield * softening;
      else
        point.yield = compute_flow_stress(hardening, point.plastic_strain, Number(0.), dt, softening).value;
    }
  };
} // namespace birdstrike
