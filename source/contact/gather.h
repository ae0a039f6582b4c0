#pragma once

#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/number.h>

#include <cstdint>

namespace birdstrike
{
  /// values[index[k]] for the lanes k of one register.
  inline Lanes gather(const double *values, const std::uint32_t *index)
  {
    return Lanes([&](const auto k) { return values[index[k]]; });
  }

  /// The positions of n_lanes points, by their indices, m.
  inline Vector3<Lanes> gather_points(const PointsView &points, const std::uint32_t *point)
  {
    return {gather(points.position[0], point), gather(points.position[1], point), gather(points.position[2], point)};
  }
} // namespace birdstrike
