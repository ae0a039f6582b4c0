#pragma once

#include <birdstrike/core/archive.h>

#include <cstdint>
#include <utility>

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

    /// Read with another interval, the next tick is the first of that after the last one passed.
    void archive(Archive &archive, const char *name)
    {
      const auto   group = archive.group(name);
      const double own   = interval;
      archive("interval", interval);
      archive("passed", n_passed);
      const double then = std::exchange(interval, own);
      if (then != own && n_passed > 0 && own > 0.)
        n_passed = static_cast<std::uint64_t>(then * static_cast<double>(n_passed - 1) / own * (1. + 1e-12)) + 1;
    }

  private:
    double        interval; // s
    std::uint64_t n_passed = 0;
  };
} // namespace birdstrike
