#include "structure/surface/eroding_skin.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    bool has(const std::array<std::uint32_t, 4> &nodes, const std::uint32_t node)
    {
      return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
    }
  } // namespace

  ErodingSkin::ErodingSkin(const VolumeMesh &mesh) : mesh(mesh), half_thickness(mesh.skin.cells.size(), 0.)
  {
  }

  std::int32_t ErodingSkin::facet_across(const std::size_t first, const unsigned int first_face, const std::uint32_t a,
                                         const std::uint32_t b) const
  {
    std::size_t  cell = first;
    unsigned int face = first_face;
    while (true)
      {
        // the other face of this cell at the edge
        unsigned int other = 0;
        while (other == face || !has(mesh.side_nodes(cell, other), a) || !has(mesh.side_nodes(cell, other), b))
          ++other;
        if (number[cell][other] >= 0)
          return number[cell][other];
        const std::int32_t next = mesh.neighbors[cell][other];
        if (next == FacetsView::symmetry_edge)
          return FacetsView::symmetry_edge;
        const auto from = static_cast<std::int32_t>(cell);
        cell            = static_cast<std::size_t>(next);
        const auto back = std::find(mesh.neighbors[cell].begin(), mesh.neighbors[cell].end(), from);
        face            = static_cast<unsigned int>(back - mesh.neighbors[cell].begin());
      }
  }

  void ErodingSkin::remove(const FunctionRef<bool(std::size_t)> is_gone)
  {
    number.assign(mesh.cells.size(), {{-1, -1, -1, -1, -1, -1}});
    facets.clear();
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int face = 0; face < 6 && !is_gone(cell); ++face)
        if (const std::int32_t other = mesh.neighbors[cell][face];
            other == FacetsView::free_edge || (other >= 0 && is_gone(static_cast<std::size_t>(other))))
          {
            number[cell][face] = static_cast<std::int32_t>(facets.size());
            facets.push_back(mesh.side_nodes(cell, face));
          }
    neighbors.resize(facets.size());
    half_thickness.assign(facets.size(), 0.);
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int face = 0; face < 6; ++face)
        if (const std::int32_t f = number[cell][face]; f >= 0)
          for (unsigned int k = 0; k < 4; ++k)
            neighbors[static_cast<std::size_t>(f)][k] = facet_across(cell, face, facets[static_cast<std::size_t>(f)][k],
                                                                     facets[static_cast<std::size_t>(f)][(k + 1) % 4]);
    ++revision;
  }

  void ErodingSkin::offer(FacetsView &view) const
  {
    const bool is_whole = revision == 0;
    view.n_facets       = is_whole ? mesh.skin.cells.size() : facets.size();
    view.nodes          = is_whole ? mesh.skin.cells.data() : facets.data();
    view.neighbor       = is_whole ? mesh.skin.neighbors.data() : neighbors.data();
    view.half_thickness = half_thickness.data();
    view.two_sided      = false;
    view.revision       = revision;
  }
} // namespace birdstrike
