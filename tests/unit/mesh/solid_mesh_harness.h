#pragma once

#include <birdstrike/core/contact_views.h>
#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/structure/parameters.h>

#include <gtest/gtest.h>

namespace birdstrike::solid_mesh_harness
{
  using Ids = std::vector<unsigned int>;

  inline BladeParameters plate(const unsigned int n_span, const unsigned int n_chord, const unsigned int n_layers)
  {
    BladeParameters p;
    p.mesh.n_span   = n_span;
    p.mesh.n_chord  = n_chord;
    p.mesh.n_layers = n_layers;
    return p;
  }

  /// Each side of each facet meets its neighbour in the opposite direction; returns how many are cut by the plane.
  inline unsigned int expect_closed(const SurfaceMesh &skin)
  {
    unsigned int n_cut = 0;
    for (std::size_t f = 0; f < skin.cells.size(); ++f)
      for (unsigned int k = 0; k < 4; ++k)
        {
          const std::int32_t other = skin.neighbors[f][k];
          EXPECT_NE(other, FacetsView::free_edge);
          n_cut += other == FacetsView::symmetry_edge;
          if (other < 0)
            continue;
          bool meets = false;
          for (unsigned int j = 0; j < 4; ++j)
            meets =
              meets || (skin.neighbors[other][j] == int(f) && skin.cells[other][j] == skin.cells[f][(k + 1) % 4] &&
                        skin.cells[other][(j + 1) % 4] == skin.cells[f][k]);
          EXPECT_TRUE(meets) << "facet " << f << " side " << k;
        }
    return n_cut;
  }
} // namespace birdstrike::solid_mesh_harness
