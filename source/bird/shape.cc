#include "bird/attitude.h"
#include "bird/round_body.h"
#include <birdstrike/bird/shape.h>

#include <algorithm>
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
        half       = 0.5 * Point3(parameters.slab_lengths[0], parameters.slab_lengths[1], parameters.slab_lengths[2]);
        V          = 8. * half.prod();
        L          = 2. * half[2];
        D          = 2. * std::sqrt(half[0] * half[1]);
        whole_half = half;
        return;
      }
    L          = r * D;
    half       = Point3(0.5 * D, 0.5 * D, 0.5 * L);
    whole_half = half;
    if (parameters.is_slice())
      cut_out(parameters);
  }

  void Shape::cut_out(const BirdParameters &parameters)
  {
    const RoundBody       whole(kind, D, L);
    const Matrix3<double> axes =
      parameters.slice_normal.empty()
        ? Matrix3<double>(Matrix3<double>::Identity())
        : Matrix3<double>(compute_attitude(parameters).transpose() * compute_slice_frame(parameters));
    const Point3 normal = axes.col(2);
    const double reach  = whole.reach(normal[2]);
    const double low    = std::clamp(parameters.slice_between[0], -reach, reach),
                 high   = std::clamp(parameters.slice_between[1], -reach, reach);
    cut                 = Cut{axes, 0.5 * (low + high) * normal, reach};
    V                   = whole.volume_to(high, normal[2]) - whole.volume_to(low, normal[2]);
    L                   = high - low;
    // of a body that is its own mirror image the sections shrink from its middle on
    D    = 2. * std::sqrt(whole.section_area(std::clamp(0., low, high), normal[2]) / std::numbers::pi);
    half = Point3(whole.reach(axes(2, 0)), whole.reach(axes(2, 1)), 0.5 * L);
  }

  bool Shape::contains(const Point3 &p) const
  {
    if (!cut)
      return whole_contains(p);
    constexpr double round_off = 1e-9; // of points that lie in a plane neither side takes any
    return std::abs(p[2]) < half[2] * (1. - round_off) && whole_contains(in_bird(p));
  }

  bool Shape::whole_contains(const Point3 &p) const
  {
    const double radius = whole_half[0], r2 = p[0] * p[0] + p[1] * p[1];
    switch (kind)
      {
      case BirdShape::cylinder:
        return r2 <= radius * radius && std::abs(p[2]) <= whole_half[2];
      case BirdShape::hemispherical_cylinder:
        {
          const double beyond = std::max(0., std::abs(p[2]) - (whole_half[2] - radius));
          return r2 + beyond * beyond <= radius * radius;
        }
      case BirdShape::ellipsoid:
      case BirdShape::sphere:
        return r2 / (radius * radius) + p[2] * p[2] / (whole_half[2] * whole_half[2]) <= 1.;
      case BirdShape::slab:
        return (p.cwiseAbs().array() <= whole_half.array()).all();
      }
    return false;
  }
} // namespace birdstrike
