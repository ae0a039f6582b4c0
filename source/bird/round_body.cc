#include "bird/round_body.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace birdstrike
{
  namespace
  {
    using std::numbers::pi;

    /// Beside it the sine of the angle is round-off.
    constexpr double straight = 1. - 1e-14;

    double square(const double a)
    {
      return a * a;
    }

    /// Half the chord of a disc at the distance x; a product, for a fused r r - x x is not 0 at x = r.
    double half_chord(const double r, const double x)
    {
      return std::sqrt(std::max(0., (r - x) * (r + x)));
    }

    /// Area of a disc from the diameter to the chord at the distance x; odd in x.
    double segment_area(const double r, const double x)
    {
      if (r <= 0.)
        return 0.;
      const double within = std::clamp(x, -r, r);
      return within * half_chord(r, within) + r * r * std::asin(within / r);
    }
  } // namespace

  RoundBody::RoundBody(const BirdShape shape, const double diameter, const double length)
    : shape(shape), R(0.5 * diameter), half(0.5 * length)
  {
  }

  double RoundBody::radius(const double z) const
  {
    if (std::abs(z) > half)
      return 0.;
    switch (shape)
      {
      case BirdShape::cylinder:
        return R;
      case BirdShape::hemispherical_cylinder:
        return half_chord(R, std::max(0., std::abs(z) - (half - R)));
      default:
        return R * half_chord(1., z / half);
      }
  }

  double RoundBody::reach(const double cosine) const
  {
    const double c = std::abs(cosine), sine = half_chord(1., c);
    switch (shape)
      {
      case BirdShape::cylinder:
        return half * c + R * sine;
      case BirdShape::hemispherical_cylinder:
        return (half - R) * c + R;
      default:
        return std::hypot(half * c, R * sine);
      }
  }

  /// Of integrand(radius of the disc at z, distance of the plane's chord from its middle). Pieces end where the plane
  /// crosses the rim of a disc: |s - z cosine| = radius(z) sine. There the integrand has a root of the distance, which
  /// z = (3 t - t^3)/2 on a piece turns into a power of t -+ 1.
  template <class Integrand>
  double RoundBody::integrate_discs(const double s, const double cosine, const double sine,
                                    const Integrand &integrand) const
  {
    const double        middle = shape == BirdShape::cylinder ? half : half - R; // up to there the radius is R
    std::vector<double> ends{-half, half, -middle, middle};
    for (const double side : {-1., 1.})
      {
        if (cosine > 0.)
          ends.push_back((s + side * R * sine) / cosine);
        for (const double centre : {-middle, middle}) // of an end's sphere
          {
            const double p = s * cosine + sine * sine * centre;
            const double q = s * s - square(sine) * (R * R - centre * centre);
            if (p * p > q)
              ends.push_back(p + side * std::sqrt(p * p - q));
          }
      }
    for (double &z : ends)
      z = std::clamp(z, -half, half);
    std::sort(ends.begin(), ends.end());
    static const dealii::QGauss<1> rule(24); // points in [0, 1]
    double                         sum = 0.;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
      if (const double mid = 0.5 * (ends[k] + ends[k + 1]), wide = 0.5 * (ends[k + 1] - ends[k]); wide > 0.)
        for (unsigned int i = 0; i < rule.size(); ++i)
          {
            const double t = 2. * rule.point(i)[0] - 1., z = mid + wide * 0.5 * t * (3. - t * t);
            sum += 3. * rule.weight(i) * wide * (1. - t * t) * integrand(radius(z), (s - z * cosine) / sine);
          }
    return sum;
  }

  double RoundBody::volume_to(const double plane, const double cosine) const
  {
    const double c = std::abs(cosine), end = reach(c), s = std::clamp(plane, -end, end);
    if (shape == BirdShape::ellipsoid || shape == BirdShape::sphere)
      {
        const double u = s / end;
        return pi * R * R * half * u * (1. - u * u / 3.);
      }
    if (c < straight)
      return integrate_discs(s, c, half_chord(1., c), segment_area);
    if (shape == BirdShape::cylinder)
      return pi * R * R * s;
    const double up = std::abs(s), in_end = std::max(0., up - (half - R));
    return std::copysign(pi * (R * R * up - in_end * in_end * in_end / 3.), s);
  }

  double RoundBody::section_area(const double s, const double cosine) const
  {
    const double c = std::abs(cosine), end = reach(c);
    if (std::abs(s) > end)
      return 0.;
    if (shape == BirdShape::ellipsoid || shape == BirdShape::sphere)
      return pi * R * R * half * (1. - square(s / end)) / end;
    if (c >= straight)
      return pi * square(radius(s));
    const double sine = half_chord(1., c);
    return integrate_discs(s, c, sine, [](const double r, const double x) { return 2. * half_chord(r, x); }) / sine;
  }
} // namespace birdstrike
