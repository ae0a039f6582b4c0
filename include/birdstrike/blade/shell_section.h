#pragma once

#include <birdstrike/blade/shell_stress.h>
#include <birdstrike/blade/thickness_points.h>
#include <birdstrike/material/plane_stress_return.h>

namespace birdstrike
{
  /// Through-thickness integration: stress and resultants of a shell section from strain increments.
  ///
  /// While nothing has yielded, mean and linear stress are exact in closed form and no points are stored; `has_yielded`
  /// tells when |s| at an outer fibre exceeds the yield stress, `promote` then makes points of the stress as it stands:
  /// no approximation, since the points lie inside. A yielding section is integrated by the thickness rule.
  /// Stabilisation stresses grow with the elastic modulus times the mean tangent ratio of the points (at least
  /// `smallest_tangent`, so that a fully plastic element keeps its shape), and are capped by the yield stress
  /// (3/2 of it for bending, the plastic moment). Transverse shear stays elastic.
  struct ShellSectionLaw
  {
    explicit ShellSectionLaw(const ShellSection &section)
      : elasticity(section.material.elasticity)
      , hardening(section.material.hardening)
      , shear_modulus(section.shear_factor * elasticity.shear_modulus())
      , rule(make_thickness_points(section.rule, section.n_points))
      , has_thinning(section.has_thinning)
      , is_capped(section.formulation == ShellFormulation::one_point_physical)
    {
    }

    static constexpr double smallest_tangent = 0.05;

    Elasticity      elasticity;
    Hardening       hardening;
    double          shear_modulus; ///< kappa G
    ThicknessPoints rule;
    bool            has_thinning;
    bool            is_capped;

    double initial_yield() const
    {
      return compute_flow_stress(hardening, 0., 0., 1., thermal_softening(hardening, hardening.initial_temperature))
        .value;
    }

    /// True in the lanes where the elastic trial state of the step exceeds the initial yield stress at a face.
    template <class Number>
    auto has_yielded(const ShellStress<Number> &s, const ShellVector<Number> &e, const double yield) const
    {
      Number mean[3] = {s.mean[0], s.mean[1], s.mean[2]}, outer[3] = {s.outer[0], s.outer[1], s.outer[2]};
      add_elastic(e, s.thickness, mean, outer);
      const Number top[3]    = {mean[0] + outer[0], mean[1] + outer[1], mean[2] + outer[2]};
      const Number bottom[3] = {mean[0] - outer[0], mean[1] - outer[1], mean[2] - outer[2]};
      return max(von_mises_plane_squared(top), von_mises_plane_squared(bottom)) > Number(yield * yield);
    }

    template <class Number>
    void promote(const ShellStress<Number> &s, ShellPoint<Number> *points) const
    {
      for (unsigned int k = 0; k < rule.n; ++k)
        {
          for (int c = 0; c < 3; ++c)
            points[k].stress[c] = s.mean[c] + rule.position[k] * s.outer[c];
          points[k].plastic_strain = points[k].plastic_work = Number(0.);
          points[k].yield                                   = Number(initial_yield());
        }
    }

    /// One step; `points` is null while the section is elastic.
    template <class Number>
    ShellWork<Number> update(const ShellVector<Number> &e, const double dt, ShellStress<Number> &s,
                             ShellPoint<Number> *points) const
    {
      ShellWork<Number> work{Number(0.), Number(0.)};
      const Number      old_trace = s.mean[0] + s.mean[1], thickness = s.thickness;
      Tangent<Number>   tangent{Number(1.), Number(1.), Number(std::numeric_limits<double>::max())};
      if (points == nullptr)
        add_elastic(e, thickness, s.mean, s.outer);
      else
        tangent = update_points(e, dt, s, points, work.plastic);
      update_stabilisation(e, tangent, s, work.hourglass);
      for (int c = 0; c < 2; ++c)
        s.shear[c] += shear_modulus * e.shear[c];
      if (has_thinning)
        {
          // e_zz of the mean: elastic -nu/E tr(ds) plus plastic -(tr(de) - (1-nu)/E tr(ds))
          const double compliance = (1. - 2. * elasticity.poisson) / elasticity.young;
          s.thickness *=
            Number(1.) - (e.membrane[0] + e.membrane[1]) + compliance * (s.mean[0] + s.mean[1] - old_trace);
        }
      return work;
    }

  private:
    template <class Number>
    struct Tangent
    {
      Number membrane, bending, yield;
    };

    template <class Number>
    void add_elastic(const ShellVector<Number> &e, const Number &thickness, Number (&mean)[3], Number (&outer)[3]) const
    {
      const Number half    = 0.5 * thickness;
      const Number bend[3] = {half * e.curvature[0], half * e.curvature[1], half * e.curvature[2]};
      add_plane_stress(elasticity, e.membrane, mean);
      add_plane_stress(elasticity, bend, outer);
    }

    template <class Number>
    Tangent<Number> update_points(const ShellVector<Number> &e, const double dt, ShellStress<Number> &s,
                                  ShellPoint<Number> *points, Number &plastic_work) const
    {
      Tangent<Number> tangent{Number(0.), Number(0.), Number(0.)};
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
          const auto   step =
            plane_stress_return(elasticity, hardening, point.plastic_strain, point.yield, softening, dt, point.stress);
          const auto   yields = step.strain > Number(0.);
          const Number work   = step.stress * step.strain;
          point.plastic_strain += step.strain;
          point.plastic_work += work;
          plastic_work += w * s.thickness * work;
          update_yield(point, dt);
          const Number ratio = select(yields, step.slope / (elasticity.young + step.slope), Number(1.));
          tangent.membrane += w * ratio;
          tangent.bending += 3. * w * z * z * ratio;
          tangent.yield += w * point.yield;
          for (int c = 0; c < 3; ++c)
            {
              s.mean[c] += w * point.stress[c];
              s.outer[c] += 3. * w * z * point.stress[c];
            }
        }
      return tangent;
    }

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

    template <class Number>
    void update_stabilisation(const ShellVector<Number> &e, const Tangent<Number> &tangent, ShellStress<Number> &s,
                              Number &work) const
    {
      const Number one = Number(1.), floor = Number(smallest_tangent);
      const Number membrane = elasticity.young * (is_capped ? max(floor, tangent.membrane) : one);
      const Number bending  = elasticity.young * (is_capped ? max(floor, tangent.bending) : one);
      const Number cap      = is_capped ? tangent.yield : Number(std::numeric_limits<double>::max());
      const Number third_t = s.thickness / Number(3.), third_t2 = s.thickness * s.thickness / Number(18.);
      const auto   add = [&work](Number &stress, const Number &increment, const Number &strain, const Number &limit,
                               const Number &weight) {
        const Number old = stress;
        stress           = min(max(Number(old + increment), Number(-limit)), limit);
        work += 0.5 * weight * (old + stress) * strain;
      };
      for (int c = 0; c < 2; ++c)
        {
          add(s.linear_membrane[c], Number(membrane * e.linear_membrane[c]), e.linear_membrane[c], cap, third_t);
          add(s.linear_curvature[c], Number(0.5 * s.thickness * bending * e.linear_curvature[c]), e.linear_curvature[c],
              Number(1.5 * cap), third_t2);
          add(s.linear_shear[c], Number(shear_modulus * e.linear_shear[c]), e.linear_shear[c],
              Number(std::numeric_limits<double>::max()), third_t);
        }
    }
  };
} // namespace birdstrike
