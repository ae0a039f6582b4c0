#pragma once

#include <birdstrike/core/number.h>

#include <array>

/// The signs of what a blade reports. They come from geometry and from the bird, never from the order in which a file
/// lists its cells:
///  - the normal of root and tip points away from the struck side, the one that the bird flies at where it aims (by
///    its velocity relative to the blade there). So deflections are positive with the bird, a positive root moment
///    stretches the struck face, the face at -normal, however the blade is twisted between there and its ends;
///  - without a bird, or with one that flies along the surface (less than 0.6 degrees to it), its component along z is
///    positive, along y where it has none (again within 0.6 degrees), else along x;
///  - the chord of the root (of the tip without a root) runs towards +y, towards +z where it has no such component,
///  else
///    towards +x, whichever side is struck; from there it is followed to the tip, however the sections turn, so that it
///    runs from one edge to the other everywhere. Leading is the corner where it begins.
namespace birdstrike
{
  /// +1 or -1: sign of the first of three components, in the order given, that is more than a hundredth of the norm.
  double sign_by_axes(const Point3 &direction, const std::array<int, 3> &order);

  /// The chord direction of an end: perpendicular to both, unit, with the sign of the root above.
  Point3 chord_along(const Point3 &normal, const Point3 &span);

  /// Whether a normal (unit) must be turned to point away from the struck side; `strike`: velocity of the bird relative
  /// to the blade (m/s), zero without one.
  bool looks_at_strike(const Point3 &normal, const Point3 &strike);
} // namespace birdstrike
