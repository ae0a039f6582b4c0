#pragma once

#include "mesh/seams/rim.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace birdstrike
{
  /// Boundary edges as neighbours of nodes: [n_nodes + 1] places in a sorted list.
  class RimEdges
  {
  public:
    explicit RimEdges(const Rim &rim);

    template <class Visit>
    void for_neighbours(const std::uint32_t node, const Visit &visit) const
    {
      for (std::uint32_t k = begin[node]; k < begin[node + 1]; ++k)
        visit(all[k][1]);
    }

  private:
    std::vector<std::array<std::uint32_t, 2>> all;
    std::vector<std::uint32_t>                begin;
  };

  /// The boundary from one end of a side's edge to the other, close beside it, over nodes that its cell does not
  /// have.
  class RimChain
  {
  public:
    RimChain(const Rim &rim, const RimEdges &edges, const Rim::Side &side, std::uint32_t first, std::uint32_t last);

    /// The nodes between, none where there is no such way.
    std::vector<std::uint32_t> nodes() const;

  private:
    const Rim          &rim;
    const RimEdges     &edges;
    const Rim::Side    &side;
    const std::uint32_t first, last;
    const Point3        edge;

    double share_of(std::uint32_t node) const;
    double distance_of(std::uint32_t node) const;
    /// Between the ends, beside the edge; of no face with both ends.
    bool may_follow(std::uint32_t node, double share) const;

    std::optional<std::uint32_t> next_of(std::uint32_t node, double share) const;
  };
} // namespace birdstrike
