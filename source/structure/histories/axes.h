#pragma once

#include <birdstrike/core/number.h>
#include <birdstrike/mesh/roles.h>

#include <array>
#include <string>

namespace birdstrike
{
  /// Fixed axes in which components are given: unit vectors in the rows of `rotation`.
  struct Axes
  {
    Matrix3<double>            rotation = Matrix3<double>::Identity();
    std::array<std::string, 3> names{{"x", "y", "z"}};
    std::string                text = "global axes";

    Point3 of(const Point3 &v) const
    {
      return rotation * v;
    }
    /// xx, yy, zz, xy, yz, zx.
    std::array<double, 6>      of(const std::array<double, 6> &tensor) const;
    std::array<std::string, 6> tensor_names() const;
  };

  /// Span, chord and normal of the undeformed blade at a point: normal that of the surface there (at nodes the mean
  /// of their facets that look along the blade's normal, between those of root and tip; within a facet between its
  /// nodes), away from the struck side;
  /// span from the middle of the root to that of the tip without its part along the normal; chord square to both, from
  /// the leading to the trailing edge (BladeRoles::chord_at). Rows of the rotation. Throws InputError, naming the
  /// entry, where the blade has no clamped root.
  Matrix3<double> find_blade_axes(const SurfaceMesh &surface, const BladeRoles &roles, const Point3 &point,
                                  const std::string &entry);

  /// What Output/Histories/Axes asks for: global, blade, or six numbers, a vector along axis 1 and one in the plane of
  /// axes 1 and 2 (LS-DYNA: *DEFINE_COORDINATE_VECTOR). Throws InputError.
  Axes make_axes(const std::string &text, const SurfaceMesh &surface, const BladeRoles &roles, const Point3 &point);
} // namespace birdstrike
