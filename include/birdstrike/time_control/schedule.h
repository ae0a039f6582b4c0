#pragma once

#include <birdstrike/core/step_limit.h>

#include <optional>

namespace birdstrike
{
  /// One macro step: both parts meet at its ends; one of the two counts is 1.
  struct Schedule
  {
    double       step    = 0.; ///< s
    unsigned int n_bird  = 1;  ///< bird (and contact) sub-steps of step / n_bird
    unsigned int n_blade = 1;  ///< blade sub-steps of step / n_blade; more where elements stiffen on the way (Stepper)
    StepLimit    limiter;      ///< the vote that set the step

    double bird_step() const
    {
      return step / n_bird;
    }
    double blade_step() const
    {
      return step / n_blade;
    }
  };

  /// The cheapest stable schedule. Candidates are the integer ratios 1 ... max_ratio in either direction; a candidate's
  /// macro step is the largest that keeps every sub-step at or below its part's limit, and its price is work per unit
  /// of time. Prices are counts times constants, never clock readings, so that the same run takes the same steps
  /// anywhere. Absent parts have no vote.
  ///
  /// Multirate by impulses (r-RESPA; Tuckerman, Berne and Martyna 1992): the slower part's own forces act at
  /// the ends of macro steps only, contact in every sub-step of the faster one.
  ///
  /// @param remaining  time to the end of the run (s): the last step ends there.
  /// @throws NumericalFailure if a limit is not positive and finite while its part exists.
  Schedule plan_step(const std::optional<StepVote> &bird, const std::optional<StepVote> &blade, unsigned int max_ratio,
                     double remaining);
} // namespace birdstrike
