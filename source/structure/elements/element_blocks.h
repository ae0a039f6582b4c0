#pragma once

#include <birdstrike/core/number.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace birdstrike
{
  /// In which order a loop over elements takes nodes, and where the forces on the elements' corners go.
  ///
  /// Elements are taken in batches of n_lanes, these in chunks (of one thread each), these in blocks of some thousand
  /// elements. A node enters with the first block that has an element of it and leaves with the last; from then on its
  /// rows, one for each of its corners side by side in the order of the elements, belong to others, so that records and
  /// rows stay in the cache.
  struct ElementBlocks
  {
    static constexpr std::size_t batches_per_chunk = 16, chunks_per_block = 512 / n_lanes, nodes_per_chunk = 512;

    struct LeavingNode
    {
      std::uint32_t node, row, n_corners; ///< where its rows begin
    };
    /// Ranges of chunks and of the lists below; where the sums over chunks of leaving nodes begin.
    struct Block
    {
      std::uint32_t chunk_begin, chunk_end, entering_begin, entering_end, leaving_begin, leaving_end, sum_begin;

      std::size_t number() const
      {
        return chunk_begin / chunks_per_block;
      }
    };

    /// `corners`: the nodes of the elements one after the other, as many of each; `chunk` of every element.
    ElementBlocks(std::span<const std::uint32_t> corners, std::span<const std::uint32_t> chunk, std::size_t n_nodes);

    std::size_t bytes() const;

    std::vector<Block>         blocks;
    std::vector<std::uint32_t> entering;   ///< nodes, by block
    std::vector<LeavingNode>   leaving;    ///< by block
    std::vector<std::uint32_t> corner_row; ///< of every corner, as they came
    std::size_t                n_rows = 0;
    std::size_t                n_sums = 0; ///< chunks of leaving nodes

  private:
    void assign_rows(const std::vector<std::uint32_t> &n_corners_of_node);
  };
} // namespace birdstrike
