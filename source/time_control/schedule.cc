#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/core/simd/larger.h>
#include <birdstrike/time_control/schedule.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    void check(const std::optional<StepVote> &vote, const char *part)
    {
      if (vote && !(vote->limit.value > 0.))
        {
          FailureFacts facts{std::string("The ") + part + " has no stable step",
                             "stable step",
                             vote->limit.value,
                             "s",
                             0.,
                             "allowed: more than"};
          facts.where   = vote->limit.where;
          facts.details = std::string("Limited by: ") + vote->limit.reason + ".";
          throw NumericalFailure(std::move(facts));
        }
    }

    Schedule cheapest(const StepVote &bird, const StepVote &blade, const unsigned int max_ratio)
    {
      Schedule   best;
      double     best_price = std::numeric_limits<double>::infinity();
      const auto consider   = [&](const unsigned int n_bird, const unsigned int n_blade) {
        const double by_bird = n_bird * bird.limit.value, by_blade = n_blade * blade.limit.value;
        const double step  = std::min(by_bird, by_blade);
        const double price = (n_bird * bird.price + n_blade * blade.price) / step;
        if (price < best_price)
          {
            best_price = price;
            best       = {step, n_bird, n_blade, by_bird < by_blade ? bird.limit : blade.limit};
          }
      };
      consider(1, 1);
      for (unsigned int ratio = 2; ratio <= max_ratio; ++ratio)
        {
          consider(1, ratio);
          consider(ratio, 1);
        }
      return best;
    }
  } // namespace

  Schedule plan_step(const std::optional<StepVote> &bird, const std::optional<StepVote> &blade,
                     const unsigned int max_ratio, const double remaining)
  {
    check(bird, "bird");
    check(blade, "blade");
    Schedule schedule;
    if (bird && blade && std::isfinite(bird->limit.value) && std::isfinite(blade->limit.value))
      schedule = cheapest(*bird, *blade, max_ratio);
    else
      {
        StepLimit limit;
        for (const auto *vote : {&bird, &blade})
          if (*vote && goes_before((*vote)->limit.value, limit.value))
            limit = (*vote)->limit;
        schedule = {limit.value, 1, 1, limit};
      }
    if (schedule.step >= remaining)
      {
        schedule.step    = remaining;
        schedule.limiter = {remaining, "end of the run", {}};
      }
    else if (schedule.step > 0.5 * remaining) // two equal steps rather than a full one and a sliver
      schedule.step = 0.5 * remaining;
    return schedule;
  }
} // namespace birdstrike
