#pragma once

#include <birdstrike/bird/parameters.h>
#include <birdstrike/structure/parameters.h>

namespace birdstrike
{
  /// The part of a bird that one blade of a turning row takes: what lies between the path of its own edge and that of
  /// the blade before it, as seen from the blade, there where the edge is at `edge`.
  ///
  /// With n blades, r the vector from the axis to the edge, v - w x r the velocity of the bird relative to the blade
  /// and e the direction of the edge, the paths lie in planes along that velocity and e; the blade before it is 2 pi
  /// r/n ahead along the unit vector t of the rotation:
  ///   normal m = +- e x (v - w x r)/|...|, ahead of the blade: m . t > 0;   thickness 2 pi r/n (m . t).
  /// A blade that lies behind the path of its own edge (a slow fan, whose blades meet the flow with their backs) takes
  /// what lies between that path and the one of the blade after it.
  /// Paths are helices, of blades whose planes are turned by a pitch: of the slices of a fan blade 1 to 2 % of the mass
  /// lie beyond either path (fan-blade.prm, 40 to 90 % of the span), as much as lies between the paths and is left out.
  struct RowSlice
  {
    /// `edge` (m), its direction `along` (zero: that of the radius) and the chord from it (of any length) as the blade
    /// lies at the start; the bird meets it at its arrival time, with `velocity` (m/s) in fixed axes. @throws
    /// InputError for a bird of which nothing lies between two blades.
    RowSlice(const BirdParameters &bird, const BladeParameters &blade, const Point3 &edge, const Point3 &along,
             const Point3 &chord, const Point3 &velocity);

    Point3 edge;   ///< as given
    Point3 normal; ///< unit, fixed axes, at the arrival time
    double half;   ///< m, of the thickness
    /// As the blade lies at the start: m, halfway between the planes, `edge` in one of them; m/s, of the bird
    /// relative to it.
    Point3 middle, relative;
  };

  /// @throws InputError for a blade that does not turn, or is a row of its own.
  void require_turning_row(const BirdParameters &bird, const BladeParameters &blade);
} // namespace birdstrike
