#pragma once

#include <birdstrike/core/archive.h>
#include <birdstrike/core/fields.h>

#include <array>
#include <vector>

namespace birdstrike
{
  /// Particles that have left the computation, for pictures: nothing acts on them any more, so each flies on along
  /// x + v (t - t_removed) with the fields that it had.
  class RemovedParticles
  {
  public:
    /// Keeps those of `before` that `after` lacks, by the field "id".
    void keep(const FieldSnapshot &before, const FieldSnapshot &after, double time);

    /// Appends them where they are at `time`, and the field "removed": 1 of them, 0 of all others.
    void add_to(FieldSnapshot &particles, double time) const;

    bool is_empty() const
    {
      return all.empty();
    }

    void archive(Archive &archive);

  private:
    struct Particle
    {
      double                time; ///< s, when it was removed
      std::array<double, 3> position, velocity;
      std::vector<double>   values; ///< of all fields, one after the other
    };
    std::vector<Particle> all;
  };
} // namespace birdstrike
