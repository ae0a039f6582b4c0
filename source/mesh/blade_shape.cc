#include <birdstrike/mesh/blade_shape.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double out_of_reach = 1e6; // lengths in m and angles in degrees beyond this are slips of the pen

    /// Height of a camber line over its chord and its slope dh/du, with u from mid-chord.
    struct CamberPoint
    {
      double height, slope;
    };

    CamberPoint circular_arc(const double camber, const double chord, const double u)
    {
      const double curvature = 2. * camber / ((0.25 + camber * camber) * chord);
      const double cosine    = std::sqrt(1. - std::pow(curvature * u, 2));
      return {camber * chord - curvature * u * u / (1. + cosine), -curvature * u / cosine};
    }

    CamberPoint parabola(const double camber, const double chord, const double u)
    {
      return {camber * chord - 4. * camber * u * u / chord, -8. * camber * u / chord};
    }
  } // namespace

  BladeShape::BladeShape(const MeshParameters &p)
    : root_radius(p.profile.root_radius)
    , length(p.length)
    , stacking_point(p.profile.stacking_point)
    , is_parabolic(p.profile.camber_line == CamberLine::parabola)
    , chord_law(p.profile.chord, "Mesh/Profile/Chord law", 1e-6, out_of_reach)
    , stagger_law(p.profile.stagger, "Mesh/Profile/Stagger", -360., 360.)
    , camber_law(p.profile.camber, "Mesh/Profile/Camber", -0.3, 0.3)
    , sweep_law(p.profile.sweep, "Mesh/Profile/Sweep", -out_of_reach, out_of_reach)
    , lean_law(p.profile.lean, "Mesh/Profile/Lean", -out_of_reach, out_of_reach)
    , plate_chord(p.chord)
  {
  }

  double BladeShape::chord(const double s) const
  {
    return plate_chord * chord_law(s);
  }

  double BladeShape::stagger(const double s) const
  {
    return stagger_law(s) * M_PI / 180.;
  }

  BladeShape::Section BladeShape::section(const double s) const
  {
    const double angle = stagger(s);
    return {Point3(root_radius + s * length, sweep_law(s), lean_law(s)), Point3(0., std::cos(angle), std::sin(angle)),
            Point3(0., -std::sin(angle), std::cos(angle)), chord(s), camber_law(s)};
  }

  Point3 BladeShape::position(const Section &section, const double c) const
  {
    const double height =
      (is_parabolic ? parabola : circular_arc)(section.camber, section.chord, (c - 0.5) * section.chord).height;
    return section.stack + (c - stacking_point) * section.chord * section.along + height * section.across;
  }

  Point3 BladeShape::position(const double s, const double c) const
  {
    return position(section(s), c);
  }

  Point3 BladeShape::normal(const double s, const double c) const
  {
    const double step = 1e-4;
    Point3       along_span;
    if (s >= step && s <= 1. - step)
      along_span = position(s + step, c) - position(s - step, c);
    else
      {
        const double inwards = s < 0.5 ? step : -step;
        along_span =
          (4. * position(s + inwards, c) - 3. * position(s, c) - position(s + 2. * inwards, c)) * (s < 0.5 ? 1. : -1.);
      }
    const Section here = section(s);
    const double  slope =
      (is_parabolic ? parabola : circular_arc)(here.camber, here.chord, (c - 0.5) * here.chord).slope;
    const Point3 along_chord = here.along + slope * here.across;
    return along_span.cross(along_chord).normalized();
  }

  std::array<double, 2> BladeShape::coordinates(const double *position) const
  {
    const double  s    = std::clamp((position[0] - root_radius) / length, 0., 1.);
    const Section here = section(s);
    const Point3  from = Point3(position[0], position[1], position[2]) - here.stack;
    return {{s, std::clamp(stacking_point + from.dot(here.along) / here.chord, 0., 1.)}};
  }
} // namespace birdstrike
