#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string>

namespace birdstrike
{
  /// One entity of a part, in numbers: a vote is cast at every step, its words are read once in a run.
  struct EntityPlace
  {
    const char           *kind = nullptr; ///< "particle", "element"; null: no entity
    std::size_t           id   = 0;
    std::array<double, 3> position{}; ///< m

    /// "element 17 at (0.01, 0.02, 0)"; empty without an entity.
    std::string text() const;
  };

  /// A part's vote on the time step: the largest stable step (s), why, and which entity says so. Allocates nothing.
  struct StepLimit
  {
    double      value  = std::numeric_limits<double>::infinity();
    const char *reason = ""; ///< e.g. "shell element, membrane wave"
    EntityPlace where;

    std::string text() const;  ///< "shell element, largest eigenvalue, element 17 at (0.01, 0.02, 0)"
    std::string brief() const; ///< "shell element 17", "contact, node 5", "end of the run"
  };

  /// What a part brings to the choice of a schedule.
  struct StepVote
  {
    StepLimit limit; ///< largest stable step
    double    price; ///< ns that one of its steps costs (prices.h)
  };
} // namespace birdstrike
