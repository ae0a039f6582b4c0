#include <birdstrike/time_control/step_limiters.h>

#include <algorithm>
#include <functional>

namespace birdstrike
{
  void StepLimiters::count(const StepLimit &limiter, const double time)
  {
    if (present >= limiters.size() || limiters[present].reason != limiter.reason)
      {
        present = std::ranges::find(limiters, limiter.reason, &Limiter::reason) - limiters.begin();
        if (present == limiters.size())
          limiters.emplace_back().reason = limiter.reason;
      }
    Limiter &of_reason = limiters[present];
    if (++of_reason.n_steps > 1 && limiter.value >= of_reason.step)
      return;
    of_reason.step     = limiter.value;
    of_reason.time     = time;
    of_reason.kind     = limiter.where.kind ? limiter.where.kind : "";
    of_reason.id       = limiter.where.id;
    of_reason.position = limiter.where.position;
  }

  std::vector<StepLimiters::Limiter> StepLimiters::all() const
  {
    std::vector<Limiter> sorted = limiters;
    std::ranges::stable_sort(sorted, std::greater<>(), &Limiter::n_steps);
    return sorted;
  }

  void StepLimiters::archive(Archive &archive)
  {
    archive.records("step limiter", limiters, [](Archive::Row &row, Limiter &limiter) {
      row.list("reason", limiter.reason);
      row("steps", limiter.n_steps);
      row("shortest step", limiter.step, limiter.time);
      row.list("kind", limiter.kind);
      row("id", limiter.id);
      row("position", limiter.position);
    });
  }
} // namespace birdstrike
