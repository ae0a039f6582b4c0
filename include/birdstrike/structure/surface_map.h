#pragma once

#include <birdstrike/core/number.h>
#include <birdstrike/structure/parameters.h>

#include <array>
#include <memory>

namespace birdstrike
{
  /// The undeformed mid-surface of a blade by shares of its span, 0 at the root and 1 at the tip, and of the chord of
  /// the section there, 0 at the leading and 1 at the trailing edge. Lengths in m.
  class SurfaceMap
  {
  public:
    virtual ~SurfaceMap() = default;

    virtual Point3 position(double span, double chord) const = 0;
    /// From the leading to the trailing edge of a section, unit.
    virtual Point3 chord_direction(double span) const = 0;
    /// Shares of the point of the surface beside this one; beyond an edge those of the edge.
    virtual std::array<double, 2> shares(const Point3 &point) const = 0;
    /// Span times chord, unit: +z on the built-in plate.
    virtual Point3 normal(double span, double chord) const = 0;
  };

  /// Of a built-in part its formulas (mesh/blade_shape.h), whatever it is held by. Of a file the cuts of its surface or
  /// skin square to the line from the middle of the root to the middle of the tip, the boundaries that Supports names:
  /// edges are the two ends of a cut along the longer axis of its second moment, the chord runs between them as
  /// orientation.h says, and
  /// where a cut has two faces, as in a solid, the point halfway between them counts.
  ///
  /// Nothing for a blade that has no mesh, and for a file that has no root, no tip, or is half of a symmetric blade.
  /// Reads the file. Throws InputError as the blade does.
  std::unique_ptr<const SurfaceMap> make_surface_map(const BladeParameters &parameters);
} // namespace birdstrike
