#include <birdstrike/bird/shape.h>

#include <cmath>
#include <numbers>

namespace birdstrike
{
  Shape::Shape(const BirdParameters &parameters) : kind(parameters.shape)
  {
    using std::numbers::pi;
    V              = parameters.mass / parameters.density;
    const double r = kind == BirdShape::sphere ? 1. : parameters.length_to_diameter;
    switch (kind)
      {
      case BirdShape::cylinder:
        D = std::cbrt(4. * V / (pi * r));
        break;
      case BirdShape::hemispherical_cylinder:
        D = std::cbrt(V / (pi * (r / 4. - 1. / 12.)));
        break;
      case BirdShape::ellipsoid:
      case BirdShape::sphere:
        D = std::cbrt(6. * V / (pi * r));
        break;
      case BirdShape::slab:
        half = 0.5 * Point3(parameters.slab_lengths[0], parameters.slab_lengths[1], parameters.slab_lengths[2]);
        V    = 8. * half.prod();
        L    = 2. * half[2];
        D    = 2. * std::sqrt(half[0] * half[1]);
        return;
      }
    L    = r * D;
    half = Point3(0.5 * D, 0.5 * D, 0.5 * L);
  }

  bool Shape::contains(const Point3 &p) const
  {
    const double radius = 0.5 * D, r2 = p[0] * p[0] + p[1] * p[1];
    switch (kind)
      {
      case BirdShape::cylinder:
        return r2 <= radius * radius && std::abs(p[2]) <= half[2];
      case BirdShape::hemispherical_cylinder:
        {
          const double beyond = std::max(0., std::abs(p[2]) - (half[2] - radius));
          return r2 + beyond * beyond <= radius * radius;
        }
      case BirdShape::ellipsoid:
      case BirdShape::sphere:
        return r2 / (radius * radius) + p[2] * p[2] / (half[2] * half[2]) <= 1.;
      case BirdShape::slab:
        return (p.cwiseAbs().array() <= half.array()).all();
      }
    return false;
  }
} // namespace birdstrike
