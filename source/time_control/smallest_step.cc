#include <birdstrike/core/errors.h>
#include <birdstrike/time_control/smallest_step.h>

#include <cstdio>
#include <utility>

namespace birdstrike
{
  namespace
  {
    std::string text(const double value)
    {
      char buffer[32];
      std::snprintf(buffer, sizeof buffer, "%.3g", value);
      return buffer;
    }
  } // namespace

  SmallestStep::SmallestStep(std::string part, const double share) : part(std::move(part)), share(share)
  {
  }

  void SmallestStep::check(const StepLimit &limit, const double time, const double remaining, const char *advice)
  {
    if (first == 0.)
      first = smallest = limit.value;
    if (limit.value < smallest)
      smallest = limit.value;
    const bool is_collapsing = limit.value<share * first, is_endless = remaining> most_steps * limit.value;
    if (!is_collapsing && !is_endless)
      return;
    const std::string what = "The stable step of the " + part + " is " + text(limit.value) + " s at t = " + text(time) +
                             " s, " + text(limit.value / first) + " of its first value";
    throw NumericalFailure(what +
                           (is_collapsing
                              ? ": less than Time/Smallest step = " + text(share) + "."
                              : "; " + text(remaining / limit.value) + " steps are left to Time/End time.") +
                           "\nLimited by: " + limit.text() + ".\n" + advice);
  }

  double SmallestStep::smallest_share() const
  {
    return first > 0. ? smallest / first : 1.;
  }
} // namespace birdstrike
