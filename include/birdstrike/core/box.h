#pragma once

#include <birdstrike/core/number.h>

#include <algorithm>
#include <array>
#include <limits>

namespace birdstrike
{
  /// Times at which something holds; none where first > last. s
  struct TimeSpan
  {
    double first = 0., last = std::numeric_limits<double>::infinity();

    bool is_empty() const
    {
      return first > last;
    }
    /// Cuts it to the times at which a + b t >= 0.
    void cut(double a, double b);
  };

  /// An axis-aligned box, m; empty until it has been extended.
  struct Box
  {
    std::array<double, 3> low{{1e300, 1e300, 1e300}}, high{{-1e300, -1e300, -1e300}};

    static Box everything()
    {
      return {{{-1e300, -1e300, -1e300}}, {{1e300, 1e300, 1e300}}};
    }

    void add(const double *p, const double margin = 0.)
    {
      for (unsigned int d = 0; d < 3; ++d)
        {
          low[d]  = std::min(low[d], p[d] - margin);
          high[d] = std::max(high[d], p[d] + margin);
        }
    }
    void add(const Box &other)
    {
      for (unsigned int d = 0; d < 3; ++d)
        {
          low[d]  = std::min(low[d], other.low[d]);
          high[d] = std::max(high[d], other.high[d]);
        }
    }
    Box widened(const double margin) const
    {
      Box box = *this;
      for (unsigned int d = 0; d < 3; ++d)
        {
          box.low[d] -= margin;
          box.high[d] += margin;
        }
      return box;
    }

    bool contains(const Point3 &p) const
    {
      return p[0] >= low[0] && p[0] <= high[0] && p[1] >= low[1] && p[1] <= high[1] && p[2] >= low[2] &&
             p[2] <= high[2];
    }
    bool is_empty() const
    {
      return low[0] > high[0];
    }

    /// Largest axis-wise distance to another box, m: a lower bound of the distance, negative where they overlap.
    double separation(const Box &other) const
    {
      double result = -1e300;
      for (unsigned int d = 0; d < 3; ++d)
        result = std::max({result, low[d] - other.high[d], other.low[d] - high[d]});
      return result;
    }

    /// When the ray x + v t is inside, t >= 0 (Kay and Kajiya 1986: between the planes of each axis at once).
    TimeSpan passage(const Point3 &x, const Point3 &v) const;

    /// The same while the low faces move with the velocities `faces.low` and the high ones with `faces.high`, m/s.
    TimeSpan passage(const Point3 &x, const Point3 &v, const Box &faces) const;
  };
} // namespace birdstrike
