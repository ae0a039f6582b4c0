#include "contact/search/pair_collector.h"
#include <birdstrike/contact/search.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t points_per_block = 256; // the near ones' records and results fit in the first-level cache
  }                                               // namespace

  void CandidateSearch::forget()
  {
    is_known = false;
  }

  std::size_t CandidateSearch::n_pairs() const
  {
    std::size_t n = 0;
    for (const CandidateBlock &block : all_blocks)
      n += block.n_pairs();
    return n;
  }

  void CandidateSearch::update(const PointsView &points, const FacetsView &facets, const double range,
                               const double margin, ThreadPool &pool, const SharpEdges *const edges)
  {
    const bool is_same = is_of(points, facets);
    if (!is_same)
      set_blocks(points, facets);
    watch(points, facets, pool);
    path += last_motion;
    if (is_same && closest_away() > range + 0.5 * margin && path + last_motion <= margin)
      {
        ++(is_tracking ? n_calls.reused : n_calls.apart);
        return;
      }

    is_known      = true;
    is_tracking   = false;
    path          = 0.;
    n_near_points = 0;
    for (CandidateBlock &block : all_blocks)
      {
        block.is_tracked = surface.separation(block.box) <= range + 1.5 * margin;
        is_tracking |= block.is_tracked;
        if (!block.is_tracked)
          std::fill(block.point_motions_squared.begin(), block.point_motions_squared.end(), 0.);
      }
    ++(is_tracking ? n_calls.searches : n_calls.apart);
    if (is_tracking)
      find_pairs(points, facets, range + margin, pool, edges);
  }

  bool CandidateSearch::is_of(const PointsView &points, const FacetsView &facets) const
  {
    return is_known && points.revision == points_revision && facets.revision == facets_revision &&
           points.n == old_points[0].size() && 3 * facets.n_nodes == old_nodes.size() && facets.n_facets == n_facets;
  }

  void CandidateSearch::set_blocks(const PointsView &points, const FacetsView &facets)
  {
    const bool has_other_facets =
      !is_known || facets.revision != facets_revision || facets.n_facets != n_facets || node_parts.empty();
    points_revision = points.revision;
    facets_revision = facets.revision;
    n_facets        = facets.n_facets;
    for (auto &component : old_points)
      component.resize(points.n);
    old_nodes.resize(3 * facets.n_nodes);
    all_blocks.resize((points.n + points_per_block - 1) / points_per_block);
    for (std::size_t b = 0; b < all_blocks.size(); ++b)
      {
        all_blocks[b].begin      = b * points_per_block;
        all_blocks[b].end        = std::min(points.n, (b + 1) * points_per_block);
        all_blocks[b].is_tracked = false;
        all_blocks[b].point_motions_squared.assign(all_blocks[b].end - all_blocks[b].begin, 0.);
      }
    if (has_other_facets)
      set_node_parts(facets);
    is_tracking = false;
  }

  double CandidateSearch::closest_away() const
  {
    double smallest = 1e300;
    for (const CandidateBlock &block : all_blocks)
      if (!block.is_tracked)
        smallest = std::min(smallest, surface.separation(block.box));
    return smallest;
  }

  void CandidateSearch::find_pairs(const PointsView &points, const FacetsView &facets, const double reach,
                                   ThreadPool &pool, const SharpEdges *const edges)
  {
    Box region;
    for (const CandidateBlock &block : all_blocks)
      if (block.is_tracked)
        region.add(block.box);
    grid.update(facets, reach, region);
    std::copy(facets.position, facets.position + old_nodes.size(), old_nodes.begin());
    const auto collect_blocks = [&](const std::size_t begin, const std::size_t end) {
      static thread_local PairCollector              collector;
      static thread_local std::vector<std::uint32_t> beside;
      for (std::size_t b = begin; b < end; ++b)
        {
          CandidateBlock &block = all_blocks[b];
          block.clear();
          if (!block.is_tracked)
            continue;
          for (unsigned int d = 0; d < 3; ++d)
            std::copy(points.position[d] + block.begin, points.position[d] + block.end,
                      old_points[d].begin() + static_cast<std::ptrdiff_t>(block.begin));
          collector.collect(points, grid, reach, block);
          beside.clear();
          if (edges)
            edges->find_facets_at_edges(block.pair_facet, beside);
          block.number_surface(facets, beside);
          block.find_speed(points, facets);
        }
    };
    pool.parallel_for(all_blocks.size(), 1, std::ref(collect_blocks));
    count_near();
  }

  void CandidateSearch::count_near()
  {
    n_near_points       = 0;
    std::size_t n_nodes = 0;
    for (CandidateBlock &block : all_blocks)
      {
        block.first_node = n_nodes;
        n_nodes += block.nodes.keys().size();
        n_near_points += block.points.size();
      }
  }
} // namespace birdstrike
