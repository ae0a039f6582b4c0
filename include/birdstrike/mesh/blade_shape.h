#pragma once

#include <birdstrike/core/expression.h>
#include <birdstrike/core/number.h>
#include <birdstrike/mesh/parameters.h>

#include <array>

namespace birdstrike
{
  /// Mid-surface of the built-in blade: a map of (s, c), both from 0 to 1, where s = 0 is the root and 1 the tip, c = 0
  /// the leading and 1 the trailing edge.
  ///
  /// Axes: y along the axis of the engine, downstream; x radial; z tangential. Sections are plane, x = r(s) = root
  /// radius + s length, and the chord line of a section stands at the stagger angle xi to the axis, as is usual for
  /// compressor blades (Dixon and Hall, Fluid Mechanics and Thermodynamics of Turbomachinery, section 3.2):
  ///   e(s) = (0, cos xi, sin xi),   n(s) = (0, -sin xi, cos xi),
  ///   X(s, c) = (r, sweep, lean) + (c - c_stack) l e + h n,      l = Mesh/Chord * chord law(s).
  /// A blade of positive stagger turns towards -z, about +y; positive camber bulges towards +n, the suction side. The
  /// height h of the camber line over the chord line, largest at mid-chord with h = f l (f: camber), is with
  /// u = (c - 1/2) l
  ///   circular arc:  h = f l - kappa u^2 / (1 + sqrt(1 - kappa^2 u^2)),   kappa = 2 f / ((1/4 + f^2) l),
  ///                  turned by the camber angle 4 atan(2 f) from edge to edge,
  ///   parabola:      h = 4 f l c (1 - c).
  /// With all laws at their defaults this is the flat plate. Lengths in m, angles in rad.
  ///
  /// Throws InputError, naming the entry, for a law that is no formula or leaves its range: chord > 0, |camber| <= 0.3.
  class BladeShape
  {
  public:
    explicit BladeShape(const MeshParameters &parameters);

    Point3 position(double s, double c) const;

    /// dX/ds x dX/dc over its length; dX/ds by second-order differences that stay within 0 <= s <= 1, so that its
    /// error is 1e-8 of the third derivative of the laws.
    Point3 normal(double s, double c) const;

    /// (s, c) of the point whose projection onto the chord line this is; both clipped to [0, 1].
    std::array<double, 2> coordinates(const double *position) const;

    double chord(double s) const;   ///< m
    double stagger(double s) const; ///< rad

  private:
    /// A section: its chord line and its camber.
    struct Section
    {
      Point3 stack, along, across;
      double chord, camber;
    };
    Section section(double s) const;
    Point3  position(const Section &section, double c) const;

    double  root_radius, length, stacking_point;
    bool    is_parabolic;
    SpanLaw chord_law, stagger_law, camber_law, sweep_law, lean_law;
    double  plate_chord;
  };
} // namespace birdstrike
