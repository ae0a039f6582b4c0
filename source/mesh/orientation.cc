#include <birdstrike/mesh/orientation.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// Cosine below which a direction has no component along another: well above round-off, so that the sign of a
    /// mesh does not hang on it.
    constexpr double least_cosine = 0.01;
  } // namespace

  double sign_by_axes(const Point3 &direction, const std::array<int, 3> &order)
  {
    for (const int axis : order)
      if (std::abs(direction[axis]) > least_cosine * direction.norm())
        return direction[axis] > 0. ? 1. : -1.;
    return 1.;
  }

  Point3 chord_along(const Point3 &normal, const Point3 &span)
  {
    const Point3 chord = normal.cross(span).normalized();
    return sign_by_axes(chord, {{1, 2, 0}}) * chord;
  }

  bool looks_at_strike(const Point3 &normal, const Point3 &strike)
  {
    const double along = normal.dot(strike);
    if (std::abs(along) > least_cosine * strike.norm())
      return along < 0.;
    return sign_by_axes(normal, {{2, 1, 0}}) < 0.;
  }
} // namespace birdstrike
