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
  /// What touches give to nodes, first summed within each block, then by each node over the blocks that know it, in
  /// their order: no locks, and the same sums whoever does them.
  ///
  /// Two sums a step: the weights of all touches at a node, which the law needs to share its mass
  /// (compute_reduced_mass), and then forces with the stiffness behind them.
  class NodeSums
  {
  public:
    /// Force, N, three components, and the stiffness of the touches times their weights, N/m: a whole register.
    using Sum = std::array<double, 4>;

    /// Largest over all nodes: sum of stiffness over mass, 1/s^2, and at which node.
    struct Largest
    {
      double        value = 0.;
      std::uint32_t node  = 0;
    };

    /// Adopts the blocks' nodes; to be called when the lists are new.
    void set_nodes(const std::vector<CandidateBlock> &blocks, std::size_t n_nodes);

    void clear(const CandidateBlock &block);

    /// The sums of one block, by its numbers.
    Sum *of(const CandidateBlock &block)
    {
      return &sums[block.first_node];
    }
    /// First the weights that the block adds, after share_masses() S_k/m_k, 1/kg.
    double *mobility_of(const CandidateBlock &block)
    {
      return &mobilities[block.first_node];
    }

    /// Adds the sums of the weights, [n_nodes].
    void add_weights(std::vector<double> &weights) const;

    /// `weights`: the sums of all contacts on this surface; none: there is this one only.
    void share_masses(const FacetsView &facets, ThreadPool &pool, const std::vector<double> *weights = nullptr);

    /// Adds the forces; stiffness over mass of the same nodes.
    Largest add_to(const NodeForces &forces, const FacetsView &facets, ThreadPool &pool) const;

  private:
    double sum_weights(std::size_t n) const; // of a node, by its place

    std::vector<Sum>             sums;           // of all blocks, one after the other
    std::vector<double>          mobilities;     // likewise
    std::vector<std::uint32_t>   nodes;          // those that any block knows
    std::vector<std::uint32_t>   first, entries; // [nodes + 1]; places in `sums`
    std::vector<std::uint32_t>   place;          // [n_nodes] in `nodes`
    mutable std::vector<Largest> largest;        // of chunks of nodes
  };
} // namespace birdstrike
