#pragma once

#include <birdstrike/core/archive.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  /// The largest value of a curve so far, and when. What is no number (NaN) is the peak from then on.
  class Peak
  {
  public:
    void update(const double time, const double value)
    {
      if (!std::isnan(largest) && !(value <= largest)) // the first value, and a NaN, too
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

  /// The largest value of a curve in either direction so far, with its sign, and when. What is no number (NaN) is the
  /// peak from then on.
  class SignedPeak
  {
  public:
    /// Whether this value is the new peak.
    bool update(const double time, const double value)
    {
      if (std::isnan(largest) || std::abs(value) <= std::abs(largest))
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

  /// The first maximum of a deflection from its start, in either direction, that follows a load. It has passed once
  ///  - the load has stayed below 5 % of its largest value,
  ///  - the deflection has stayed within its extremes (a ripple on the way up ends sooner: 0.7 ms in the frontal
  ///  strike),
  /// both for `wait` seconds, and
  ///  - the maximum exceeds the largest deflection the other way, against the load: a blade struck outboard first moves
  ///    its tip backwards. Where nothing strikes, or the tip has since swung through and turned back on the other side
  ///    as well, the larger of the two is the maximum.
  class FirstMaximum
  {
  public:
    void update(const double time, const double deflection, const double load)
    {
      if (!has_started)
        start = deflection;
      has_started        = true;
      const double value = deflection - start;
      forward.update(time, value);
      if (-value > backward.value())
        since_backward = Peak();
      since_backward.update(time, value);
      backward.update(time, -value);
      peak_load.update(time, load);
      if (load > 0.05 * peak_load.value())
        last_loaded = time;
    }
    bool is_passed(const double now, const double wait) const
    {
      return std::max(forward.value(), backward.value()) > 0. && has_turned_back(now, wait) &&
             now - backward.time() > wait && now - last_loaded > wait;
    }
    /// Whether for longer than `wait` there has been nothing larger. Of a deflection that is largest backwards this is
    /// asked of the other side since, and for twice as long as it took to go backwards: on the way to the peak of a
    /// slow blade shorter waves make it pause.
    bool has_turned_back(const double now, const double wait) const
    {
      if (forward.value() > backward.value() || peak_load.value() == 0.)
        return now - forward.time() > wait;
      return since_backward.value() > 0. && now - since_backward.time() > std::max(wait, 2. * backward.time());
    }
    void archive(Archive &archive, const char *name)
    {
      const auto group = archive.group(name);
      archive("has started", has_started);
      archive("start", start);
      forward.archive(archive, "deflection");
      backward.archive(archive, "backward");
      since_backward.archive(archive, "since the largest backward");
      peak_load.archive(archive, "load");
      archive("last loaded", last_loaded);
    }

  private:
    bool   has_started = false;
    double start       = 0.;
    Peak   forward, backward, since_backward, peak_load; // from the start on
    double last_loaded = -INFINITY;                      // s
  };
} // namespace birdstrike
