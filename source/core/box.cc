#include <birdstrike/core/box.h>

#include <algorithm>

namespace birdstrike
{
  void Box::add(const double *p, const double margin)
  {
    for (unsigned int d = 0; d < 3; ++d)
      {
        low[d]  = std::min(low[d], p[d] - margin);
        high[d] = std::max(high[d], p[d] + margin);
      }
  }

  void Box::add(const Box &other)
  {
    for (unsigned int d = 0; d < 3; ++d)
      {
        low[d]  = std::min(low[d], other.low[d]);
        high[d] = std::max(high[d], other.high[d]);
      }
  }

  double Box::separation(const Box &other) const
  {
    double result = -1e300;
    for (unsigned int d = 0; d < 3; ++d)
      result = std::max({result, low[d] - other.high[d], other.low[d] - high[d]});
    return result;
  }

  Box Box::widened(const double margin) const
  {
    Box box = *this;
    for (unsigned int d = 0; d < 3; ++d)
      {
        box.low[d] -= margin;
        box.high[d] += margin;
      }
    return box;
  }

  void TimeSpan::cut(const double a, const double b)
  {
    if (b > 0.)
      first = std::max(first, -a / b);
    else if (b < 0.)
      last = std::min(last, -a / b);
    else if (a < 0.)
      last = -std::numeric_limits<double>::infinity();
  }

  TimeSpan Box::passage(const Point3 &x, const Point3 &v) const
  {
    return passage(x, v, {{{0., 0., 0.}}, {{0., 0., 0.}}});
  }

  TimeSpan Box::passage(const Point3 &x, const Point3 &v, const Box &faces) const
  {
    TimeSpan inside;
    for (unsigned int d = 0; d < 3; ++d)
      {
        inside.cut(x[d] - low[d], v[d] - faces.low[d]);
        inside.cut(high[d] - x[d], faces.high[d] - v[d]);
      }
    return inside;
  }
} // namespace birdstrike
