#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace birdstrike
{
  /// In which order a loop over elements takes nodes, and where the forces on the elements' corners go.
  ///
  /// Elements are taken in blocks of consecutive ones. A node enters with the first block that has an element of it and
  /// leaves with the last; from then on its rows, one for each of its corners side by side in the order of the
  /// elements, belong to others, so that records and rows stay in the cache.
  struct ElementBlocks
  {
    struct LeavingNode
    {
      std::uint32_t node, row, n_corners; ///< where its rows begin
    };
    /// Ranges of the lists below.
    struct Block
    {
      std::uint32_t element_begin, element_end, entering_begin, entering_end, leaving_begin, leaving_end;
    };

    /// `corners`: the nodes of the elements one after the other, n_corners of each.
    ElementBlocks(std::span<const std::uint32_t> corners, std::size_t n_corners, std::size_t n_nodes,
                  std::size_t elements_per_block);

    std::size_t bytes() const;

    std::vector<Block>         blocks;
    std::vector<std::uint32_t> entering;   ///< nodes, by block
    std::vector<LeavingNode>   leaving;    ///< by block
    std::vector<std::uint32_t> corner_row; ///< of every corner, as they came
    std::size_t                n_rows = 0;

  private:
    void assign_rows(const std::vector<std::uint32_t> &n_corners_of_node);
  };
} // namespace birdstrike
