#pragma once

#include <birdstrike/structure/choices.h>

#include <array>

namespace birdstrike
{
  constexpr unsigned int max_thickness_points = 15;

  /// Positions in [-1, 1] (2 z / t, ascending) and weights (sum 2) of the integration through the thickness.
  /// Three points of either rule integrate elastic bending exactly.
  struct ThicknessPoints
  {
    unsigned int                             n = 0;
    std::array<double, max_thickness_points> position{}, weight{};
  };

  /// Gauss (interior) or Lobatto (faces included); an odd number of points from 3 to max_thickness_points, else throws
  /// InputError. With n points the moment of a section that yields as a whole is right to some 1.4 / n^2 (Gauss).
  ThicknessPoints make_thickness_points(ThicknessRule rule, unsigned int n_points);
} // namespace birdstrike
