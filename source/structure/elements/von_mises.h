#pragma once

#include <birdstrike/material/radial_return.h>

#include <algorithm>
#include <array>

namespace birdstrike
{
  /// Von Mises stress (Pa) of a stress as reports hold it: xx, yy, zz, xy, yz, zx.
  inline double von_mises(const std::array<double, 6> &stress)
  {
    double s[6];
    std::copy(stress.begin(), stress.end(), s);
    return von_mises(s);
  }
} // namespace birdstrike
