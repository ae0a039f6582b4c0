#pragma once

#include "structure/elements/shell/stress.h"
#include <birdstrike/material/failure.h>
#include <birdstrike/material/plane_stress_return.h>

namespace birdstrike
{
  /// Points of a metal that cannot fail: nothing is stored and nothing is done.
  struct NeverFails
  {
    static constexpr bool can_fail = false;
  };

  /// Damage of the points of a section, while they take one step. A point with D >= 1 carries no stress and takes part
  /// in nothing; one that fails in this step still does, until `release_failed` takes its stress.
  template <class Number>
  struct FailingPoints
  {
    static constexpr bool can_fail = true;

    const Failure   &failure;
    const Hardening &hardening;
    double           dt;                     ///< s
    Number          *damage;                 ///< [points], D
    Number           ductility = Number(1.); ///< factor on the failure strain, by the element's size

    bool   has_new = false;      ///< a point has failed in this step
    Number carries = Number(1.); ///< of the point updated last: 0 where it had failed before the step

    /// After the return of point k, before its plastic strain grows.
    void update(const unsigned int k, ShellPoint<Number> &point, PlasticIncrement<Number> &step)
    {
      const auto failed = damage[k] >= Number(1.);
      carries           = select(failed, Number(0.), Number(1.));
      step.strain       = select(failed, Number(0.), step.strain);
      for (Number &s : point.stress)
        s = select(failed, Number(0.), s);
      if (!any(step.strain > Number(0.)))
        return;
      damage[k] +=
        compute_damage_increment(failure, hardening,
                                 PlasticStep<Number>{step.strain, Number((point.stress[0] + point.stress[1]) / 3.),
                                                     von_mises_plane(point.stress),
                                                     adiabatic_temperature(hardening, point.plastic_work), dt}) /
        ductility;
      has_new = has_new || any(!failed && damage[k] >= Number(1.));
    }
  };
} // namespace birdstrike
