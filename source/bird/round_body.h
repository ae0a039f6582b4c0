#pragma once

#include <birdstrike/bird/parameters.h>

namespace birdstrike
{
  /// A body of revolution about z, its middle at the origin, and what planes n.q = s cut off it; lengths in m.
  ///
  /// n is a unit vector, `cosine` its share along the axis: by symmetry nothing else of it matters, nor its sign.
  /// Closed forms: any plane through an ellipsoid (an affine image of the ball, whose segment of height a is pi a^2 (3
  /// - a)/3), planes across the axis of the others. Inclined planes through those: the integral along the axis of the
  /// segments of discs that the plane leaves, Gauss' rule between the places where the plane meets or leaves the
  /// surface; error below 1e-11 of the body (tests/unit/bird/slice_test.cc).
  class RoundBody
  {
  public:
    /// Any shape but a slab.
    RoundBody(BirdShape shape, double diameter, double length);

    double radius(double z) const;                      ///< of the cross-section at z, 0 beyond the ends
    double reach(double cosine) const;                  ///< largest n.q of the body
    double volume_to(double s, double cosine) const;    ///< m^3, from the plane n.q = 0 to n.q = s; odd in s
    double section_area(double s, double cosine) const; ///< m^2, of the section n.q = s

  private:
    template <class Integrand>
    double integrate_discs(double s, double cosine, double sine, const Integrand &integrand) const;

    BirdShape shape;
    double    R, half; ///< radius, half the length
  };
} // namespace birdstrike
