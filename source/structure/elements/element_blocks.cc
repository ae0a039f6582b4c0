#include "structure/elements/element_blocks.h"

#include <algorithm>
#include <map>

namespace birdstrike
{
  namespace
  {
    /// Nodes in the order of their blocks, and where each block begins.
    std::vector<std::uint32_t> sort_by_block(const std::vector<std::uint32_t> &block_of_node,
                                             const std::size_t n_blocks, std::vector<std::uint32_t> &begin)
    {
      begin.assign(n_blocks + 1, 0);
      for (const auto block : block_of_node)
        ++begin[block + 1];
      for (std::size_t b = 0; b < n_blocks; ++b)
        begin[b + 1] += begin[b];
      std::vector<std::uint32_t> nodes(block_of_node.size()), next(begin);
      for (std::uint32_t n = 0; n < nodes.size(); ++n)
        nodes[next[block_of_node[n]]++] = n;
      return nodes;
    }
  } // namespace

  ElementBlocks::ElementBlocks(const std::span<const std::uint32_t> corners, const std::span<const std::uint32_t> chunk,
                               const std::size_t n_nodes)
    : corner_row(corners.begin(), corners.end())
  {
    const std::size_t          n_corners = corners.size() / chunk.size();
    const std::uint32_t        n_chunks  = *std::max_element(chunk.begin(), chunk.end()) + 1;
    const std::size_t          n_blocks  = (n_chunks + chunks_per_block - 1) / chunks_per_block;
    std::vector<std::uint32_t> first(n_nodes, n_chunks), last(n_nodes, 0), count(n_nodes, 0), first_begin, last_begin;
    for (std::size_t c = 0; c < corners.size(); ++c)
      {
        const std::uint32_t block = chunk[c / n_corners] / chunks_per_block, n = corners[c];
        first[n] = std::min(first[n], block);
        last[n]  = std::max(last[n], block);
        ++count[n];
      }
    for (std::size_t n = 0; n < n_nodes; ++n)
      first[n] = count[n] > 0 ? first[n] : 0;
    entering = sort_by_block(first, n_blocks, first_begin);
    for (const auto n : sort_by_block(last, n_blocks, last_begin))
      leaving.push_back({n, 0, count[n]});
    for (std::uint32_t b = 0; b < n_blocks; ++b)
      {
        blocks.push_back({std::uint32_t(b * chunks_per_block),
                          std::uint32_t(std::min<std::size_t>(n_chunks, (b + 1) * chunks_per_block)), first_begin[b],
                          first_begin[b + 1], last_begin[b], last_begin[b + 1], std::uint32_t(n_sums)});
        n_sums += (last_begin[b + 1] - last_begin[b] + nodes_per_chunk - 1) / nodes_per_chunk;
      }
    assign_rows(count);
  }

  void ElementBlocks::assign_rows(const std::vector<std::uint32_t> &n_corners_of_node)
  {
    std::map<std::uint32_t, std::vector<std::uint32_t>> vacant; // rows that were left, by number of corners
    std::vector<std::uint32_t>                          next_row(n_corners_of_node.size(), 0);
    for (const Block &block : blocks)
      {
        for (auto k = block.entering_begin; k < block.entering_end; ++k)
          {
            const std::uint32_t n = entering[k], n_corners = n_corners_of_node[n];
            auto               &of_size = vacant[n_corners];
            next_row[n]                 = of_size.empty() ? n_rows : of_size.back();
            if (of_size.empty())
              n_rows += n_corners;
            else
              of_size.pop_back();
          }
        for (auto k = block.leaving_end; k-- > block.leaving_begin;)
          {
            leaving[k].row = next_row[leaving[k].node];
            vacant[leaving[k].n_corners].push_back(leaving[k].row);
          }
      }
    for (auto &corner : corner_row) // its node until here
      corner = next_row[corner]++;
  }

  std::size_t ElementBlocks::bytes() const
  {
    return blocks.capacity() * sizeof(Block) + leaving.capacity() * sizeof(LeavingNode) +
           (entering.capacity() + corner_row.capacity()) * sizeof(std::uint32_t);
  }
} // namespace birdstrike
