#include "mesh/seams/rim_chain.h"
#include <birdstrike/mesh/open_seams.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double chain_within = 0.1; ///< of an edge, see find_seams
  }

  RimEdges::RimEdges(const Rim &rim) : begin(rim.x.size() + 1, 0)
  {
    for (const Rim::Side &side : rim.sides)
      for (unsigned int k = 0; k + (rim.n_corners == 2) < rim.n_corners; ++k)
        {
          const std::uint32_t a = side.nodes[k], b = side.nodes[(k + 1) % rim.n_corners];
          all.push_back({a, b});
          all.push_back({b, a});
        }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (const auto &[from, to] : all)
      ++begin[from + 1];
    for (std::size_t n = 1; n < begin.size(); ++n)
      begin[n] += begin[n - 1];
  }

  RimChain::RimChain(const Rim &rim, const RimEdges &edges, const Rim::Side &side, const std::uint32_t first,
                     const std::uint32_t last)
    : rim(rim), edges(edges), side(side), first(first), last(last), edge(rim.x[last] - rim.x[first])
  {
  }

  std::vector<std::uint32_t> RimChain::nodes() const
  {
    std::vector<std::uint32_t> way;
    double                     share = 0.;
    for (std::uint32_t node = first; node != last; way.push_back(node))
      {
        const auto next = next_of(node, share);
        if (!next)
          return {};
        node = *next;
        if (node == last)
          break;
        share = share_of(node);
      }
    return way;
  }

  double RimChain::share_of(const std::uint32_t node) const
  {
    return (rim.x[node] - rim.x[first]).dot(edge) / edge.squaredNorm();
  }

  double RimChain::distance_of(const std::uint32_t node) const
  {
    return (rim.x[node] - rim.x[first] - share_of(node) * edge).norm();
  }

  bool RimChain::may_follow(const std::uint32_t node, const double share) const
  {
    const double here = share_of(node);
    if (here <= share || here < OpenSeams::near || here > 1. - OpenSeams::near ||
        distance_of(node) > chain_within * edge.norm() || rim.is_of_cell(node, side))
      return false;
    return std::ranges::none_of(rim.sides_at(node), [&](const std::uint32_t s) {
      return rim.is_of_cell(first, rim.sides[s]) && rim.is_of_cell(last, rim.sides[s]);
    });
  }

  std::optional<std::uint32_t> RimChain::next_of(const std::uint32_t node, const double share) const
  {
    std::optional<std::uint32_t> best;
    double                       nearest = INFINITY;
    edges.for_neighbours(node, [&](const std::uint32_t other) {
      const bool is_end = other == last && node != first;
      if (!is_end && !may_follow(other, share))
        return;
      if (const double d = is_end ? -1. : distance_of(other); d < nearest)
        {
          nearest = d;
          best    = other;
        }
    });
    return best;
  }
} // namespace birdstrike
