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

  private:
    double largest = -INFINITY;
    double when    = 0.;
  };

  /// The first maximum of a deflection that follows a load. It has passed once
  ///  - the load has stayed below 5 % of its largest value,
  ///  - the deflection has stayed below its maximum (a ripple on the way up ends sooner: 0.7 ms in the frontal strike),
  /// both for `wait` seconds, and
  ///  - the maximum exceeds the largest deflection the other way: a blade struck outboard first moves its tip
  ///  backwards.
  class FirstMaximum
  {
  public:
    void update(const double time, const double deflection, const double load)
    {
      peak.update(time, deflection);
      backward.update(time, -deflection);
      peak_load.update(time, load);
      if (load > 0.05 * peak_load.value())
        last_loaded = time;
    }
    bool is_passed(const double now, const double wait) const
    {
      return peak.value() > 0. && peak.value() > backward.value() && now - peak.time() > wait &&
             now - last_loaded > wait;
    }

  private:
    Peak   peak, backward, peak_load;
    double last_loaded = -INFINITY; // s
  };
} // namespace birdstrike
