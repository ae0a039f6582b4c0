#include "contact/touch_records.h"
#include "contact/couple.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    /// What a couple changes in the relative velocity and in the forces on the nodes.
    void add_spin(const FacetsView &facets, const bool has_friction, TouchRecord &touch)
    {
      const Couple couple(facets, has_friction, touch);
      touch.velocity -= couple.velocity(facets);
      const Point3 normal = touch.normal.normalized();
      touch.loads         = couple.loads(normal);
      if (!has_friction)
        return;
      const auto along = couple.largest_loads_across(normal);
      for (unsigned int k = 0; k < 4; ++k)
        touch.loads[k] = std::max(touch.loads[k], along[k]);
    }

    /// Moves the place where the force acts from the closest point to the edge that carries it, and to one of the
    /// facets there.
    void move_to_edge(const PointsView &points, const FacetsView &facets, const EdgePlace &edge,
                      const std::uint32_t facet, TouchRecord &touch)
    {
      touch.facet    = facet;
      touch.offset   = edge.offset;
      touch.velocity = {points.velocity[0][touch.point], points.velocity[1][touch.point],
                        points.velocity[2][touch.point]};
      touch.weights  = {};
      for (unsigned int end = 0; end < 2; ++end)
        {
          const auto &nodes  = facets.nodes[facet];
          const auto  k      = std::find(nodes.begin(), nodes.end(), edge.nodes[end]) - nodes.begin();
          const auto  weight = end == 0 ? 1. - edge.share : edge.share;
          touch.weights[static_cast<std::size_t>(k)] = weight;
          touch.velocity -= weight * Point3(facets.velocity + edge.nodes[end] * facets.velocity_stride);
        }
    }

    /// The facets that carry a touch at an edge, by the block's numbers: the two of a ridge, each a half, as its plane
    /// turns by half of what each turns. None where the edge has become sharp since the last search.
    unsigned int find_carriers(const CandidateBlock &block, const EdgePlace &edge,
                               std::array<std::uint32_t, 2> &carriers)
    {
      unsigned int n = 0;
      for (const std::int32_t facet : edge.facets)
        if (facet >= 0)
          {
            carriers[n] = block.facets.find(static_cast<std::uint32_t>(facet));
            if (carriers[n++] == LocalNumbers::none)
              return 0;
          }
      return n;
    }
  } // namespace

  void record_touches(const NarrowPhase &narrow_phase, const CandidateBlock &block, const PointsView &points,
                      const FacetsView &facets, const bool has_friction, std::vector<TouchRecord> &touches)
  {
    const PairGeometry &pairs = narrow_phase.geometry();
    touches.clear();
    for (const TouchingPair &touch : narrow_phase.touches())
      {
        const std::uint32_t facet = block.pair_facet[pairs.pair[touch.place]];
        TouchRecord         record;
        record.normal       = touch.normal;
        record.velocity     = pairs.velocity_of(touch.place);
        record.offset       = pairs.offset_of(touch.place);
        record.lever        = record.offset;
        record.weights      = pairs.weights_of(touch.place);
        record.penetration  = touch.penetration;
        record.share        = touch.share;
        record.is_oblique   = touch.is_oblique;
        record.point        = block.points[touch.near];
        record.facet        = block.facets.keys()[facet];
        record.nodes        = block.facet_nodes[facet];
        const auto complete = [&] {
          record.loads = record.weights;
          if (has_friction || record.is_oblique)
            add_spin(facets, has_friction, record);
          touches.push_back(record);
        };
        std::array<std::uint32_t, 2> carriers;
        const unsigned int           n_carriers = find_carriers(block, touch.edge, carriers);
        record.share /= std::max(1u, n_carriers);
        for (unsigned int c = 0; c < n_carriers; ++c)
          {
            record.nodes = block.facet_nodes[carriers[c]];
            move_to_edge(points, facets, touch.edge, block.facets.keys()[carriers[c]], record);
            record.lever = record.offset + (c == 0 ? 1. : -1.) * touch.edge.opening;
            complete();
          }
        if (n_carriers == 0)
          complete();
      }
  }
} // namespace birdstrike
