#include <birdstrike/core/box.h>

#include <algorithm>

namespace birdstrike
{
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
