#pragma once

#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/number.h>

#include <array>
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

  /// The nodes of n_lanes facets, m.
  inline std::array<Vector3<Lanes>, 4> gather_facets(const FacetsView &facets, const std::uint32_t *facet)
  {
    std::array<Vector3<Lanes>, 4> x;
    for (unsigned int k = 0; k < 4; ++k)
      {
        std::uint32_t entry[n_lanes];
        for (std::size_t j = 0; j < n_lanes; ++j)
          entry[j] = 3 * facets.nodes[facet[j]][k];
        for (unsigned int d = 0; d < 3; ++d)
          x[k][d] = gather(facets.position + d, entry);
      }
    return x;
  }
} // namespace birdstrike
