#pragma once

#include <cmath>

namespace birdstrike
{
  /// The largest value of a curve so far, and when.
  class Peak
  {
  public:
    void update(const double time, const double value)
    {
      if (!(value <= largest)) // the first value, and a NaN, too
        {
          largest = value;
          when    = time;
        }
    }
    double value() const
    {
      return largest == -INFINITY ? 0. : largest;
    }
    double time() const
    {
      return when;
    }

    /// The curve has come down from its peak by `share` of it, `hold` seconds after it: not a ripple on the way up.
    bool is_passed(const double now, const double value, const double share, const double hold) const
    {
      return largest > 0. && now - when > hold && value < (1. - share) * largest;
    }

  private:
    double largest = -INFINITY;
    double when    = 0.;
  };
} // namespace birdstrike
