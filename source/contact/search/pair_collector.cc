#include "contact/search/pair_collector.h"
#include <birdstrike/core/simd/compress.h>

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t points_together = 16;
    constexpr std::size_t max_cells       = 32; // about as many as a compact handful of points meets
  }                                             // namespace

  void PairCollector::collect(const PointsView &points, const FacetGrid &grid, const double reach,
                              CandidateBlock &block)
  {
    n_pairs = 0;
    seen.resize(std::max(seen.size(), grid.n_facets()), 0);
    for (std::size_t i = block.begin; i < block.end; i += points_together)
      collect_range(points, grid, reach, block, {i, std::min(block.end, i + points_together)});
    const auto end = static_cast<std::ptrdiff_t>(n_pairs);
    block.pair_near.assign(near.begin(), near.begin() + end);
    block.pair_facet.assign(facet.begin(), facet.begin() + end);
    block.pair_bound.assign(bound.begin(), bound.begin() + end);
  }

  void PairCollector::collect_range(const PointsView &points, const FacetGrid &grid, const double reach,
                                    CandidateBlock &block, const std::array<std::size_t, 2> range)
  {
    Box box;
    for (std::size_t i = range[0]; i < range[1]; ++i)
      if (const Point3 p(points.position[0][i], points.position[1][i], points.position[2][i]); grid.box().contains(p))
        box.add(p.data());
    if (box.is_empty())
      return;
    if (range[1] - range[0] > 1 && grid.count_cells(box) > max_cells)
      {
        const std::size_t middle = (range[0] + range[1]) / 2;
        collect_range(points, grid, reach, block, {range[0], middle});
        collect_range(points, grid, reach, block, {middle, range[1]});
        return;
      }
    choose_facets(grid, box);
    if (n_chosen > 0)
      for (std::size_t i = range[0]; i < range[1]; ++i)
        test_point(points, i, reach, block);
  }

  void PairCollector::choose_facets(const FacetGrid &grid, const Box &box)
  {
    ++n_choices;
    chosen.clear();
    grid.visit_near(box, [&](const std::uint32_t f) {
      if (seen[f] == n_choices)
        return;
      seen[f] = n_choices;
      if (grid.box(f).separation(box) <= 0.)
        chosen.push_back(f);
    });
    n_chosen = chosen.size();
    chosen.resize(n_chosen + n_lanes, 0);
    for (unsigned int d = 0; d < 3; ++d)
      {
        low[d].resize(std::max(low[d].size(), n_chosen + n_lanes));
        high[d].resize(low[d].size());
        for (std::size_t k = 0; k < n_chosen; ++k)
          {
            low[d][k]  = grid.box(chosen[k]).low[d];
            high[d][k] = grid.box(chosen[k]).high[d];
          }
        std::fill_n(low[d].begin() + static_cast<std::ptrdiff_t>(n_chosen), n_lanes, 1e300); // out of any reach
      }
  }

  void PairCollector::test_point(const PointsView &points, const std::size_t i, const double reach,
                                 CandidateBlock &block)
  {
    const std::size_t before = n_pairs;
    const double      limit  = reach * (1. + 1e-12); // a hair larger: rounding must not lose what is at reach
    const auto        number = static_cast<std::uint32_t>(block.points.size());
    if (near.size() < n_pairs + n_chosen + n_lanes)
      {
        const std::size_t n = 2 * (n_pairs + n_chosen + n_lanes);
        near.resize(n);
        facet.resize(n);
        bound.resize(n);
      }
    for (std::size_t b = 0; b < n_chosen; b += n_lanes)
      {
        Lanes squared(0.); // distance to the facet's own box
        for (unsigned int d = 0; d < 3; ++d)
          {
            const Lanes p(points.position[d][i]);
            const Lanes outside =
              max(Lanes(0.), max(load<Lanes>(&low[d][b]) - p, p - load<Lanes>(&high[d][b])) + reach);
            squared += outside * outside;
          }
        const std::uint32_t bits = to_bits(squared < limit * limit);
        compress_lanes(LaneNumbers<Lanes>(&chosen[b], stdx::element_aligned), bits, &facet[n_pairs]);
        n_pairs += compress_lanes(squared, bits, &bound[n_pairs]);
      }
    for (std::size_t k = before; k < n_pairs; k += n_lanes) // of the few that are left
      Lanes(sqrt(Lanes(&bound[k], stdx::element_aligned))).copy_to(&bound[k], stdx::element_aligned);
    std::fill(near.begin() + static_cast<std::ptrdiff_t>(before), near.begin() + static_cast<std::ptrdiff_t>(n_pairs),
              number);
    if (n_pairs > before)
      block.points.push_back(static_cast<std::uint32_t>(i));
  }
} // namespace birdstrike
