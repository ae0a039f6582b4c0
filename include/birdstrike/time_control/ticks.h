#pragma once

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

    bool is_due(const double time)
    {
      if (interval < 0.)
        return false;
      if (interval > 0. && n_passed > 0 && time < n_passed * interval * (1. - 1e-12))
        return false;
      n_passed = interval > 0. ? static_cast<std::uint64_t>(time / interval * (1. + 1e-12)) + 1 : 1;
      return true;
    }

  private:
    double        interval; // s
    std::uint64_t n_passed = 0;
  };
} // namespace birdstrike
