#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/time_control/smallest_step.h>

#include <fmt/format.h>

#include <utility>

namespace birdstrike
{
  SmallestStep::SmallestStep(std::string part, const double share) : part(std::move(part)), share(share)
  {
  }

  void SmallestStep::check(const StepLimit &limit, const double remaining, const char *advice)
  {
    if (first == 0.)
      first = smallest = limit.value;
    if (limit.value < smallest)
      smallest = limit.value;
    const bool is_collapsing = limit.value<share * first, is_endless = remaining> most_steps * limit.value;
    if (!is_collapsing && !is_endless)
      return;
    FailureFacts facts =
      is_collapsing ? FailureFacts{"The stable step of the " + part + " has collapsed",
                                   "stable step over its first value",
                                   limit.value / first,
                                   "-",
                                   share,
                                   "Time/Smallest step"}
                    : FailureFacts{"The stable step of the " + part + " leaves more steps than anybody waits for",
                                   "steps to Time/End time",
                                   remaining / limit.value,
                                   "-",
                                   most_steps,
                                   "at most"};
    facts.where   = limit.where;
    facts.details = fmt::format("The step is {:.3g} s, limited by: {}.", limit.value, limit.reason);
    facts.advice  = advice;
    throw NumericalFailure(std::move(facts));
  }

  double SmallestStep::smallest_share() const
  {
    return first > 0. ? smallest / first : 1.;
  }
} // namespace birdstrike
