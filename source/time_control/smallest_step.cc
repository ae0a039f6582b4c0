#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/time_control/smallest_step.h>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace birdstrike
{
  namespace
  {
    FailureFacts no_number(const StepLimit &limit, const std::string &part)
    {
      FailureFacts facts{"The stable step of the " + part + " is no number", "stable step", limit.value, "s"};
      facts.where   = limit.where;
      facts.details = std::string("Limited by: ") + limit.reason + ".";
      facts.advice  = "Reduce Time/Step scale and Time/Bird step scale, and check the last fields there.";
      return facts;
    }
  } // namespace

  SmallestStep::SmallestStep(std::string part, const double share) : part(std::move(part)), share(share)
  {
  }

  void SmallestStep::check(const StepLimit &limit, const double remaining, const char *advice)
  {
    if (first == 0.)
      first = smallest = limit.value;
    if (std::isnan(limit.value))
      throw NumericalFailure(no_number(limit, part));
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
                    : FailureFacts{"The stable step of the " + part + " is too small to reach the end of the run",
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
