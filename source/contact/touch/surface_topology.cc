#include "contact/touch/edge_profile.h"
#include <birdstrike/contact/surface_topology.h>

#include <algorithm>

namespace birdstrike
{
  SurfaceTopology::Change SurfaceTopology::update(const FacetsView &facets)
  {
    const bool is_same_surface = facets.n_nodes == rim_node.size();
    if (is_same_surface && facets.revision == revision && facets.n_facets == pieces.size())
      return Change::none;
    revision = facets.revision;
    find_rim(facets);
    find_pieces(facets, is_same_surface);
    update_thickness(facets);
    return is_same_surface ? Change::facets : Change::surface;
  }

  void SurfaceTopology::find_rim(const FacetsView &facets)
  {
    rim_node.assign(facets.n_nodes, 0);
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      for (unsigned int k = 0; k < 4; ++k)
        if (facets.neighbor[f][k] == FacetsView::free_edge && is_edge(facets.nodes[f], k))
          rim_node[facets.nodes[f][k]] = rim_node[facets.nodes[f][(k + 1) % 4]] = 1;
  }

  void SurfaceTopology::find_pieces(const FacetsView &facets, const bool is_same_surface)
  {
    pieces.assign(facets.n_facets, -1);
    if (!is_same_surface)
      piece_of_node.assign(facets.n_nodes, -1);
    std::int32_t n_pieces = 0;
    for (const std::int32_t piece : piece_of_node)
      n_pieces = std::max(n_pieces, piece + 1);

    std::vector<std::uint32_t> front;
    for (std::uint32_t f = 0; f < facets.n_facets; ++f)
      {
        // most of its nodes know: two pieces may have a corner in common
        long most = 0;
        for (const std::uint32_t node : facets.nodes[f])
          {
            const std::int32_t piece = piece_of_node[node];
            const long         count = std::count_if(facets.nodes[f].begin(), facets.nodes[f].end(),
                                                     [&](const std::uint32_t n) { return piece_of_node[n] == piece; });
            if (piece >= 0 && count > most)
              {
                pieces[f] = piece;
                most      = count;
              }
          }
        if (pieces[f] >= 0)
          front.push_back(f);
      }
    spread_pieces(facets, front);
    for (std::uint32_t seed = 0; seed < facets.n_facets; ++seed)
      if (pieces[seed] < 0)
        {
          pieces[seed] = n_pieces++;
          front.push_back(seed);
          spread_pieces(facets, front);
        }
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      for (const std::uint32_t node : facets.nodes[f])
        piece_of_node[node] = pieces[f];
  }

  void SurfaceTopology::spread_pieces(const FacetsView &facets, std::vector<std::uint32_t> &front)
  {
    while (!front.empty())
      {
        const std::uint32_t f = front.back();
        front.pop_back();
        for (unsigned int k = 0; k < 4; ++k)
          if (const std::int32_t g = facets.neighbor[f][k]; g >= 0 && pieces[g] < 0)
            {
              pieces[g] = pieces[f];
              front.push_back(static_cast<std::uint32_t>(g));
            }
      }
  }

  void SurfaceTopology::update_thickness(const FacetsView &facets)
  {
    nodal_half_thickness.assign(facets.n_nodes, 0.);
    n_facets_of_node.assign(facets.n_nodes, 0);
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      for (unsigned int k = 0; k < 4; ++k)
        {
          nodal_half_thickness[facets.nodes[f][k]] += facets.half_thickness[f];
          ++n_facets_of_node[facets.nodes[f][k]];
        }
    for (std::size_t n = 0; n < facets.n_nodes; ++n)
      if (n_facets_of_node[n] > 0)
        nodal_half_thickness[n] /= n_facets_of_node[n];
    largest_half_thickness =
      nodal_half_thickness.empty() ? 0. : *std::max_element(nodal_half_thickness.begin(), nodal_half_thickness.end());
  }

  void SurfaceTopology::update_slowly(const FacetsView &facets, const double size)
  {
    update_thickness(facets);
    edges.update(facets, edge_reach(size));
  }

  bool SurfaceTopology::is_on_rim(const FacetsView &facets, const std::uint32_t facet,
                                  const std::array<double, 4> &weights) const
  {
    unsigned int n_zero = 0, corner = 0;
    for (unsigned int k = 0; k < 4; ++k)
      if (weights[k] == 0.)
        ++n_zero;
      else
        corner = k;
    const auto &nodes = facets.nodes[facet];
    if (n_zero < 2)
      return false;
    if (n_zero == 3)
      return rim_node[nodes[corner]];
    for (unsigned int k = 0; k < 4; ++k)
      if (weights[k] > 0. && weights[(k + 1) % 4] > 0.)
        return is_edge(nodes, k) ? facets.neighbor[facet][k] == FacetsView::free_edge : rim_node[nodes[k]];
    return false;
  }
} // namespace birdstrike
