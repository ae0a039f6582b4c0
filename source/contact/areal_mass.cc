#include "contact/areal_mass.h"
#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/core/closest_point.h>
#include <birdstrike/core/contact_views.h>

#include <algorithm>

namespace birdstrike
{
  AlignedVector<double> compute_areal_flexibility(const FacetsView &facets, const double point_size)
  {
    AlignedVector<double> result(facets.n_nodes, 0.); // areas first
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      {
        const double quarter = 0.25 * compute_area_vector(facet_nodes(facets, f)).norm();
        for (const std::uint32_t node : facets.nodes[f]) // the last of a triangle twice: its shares are uneven
          result[node] += quarter;
      }
    AlignedVector<double> least(facets.n_nodes, point_size * point_size);
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      for (unsigned int k = 0; k < 4; ++k)
        if (facets.neighbor[f][k] == FacetsView::symmetry_edge)
          for (const unsigned int end : {k, (k + 1) % 4})
            least[facets.nodes[f][end]] = 0.5 * point_size * point_size;
    for (std::size_t n = 0; n < facets.n_nodes; ++n)
      result[n] = std::max(result[n], least[n]) * facets.inverse_mass[n];
    return result;
  }
} // namespace birdstrike
