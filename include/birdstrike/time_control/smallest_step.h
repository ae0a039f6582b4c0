#pragma once

#include <birdstrike/core/archive.h>
#include <birdstrike/core/step_limit.h>

#include <string>

namespace birdstrike
{
  /// Ends a run whose elements collapse: a part's stable step may not fall below a share of its first value (LS-DYNA's
  /// DTMIN), nor may more steps be left than anybody waits for.
  class SmallestStep
  {
  public:
    /// Most steps that may be left, 1e9: at 1 us a step a quarter of an hour, and no step is that cheap.
    static constexpr double most_steps = 1e9;

    /// `part`: "blade", "bird"; `share`: Time/Smallest step.
    SmallestStep(std::string part, double share);

    /// The first call sets the scale. `remaining`: s to the end of the run; `advice`: what helps, one sentence or two.
    /// @throws NumericalFailure naming the step, what limits it and where, and the advice.
    void check(const StepLimit &limit, double remaining, const char *advice);

    double smallest_share() const; ///< of the first value, so far

    void archive(Archive &archive)
    {
      archive((part + ": first and smallest step").c_str(), first, smallest);
    }

  private:
    std::string part;
    double      share, first = 0., smallest = 0.; // s
  };
} // namespace birdstrike
