#pragma once

#include <birdstrike/core/number.h>

namespace birdstrike
{
  /// The larger of two numbers; no number (NaN) where one of them is none. std::max loses a NaN in its second argument,
  /// the maximum of registers in one of the two: what decides by a maximum decides by these.
  inline double larger(const double a, const double b)
  {
    return a != a || a >= b ? a : b;
  }
  inline double smaller(const double a, const double b)
  {
    return a != a || a <= b ? a : b;
  }
  /// Whether a value takes the place of the largest so far: it is larger, or the first that is no number.
  inline bool exceeds(const double value, const double largest)
  {
    return !(value <= largest) && largest == largest;
  }
  /// Whether a vote on the step decides over another: it is shorter, or the first that is no number.
  inline bool goes_before(const double step, const double other)
  {
    return !(step >= other) && other == other;
  }
  inline Lanes larger(const Lanes &a, const Lanes &b)
  {
    return select(a != a || a >= b, a, b);
  }

  /// Of the lanes of a register.
  inline double largest_lane(const Lanes &a)
  {
    double result = lane(a, 0);
    for (std::size_t k = 1; k < n_lanes; ++k)
      result = larger(result, lane(a, k));
    return result;
  }
} // namespace birdstrike
