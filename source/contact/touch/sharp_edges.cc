#include "contact/touch/edge_frame.h"
#include <birdstrike/contact/sharp_edges.h>
#include <birdstrike/contact/surface_topology.h>

#include <cmath>
#include <utility>

// Which edges are sharp, and which facets are near them.
namespace birdstrike
{
  namespace
  {
    constexpr double watched = 0.5 * blunt_ridge; // from here on their angle is looked at in every step
  }

  void SharpEdges::update(const FacetsView &facets, const double reach)
  {
    if (facets.two_sided && facets.revision == revision && reach == known_reach && first.size() == facets.n_facets + 1)
      return;
    revision    = facets.revision;
    known_reach = reach;
    find_edges(facets);
    spread(facets, 1.25 * reach); // facets stretch by a few per cent, and fail before they stretch by a quarter
  }

  void SharpEdges::find_edges(const FacetsView &facets)
  {
    edges.clear();
    normals.clear();
    if (!facets.two_sided)
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        normals.push_back(compute_area_vector(facet_nodes(facets, f)).normalized());
    for (std::uint32_t f = 0; f < facets.n_facets; ++f)
      for (unsigned int k = 0; k < 4; ++k)
        if (is_edge(facets.nodes[f], k))
          {
            const std::int32_t g = facets.neighbor[f][k];
            if (g == FacetsView::free_edge)
              edges.push_back(
                {{{facets.nodes[f][k], facets.nodes[f][(k + 1) % 4]}}, {{static_cast<std::int32_t>(f), -1}}});
            else if (!facets.two_sided && g > static_cast<std::int32_t>(f))
              add_ridge(facets, f, k);
          }
  }

  void SharpEdges::add_ridge(const FacetsView &facets, const std::uint32_t f, const unsigned int k)
  {
    const std::int32_t                 g = facets.neighbor[f][k];
    const std::array<std::uint32_t, 2> nodes{{facets.nodes[f][k], facets.nodes[f][(k + 1) % 4]}};
    const double                       cosine = normals[f].dot(normals[static_cast<std::size_t>(g)]);
    if (cosine > std::cos(watched))
      return;
    const Edge   edge{nodes, {{static_cast<std::int32_t>(f), g}}};
    const Point3 a = node_at(facets, nodes[0]), b = node_at(facets, nodes[1]);
    // seen from both facets alike, whichever comes first
    if (edge_frame(facets, edge.facets[0], a, b).normal.dot(edge_frame(facets, g, b, a).outward) > 0.) // not hollow
      edges.push_back(edge);
  }

  void SharpEdges::spread(const FacetsView &facets, const double reach)
  {
    found.clear();
    seen.assign(facets.n_facets, 0);
    for (std::uint32_t e = 0; e < edges.size(); ++e)
      {
        const Point3 a = node_at(facets, edges[e].nodes[0]), b = node_at(facets, edges[e].nodes[1]);
        const auto   is_near = [&](const std::size_t f) {
          const auto x = facet_nodes(facets, f);
          for (const Point3 &p : x)
            if ((p - closest_on_segment(p, a, b)).squaredNorm() < reach * reach)
              return true;
          for (const Point3 &p : {a, b, Point3(0.5 * (a + b))})
            if (compute_closest_point(p, x).distance_squared < reach * reach)
              return true;
          return false;
        };
        for (const std::int32_t facet : edges[e].facets)
          if (facet >= 0)
            front.push_back(facet);
        while (!front.empty())
          {
            const auto f = static_cast<std::uint32_t>(front.back());
            front.pop_back();
            if (seen[f] == e + 1 || !is_near(f))
              continue;
            seen[f] = e + 1;
            found.push_back({{f, e}});
            for (const std::int32_t g : facets.neighbor[f])
              if (g >= 0 && seen[static_cast<std::size_t>(g)] != e + 1)
                front.push_back(g);
          }
      }
    std::sort(found.begin(), found.end());
    first.assign(facets.n_facets + 1, 0);
    near.clear();
    for (const auto &[facet, edge] : found)
      {
        ++first[facet + 1];
        near.push_back(edge);
      }
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      first[f + 1] += first[f];
  }

  void SharpEdges::find_facets_at_edges(const std::vector<std::uint32_t> &facets,
                                        std::vector<std::uint32_t>       &found_facets) const
  {
    found_facets.clear();
    for (const std::uint32_t facet : facets)
      if (are_near(facet))
        found_facets.push_back(facet);
    const auto drop_equals = [&found_facets] {
      std::sort(found_facets.begin(), found_facets.end());
      found_facets.erase(std::unique(found_facets.begin(), found_facets.end()), found_facets.end());
    };
    drop_equals();
    const std::vector<std::uint32_t> of_pairs = std::move(found_facets);
    found_facets.clear();
    for (const std::uint32_t facet : of_pairs)
      for (std::uint32_t n = first[facet]; n < first[facet + 1]; ++n)
        for (const std::int32_t at_edge : edges[near[n]].facets)
          if (at_edge >= 0)
            found_facets.push_back(static_cast<std::uint32_t>(at_edge));
    drop_equals();
  }
} // namespace birdstrike
