#pragma once

#include <birdstrike/contact/candidate_block.h>
#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/thread_pool.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// Forces on nodes, first summed within each block, then by each node over the blocks that know it, in their order:
  /// no locks, and the same sums whoever does them.
  class NodeSums
  {
  public:
    using Force = std::array<double, 4>; ///< N, three components and an unused one: a whole register

    /// Adopts the blocks' nodes; to be called when the lists are new.
    void set_nodes(const std::vector<CandidateBlock> &blocks, std::size_t n_nodes);

    /// The sums of one block, by its numbers.
    Force *of(const CandidateBlock &block)
    {
      return &sums[block.first_node];
    }

    void add_to(const FacetsView &facets, ThreadPool &pool) const;

  private:
    std::vector<Force>         sums;           // of all blocks, one after the other
    std::vector<std::uint32_t> nodes;          // those that any block knows
    std::vector<std::uint32_t> first, entries; // [nodes + 1]; places in `sums`
    std::vector<std::uint32_t> place;          // [n_nodes] in `nodes`
  };
} // namespace birdstrike
