#pragma once

#include <birdstrike/blade/through_thickness.h>

namespace birdstrike
{
  /// Through-thickness integration: stress and resultants of a shell section from strain increments.
  ///
  /// While nothing has yielded, mean and linear stress are exact in closed form and no points are stored;
  /// `update_elastic` tells when |s| at an outer fibre exceeds the yield stress, `promote` then makes points of the
  /// stress as it stands: no approximation, since the points lie inside. A yielding section is integrated by the
  /// thickness rule. Stabilisation stresses grow with the elastic modulus times the mean tangent ratio of the points
  /// (at least `smallest_tangent`, so that a fully plastic element keeps its shape), and are capped by the yield stress
  /// (3/2 of it for bending, the plastic moment). Transverse shear stays elastic.
  struct ShellSectionLaw : ThroughThickness
  {
    explicit ShellSectionLaw(const ShellSection &section)
      : ThroughThickness{section.material.elasticity, section.material.hardening,
                         make_thickness_points(section.rule, section.n_points)}
      , shear_modulus(section.shear_factor * elasticity.shear_modulus())
      , has_thinning(section.has_thinning)
      , is_capped(section.formulation == ShellFormulation::one_point_physical)
    {
    }

    static constexpr double smallest_tangent = 0.05;

    double shear_modulus; ///< kappa G
    bool   has_thinning;
    bool   is_capped;

    /// The elastic trial state of a step, without points: false (and `s` as it was) when the stress at a face exceeds
    /// the initial yield stress in any lane.
    template <class Number>
    [[gnu::always_inline]] bool update_elastic(const ShellVector<Number> &e, const double yield, ShellStress<Number> &s,
                                               ShellWork<Number> &work) const
    {
      const Number thickness = s.thickness;
      Number       mean[3] = {s.mean[0], s.mean[1], s.mean[2]}, outer[3] = {s.outer[0], s.outer[1], s.outer[2]};
      add_elastic(e, thickness, mean, outer);
      const Number top[3]    = {mean[0] + outer[0], mean[1] + outer[1], mean[2] + outer[2]};
      const Number bottom[3] = {mean[0] - outer[0], mean[1] - outer[1], mean[2] - outer[2]};
      if (any(max(von_mises_plane_squared(top), von_mises_plane_squared(bottom)) > Number(yield * yield)))
        return false;
      const Number old_trace = s.mean[0] + s.mean[1];
      for (int c = 0; c < 3; ++c)
        {
          s.mean[c]  = mean[c];
          s.outer[c] = outer[c];
        }
      work           = {Number(0.), Number(0.)};
      const auto add = [](Number &stress, const Number &increment) { stress += increment; };
      update_stabilisation(e, Number(elasticity.young), Number(elasticity.young), s, work.hourglass, add, add);
      update_shear_and_thickness(e, old_trace, s);
      return true;
    }

    /// One step of a section with points.
    template <class Number>
    ShellWork<Number> update_plastic(const ShellVector<Number> &e, const double dt, ShellStress<Number> &s,
                                     ShellPoint<Number> *points) const
    {
      ShellWork<Number>     work{Number(0.), Number(0.)};
      const Number          old_trace = s.mean[0] + s.mean[1], floor = Number(smallest_tangent);
      const Tangent<Number> tangent = update_points(e, dt, s, points, work.plastic);
      const Number          one = 1., limit = is_capped ? tangent.yield : Number(std::numeric_limits<double>::max());
      const Number          membrane = elasticity.young * (is_capped ? max(floor, tangent.membrane) : one);
      const Number          bending  = elasticity.young * (is_capped ? max(floor, tangent.bending) : one);
      const auto            cap      = [](const Number &most) {
        return [most](Number &stress, const Number &increment) {
          stress = min(max(Number(stress + increment), Number(-most)), most);
        };
      };
      update_stabilisation(e, membrane, bending, s, work.hourglass, cap(limit), cap(1.5 * limit));
      update_shear_and_thickness(e, old_trace, s);
      return work;
    }

  private:
    template <class Number>
    void add_elastic(const ShellVector<Number> &e, const Number &thickness, Number (&mean)[3], Number (&outer)[3]) const
    {
      const Number half    = 0.5 * thickness;
      const Number bend[3] = {half * e.curvature[0], half * e.curvature[1], half * e.curvature[2]};
      add_plane_stress(elasticity, e.membrane, mean);
      add_plane_stress(elasticity, bend, outer);
    }

    /// `add_membrane` and `add_bending` add an increment to a stress and may limit it.
    template <class Number, class AddMembrane, class AddBending>
    [[gnu::always_inline]] void update_stabilisation(const ShellVector<Number> &e, const Number &membrane,
                                                     const Number &bending, ShellStress<Number> &s, Number &work,
                                                     const AddMembrane &add_membrane,
                                                     const AddBending  &add_bending) const
    {
      const Number half_t   = 0.5 * s.thickness;
      Number       in_plane = Number(0.), bent = Number(0.); // sums of (old + new stress) * strain
      const auto   book = [](Number &sum, Number &stress, const Number &strain, const auto &add) {
        const Number old = stress;
        add(stress);
        sum += (old + stress) * strain;
      };
      for (int c = 0; c < 2; ++c)
        {
          book(in_plane, s.linear_membrane[c], e.linear_membrane[c],
               [&](Number &stress) { add_membrane(stress, Number(membrane * e.linear_membrane[c])); });
          book(bent, s.linear_curvature[c], e.linear_curvature[c],
               [&](Number &stress) { add_bending(stress, Number(half_t * bending * e.linear_curvature[c])); });
          book(in_plane, s.linear_shear[c], e.linear_shear[c],
               [&](Number &stress) { stress += shear_modulus * e.linear_shear[c]; });
        }
      work += (1. / 6.) * s.thickness * (in_plane + (1. / 6.) * s.thickness * bent);
    }

    template <class Number>
    [[gnu::always_inline]] void update_shear_and_thickness(const ShellVector<Number> &e, const Number &old_trace,
                                                           ShellStress<Number> &s) const
    {
      for (int c = 0; c < 2; ++c)
        s.shear[c] += shear_modulus * e.shear[c];
      if (has_thinning)
        {
          // e_zz of the mean: elastic -nu/E tr(ds) plus plastic -(tr(de) - (1-nu)/E tr(ds))
          const double compliance = (1. - 2. * elasticity.poisson) / elasticity.young;
          s.thickness *=
            Number(1.) - (e.membrane[0] + e.membrane[1]) + compliance * (s.mean[0] + s.mean[1] - old_trace);
        }
    }
  };
} // namespace birdstrike
