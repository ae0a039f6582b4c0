#pragma once

#include <birdstrike/core/archive.h>

#include <cstdint>

namespace birdstrike
{
  /// Output ticks at multiples of an interval: due once the time has reached the next one. The first call is always
  /// due. An interval of zero is due at every call; a negative one never.
  class Ticks
  {
  public:
    explicit Ticks(const double interval) : interval(interval)
    {
    }

    /// Passes the tick if it is due.
    bool is_due(const double time)
    {
      const bool due = would_be_due(time);
      if (due)
        n_passed = interval > 0. ? static_cast<std::uint64_t>(time / interval * (1. + 1e-12)) + 1 : 1;
      return due;
    }

    /// The same without passing it.
    bool would_be_due(const double time) const
    {
      return interval == 0. || (interval > 0. && (n_passed == 0 || time >= n_passed * interval * (1. - 1e-12)));
    }

    void archive(Archive &archive, const char *name)
    {
      archive(name, n_passed);
    }

  private:
    double        interval; // s
    std::uint64_t n_passed = 0;
  };
} // namespace birdstrike
