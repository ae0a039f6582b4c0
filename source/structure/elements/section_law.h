#pragma once

#include "structure/elements/shell/shell_section.h"
#include "structure/elements/through_thickness.h"

namespace birdstrike
{
  /// exp(-4 e), e^5/720 off.
  template <class Number>
  [[gnu::always_inline]] inline Number fourth_power_of_exp_minus(const Number &e)
  {
    const Number half = 0.5 * e;
    const Number rest = 1. + (1. / 12.) * e * e, root = (rest - half) / (rest + half);
    const Number squared = root * root;
    return squared * squared;
  }

  /// Stress of a shell section from strain increments: one integration point in the plane of a shell.
  ///
  /// While nothing has yielded, mean and linear stress are exact in closed form and no points are stored;
  /// `update_elastic` tells when |s| at an outer fibre exceeds the yield stress, `promote` then makes points of the
  /// stress as it stands: no approximation, since the points lie inside. A yielding section is integrated by the
  /// thickness rule. Transverse shear stays elastic; the thickness follows the plane-stress strain.
  struct SectionLaw : ThroughThickness
  {
    explicit SectionLaw(const ShellSection &section)
      : ThroughThickness{section.material.elasticity, section.material.hardening,
                         make_thickness_points(section.rule, section.n_points)}
      , shear_modulus(section.shear_factor * elasticity.shear_modulus())
      , has_thinning(section.has_thinning)
      , volume_compliance((1. - (has_thinning ? 2. : 1.) * elasticity.poisson) / elasticity.young)
    {
    }

    double shear_modulus; ///< kappa G
    bool   has_thinning;
    double volume_compliance; ///< 1/Pa: elastic volume strain per sxx + syy, whose (1 - nu)/E is exx + eyy

    /// Volume before the elastic strain of the mean stress over that with it, exp(-e). Stresses are Kirchhoff's: their
    /// resultants and works are those of the undeformed volume, so that the work s : de V_0 is a change of V_0
    /// s : C^{-1} : s / 2 on every path (an objective rate turns s and adds nothing), not to the order of e alone.
    template <class Number>
    [[gnu::always_inline]] Number contraction(const SectionStress<Number> &s) const
    {
      return fourth_power_of_exp_minus(Number((0.25 * volume_compliance) * (s.mean[0] + s.mean[1])));
    }

    /// The elastic trial state of a step, without points: false (and `s` as it was) when the stress at a face exceeds
    /// the initial yield stress in any lane.
    template <class Number>
    [[gnu::always_inline]] bool update_elastic(const SectionVector<Number> &e, const double yield,
                                               SectionStress<Number> &s) const
    {
      Number old_trace;
      if (!add_if_elastic(e, yield, s, old_trace))
        return false;
      update_shear_and_thickness(e, old_trace, s);
      return true;
    }

    /// One step of a section with points; returns the plastic work per area (J/m^2). `failing` as in update_points.
    template <class Number, class Failing = NeverFails>
    Number update_plastic(const SectionVector<Number> &e, const double dt, SectionStress<Number> &s,
                          ShellPoint<Number> *points, Failing &&failing = {}) const
    {
      const Number old_trace = s.mean[0] + s.mean[1];
      Number       work      = Number(0.);
      update_points(e, dt, s, points, work, failing);
      update_shear_and_thickness(e, old_trace, s);
      return work;
    }

  protected:
    /// `old_trace` gets the sum of the mean normal stresses before the step.
    template <class Number>
    [[gnu::always_inline]] bool add_if_elastic(const SectionVector<Number> &e, const double yield,
                                               SectionStress<Number> &s, Number &old_trace) const
    {
      const Number half    = 0.5 * s.thickness;
      const Number bend[3] = {half * e.curvature[0], half * e.curvature[1], half * e.curvature[2]};
      Number       mean[3] = {s.mean[0], s.mean[1], s.mean[2]}, outer[3] = {s.outer[0], s.outer[1], s.outer[2]};
      add_plane_stress(elasticity, e.membrane, mean);
      add_plane_stress(elasticity, bend, outer);
      const Number top[3]    = {mean[0] + outer[0], mean[1] + outer[1], mean[2] + outer[2]};
      const Number bottom[3] = {mean[0] - outer[0], mean[1] - outer[1], mean[2] - outer[2]};
      if (any(max(von_mises_plane_squared(top), von_mises_plane_squared(bottom)) > Number(yield * yield)))
        return false;
      old_trace = s.mean[0] + s.mean[1];
      for (int c = 0; c < 3; ++c)
        {
          s.mean[c]  = mean[c];
          s.outer[c] = outer[c];
        }
      return true;
    }

    template <class Number>
    [[gnu::always_inline]] void update_shear_and_thickness(const SectionVector<Number> &e, const Number &old_trace,
                                                           SectionStress<Number> &s) const
    {
      for (int c = 0; c < 2; ++c)
        s.shear[c] += shear_modulus * e.shear[c];
      if (has_thinning)
        {
          // e_zz of the mean: elastic -nu/E tr(ds) plus plastic -(tr(de) - (1-nu)/E tr(ds))
          const double compliance = (1. - 2. * elasticity.poisson) / elasticity.young;
          const Number strain     = compliance * (s.mean[0] + s.mean[1] - old_trace) - (e.membrane[0] + e.membrane[1]);
          s.thickness *= Number(1.) + strain + 0.5 * strain * strain; // exp(strain), as the area grows
        }
    }
  };
} // namespace birdstrike
