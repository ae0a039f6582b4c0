#pragma once

#include <birdstrike/contact/sharp_edges.h>
#include <birdstrike/core/contact_views.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// What contact needs to know of a surface besides its positions: rim, connected pieces, thickness at nodes.
  ///
  /// Facets that come and go on the same nodes (failed elements) leave the surface what it is: what hung together at
  /// first counts as one piece for good, so that points remember their sides of it; a facet that appears belongs to the
  /// piece of its nodes or neighbours.
  class SurfaceTopology
  {
  public:
    enum class Change
    {
      none,
      facets, ///< others on the same nodes
      surface ///< other nodes
    };

    /// Recomputes everything if the facets are others than before.
    Change update(const FacetsView &facets);
    void   update_thickness(const FacetsView &facets);

    /// What changes slowly: thickness, and the sharp edges for points up to `size` = V^(1/3), m.
    void update_slowly(const FacetsView &facets, double size);

    void archive(Archive &archive);

    const SharpEdges &sharp_edges() const
    {
      return edges;
    }

    /// Whether the closest point with these weights lies on a free edge or at a node of one.
    bool is_on_rim(const FacetsView &facets, std::uint32_t facet, const std::array<double, 4> &weights) const;

    bool is_on_rim(const std::uint32_t node) const ///< of a free edge
    {
      return rim_node[node] != 0;
    }

    /// Number of the connected piece of surface; sides are remembered piece by piece.
    std::int32_t piece(const std::uint32_t facet) const
    {
      return pieces[facet];
    }

    /// Half thickness at a node, mean over its facets: interpolated, it is continuous where facets differ. m
    double half_thickness(const std::uint32_t node) const
    {
      return nodal_half_thickness[node];
    }
    double max_half_thickness() const
    {
      return largest_half_thickness;
    }

  private:
    void find_rim(const FacetsView &facets);
    void find_pieces(const FacetsView &facets, bool is_same_surface);
    void spread_pieces(const FacetsView &facets, std::vector<std::uint32_t> &front);

    std::uint64_t              revision = 0;
    std::vector<std::int32_t>  pieces;        // [n_facets]
    std::vector<std::int32_t>  piece_of_node; // [n_nodes], -1: of none so far
    std::vector<unsigned char> rim_node;      // [n_nodes]
    std::vector<double>        nodal_half_thickness;
    std::vector<std::uint32_t> n_facets_of_node;
    double                     largest_half_thickness = 0.;
    SharpEdges                 edges;
  };

  /// Corner k of a triangular facet stands twice; its side between the two is no edge.
  inline bool is_edge(const std::array<std::uint32_t, 4> &nodes, const unsigned int side)
  {
    return nodes[side] != nodes[(side + 1) % 4];
  }
} // namespace birdstrike
