#include <birdstrike/contact/pair_collector.h>
#include <birdstrike/core/number.h>

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
    seen.resize(std::max(seen.size(), grid.n_facets()), 0);
    for (std::size_t i = block.begin; i < block.end; i += points_together)
      collect_range(points, grid, reach, block, {i, std::min(block.end, i + points_together)});
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
    while (chosen.size() % n_lanes != 0)
      chosen.push_back(chosen.back());
    for (unsigned int d = 0; d < 3; ++d)
      {
        low[d].resize(std::max(low[d].size(), chosen.size()));
        high[d].resize(low[d].size());
        for (std::size_t k = 0; k < chosen.size(); ++k)
          {
            low[d][k]  = grid.box(chosen[k]).low[d];
            high[d][k] = grid.box(chosen[k]).high[d];
          }
      }
  }

  void PairCollector::test_point(const PointsView &points, const std::size_t i, const double reach,
                                 CandidateBlock &block) const
  {
    const std::size_t before = block.n_pairs();
    const auto        near   = static_cast<std::uint32_t>(block.points.size());
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
        if (!any(squared <= Lanes(reach * reach)))
          continue;
        alignas(64) std::array<double, n_lanes> distance;
        store(sqrt(squared), distance.data());
        for (std::size_t k = 0; k < n_lanes && b + k < n_chosen; ++k)
          if (distance[k] <= reach)
            {
              block.pair_near.push_back(near);
              block.pair_facet.push_back(chosen[b + k]);
              block.pair_bound.push_back(distance[k]);
            }
      }
    if (block.n_pairs() > before)
      block.points.push_back(static_cast<std::uint32_t>(i));
  }
} // namespace birdstrike
