#pragma once

#include <birdstrike/structure/choices.h>

#include <array>

namespace birdstrike
{
  /// Positions in [-1, 1] (2 z / t, ascending) and weights (sum 2) of the integration through the thickness.
  /// Three points of either rule integrate elastic bending exactly.
  struct ThicknessPoints
  {
    unsigned int          n = 0;
    std::array<double, 7> position{}, weight{};
  };

  /// Gauss (interior) or Lobatto (faces included); 3, 5 or 7 points, else throws InputError.
  ThicknessPoints make_thickness_points(ThicknessRule rule, unsigned int n_points);
} // namespace birdstrike
