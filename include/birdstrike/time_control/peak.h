#pragma once

#include <birdstrike/core/archive.h>

#include <algorithm>
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
    void archive(Archive &archive, const char *name)
    {
      archive(name, largest, when);
    }

  private:
    double largest = -INFINITY;
    double when    = 0.;
  };

  /// The largest value of a curve in either direction so far, with its sign, and when.
  class SignedPeak
  {
  public:
    /// Whether this value is the new peak.
    bool update(const double time, const double value)
    {
      if (std::abs(value) <= std::abs(largest))
        return false;
      largest = value;
      when    = time;
      return true;
    }
    double value() const
    {
      return largest;
    }
    double time() const
    {
      return when;
    }
    void archive(Archive &archive, const char *name)
    {
      archive(name, largest, when);
    }

  private:
    double largest = 0.;
    double when    = 0.;
  };

  /// The first maximum of a deflection, in either direction, that follows a load. It has passed once
  ///  - the load has stayed below 5 % of its largest value,
  ///  - the deflection has stayed within its extremes (a ripple on the way up ends sooner: 0.7 ms in the frontal
  ///  strike),
  /// both for `wait` seconds, and
  ///  - the maximum exceeds the largest deflection the other way, against the load: a blade struck outboard first moves
  ///    its tip backwards. Where nothing strikes, or the tip has since swung through to the other side, the larger of
  ///    the two is the maximum.
  class FirstMaximum
  {
  public:
    void update(const double time, const double deflection, const double load)
    {
      peak.update(time, deflection);
      if (backward.value() < -deflection)
        has_swung_through = false;
      else if (deflection > 0.)
        has_swung_through = true;
      backward.update(time, -deflection);
      peak_load.update(time, load);
      if (load > 0.05 * peak_load.value())
        last_loaded = time;
    }
    bool is_passed(const double now, const double wait) const
    {
      const bool has_maximum =
        peak.value() > backward.value() ? peak.value() > 0. : peak_load.value() == 0. || has_swung_through;
      return has_maximum && std::max(peak.value(), backward.value()) > 0. && now - peak.time() > wait &&
             now - backward.time() > wait && now - last_loaded > wait;
    }
    void archive(Archive &archive, const char *name)
    {
      const auto group = archive.group(name);
      peak.archive(archive, "deflection");
      backward.archive(archive, "backward");
      peak_load.archive(archive, "load");
      archive("last loaded", last_loaded);
      archive("has swung through", has_swung_through);
    }

  private:
    Peak   peak, backward, peak_load;
    double last_loaded       = -INFINITY; // s
    bool   has_swung_through = false;     // since the largest deflection backwards
  };
} // namespace birdstrike
