#pragma once

#include "structure/elements/section_law.h"

namespace birdstrike
{
  /// Section and stabilisation of a one-point element.
  ///
  /// Stabilisation stresses grow with the elastic modulus times the mean tangent ratio of the points (at least
  /// `smallest_tangent`, so that a fully plastic element keeps its shape), fall with the elastic modulus, and are
  /// capped by the yield stress (3/2 of it for bending, the plastic moment).
  struct ShellSectionLaw : SectionLaw
  {
    explicit ShellSectionLaw(const ShellSection &section)
      : SectionLaw(section), is_capped(section.formulation == ShellFormulation::one_point_physical)
    {
    }

    static constexpr double smallest_tangent = 0.05;

    bool is_capped;

    using SectionLaw::update_elastic;
    using SectionLaw::update_plastic;

    /// Section and stabilisation in an elastic step.
    template <class Number>
    [[gnu::always_inline]] bool update_elastic(const ShellVector<Number> &e, const double yield, ShellStress<Number> &s,
                                               ShellWork<Number> &work) const
    {
      Number old_trace;
      if (!add_if_elastic(e, yield, s, old_trace))
        return false;
      work           = {Number(0.), Number(0.)};
      const auto add = [this](Number &stress, const Number &strain) { stress += elasticity.young * strain; };
      update_stabilisation(e, s, work.hourglass, add, add);
      update_shear_and_thickness(e, old_trace, s);
      return true;
    }

    /// The same in a step of a section with points; `failing` as in update_points.
    template <class Number, class Failing = NeverFails>
    ShellWork<Number> update_plastic(const ShellVector<Number> &e, const double dt, ShellStress<Number> &s,
                                     ShellPoint<Number> *points, Failing &&failing = {}) const
    {
      ShellWork<Number>     work{Number(0.), Number(0.)};
      const Number          old_trace = s.mean[0] + s.mean[1], floor = Number(smallest_tangent);
      const Tangent<Number> tangent = update_points(e, dt, s, points, work.plastic, failing);
      const Number          one = 1., limit = is_capped ? tangent.yield : Number(std::numeric_limits<double>::max());
      const Number          membrane = is_capped ? max(floor, tangent.membrane) : one;
      const Number          bending  = is_capped ? max(floor, tangent.bending) : one;
      const auto            flow     = [this](const Number &ratio, const Number &most) {
        return [this, ratio, most](Number &stress, const Number &strain) {
          const Number elastic = elasticity.young * strain, whole = stress + elastic;
          // back elastically, as far as zero: at the modulus of flow a stress gives back more than it has taken, and
          // beyond zero at the full modulus the sign of a stress of round-off decides
          const Number fallen = select(stress * whole < Number(0.), Number(ratio * whole), whole);
          const Number now = select(stress * elastic < Number(0.), fallen, Number(stress + ratio * elastic));
          stress           = min(max(now, Number(-most)), most);
        };
      };
      update_stabilisation(e, s, work.hourglass, flow(membrane, limit), flow(bending, Number(1.5 * limit)));
      update_shear_and_thickness(e, old_trace, s);
      return work;
    }

  private:
    /// `add_membrane` and `add_bending` add what a strain increment makes of a stress.
    template <class Number, class AddMembrane, class AddBending>
    [[gnu::always_inline]] void update_stabilisation(const ShellVector<Number> &e, ShellStress<Number> &s, Number &work,
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
               [&](Number &stress) { add_membrane(stress, e.linear_membrane[c]); });
          book(bent, s.linear_curvature[c], e.linear_curvature[c],
               [&](Number &stress) { add_bending(stress, Number(half_t * e.linear_curvature[c])); });
          book(in_plane, s.linear_shear[c], e.linear_shear[c],
               [&](Number &stress) { stress += shear_modulus * e.linear_shear[c]; });
        }
      work += (1. / 6.) * s.thickness * (in_plane + (1. / 6.) * s.thickness * bent);
    }
  };
} // namespace birdstrike
