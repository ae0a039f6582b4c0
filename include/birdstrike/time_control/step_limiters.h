#pragma once

#include <birdstrike/core/archive.h>
#include <birdstrike/core/step_limit.h>

#include <cstdint>
#include <string>
#include <vector>

namespace birdstrike
{
  /// What has limited the steps of a run: for each reason how many of them, and the shortest.
  class StepLimiters
  {
  public:
    struct Limiter
    {
      std::string           reason; ///< of StepLimit
      std::uint64_t         n_steps = 0;
      double                step = 0., time = 0.; ///< s, the shortest step that the reason allowed its part, and when
      std::string           kind;                 ///< of the entity that said so then; empty: none
      std::uint64_t         id = 0;
      std::array<double, 3> position{}; ///< m
    };

    /// One macro step (Schedule::limiter) that begins at `time` (s).
    void count(const StepLimit &limiter, double time);

    std::vector<Limiter> all() const; ///< those of most steps first

    void archive(Archive &archive);

  private:
    std::vector<Limiter> limiters; ///< in the order in which they came
    std::size_t          present = 0;
  };
} // namespace birdstrike
