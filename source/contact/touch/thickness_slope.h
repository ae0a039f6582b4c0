#pragma once

#include <birdstrike/core/number.h>

#include <array>

namespace birdstrike
{
  /// Where the thickness changes along a shell, its face is not parallel to the middle surface, from which depths are
  /// taken:
  ///
  ///   d = L/2 + t(q) - |p - q|,   -grad d = n - grad t,   t(q) = sum_k w_k t_k the half thickness at the closest
  ///   point.
  ///
  /// A force along n alone would let points that slide towards thicker material gain k d dd for nothing, and those that
  /// slide off it lose it: at 300 m/s along a profile of 1 : 20, 6 % of the force times the way.
  ///
  /// @param x m, corners of the facet (closest_point.h: a fan of four triangles about their mean)
  /// @param half_thickness m, at the corners
  /// @param weights of the closest point q
  /// @return grad t, -, in the plane of the triangle that q lies in; along the edge of one if q is held to it: across
  /// that, q does not move with p. At most 1, nothing where a triangle has no area.
  Point3 compute_thickness_slope(const std::array<Point3, 4> &x, const std::array<double, 4> &half_thickness,
                                 const std::array<double, 4> &weights);
} // namespace birdstrike
