#include <birdstrike/blade/shell_implementation.h>

#include <algorithm>
#include <iterator>
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

  ShellElements::Implementation::Diagonals ShellElements::Implementation::find_diagonals(const std::uint32_t n) const
  {
    std::vector<Corner> rest; // but those of failed elements, see take_out
    std::copy_if(corners.begin() + corner_begin[n], corners.begin() + corner_begin[n + 1], std::back_inserter(rest),
                 [n](const Corner &c) { return c.next != n; });
    // the polygon around the node: from `next` to `previous` of one element after the other
    std::vector<std::uint32_t> polygon;
    const auto                 starts = [&](const std::uint32_t node) {
      return std::none_of(rest.begin(), rest.end(), [node](const Corner &c) { return c.previous == node; });
    };
    for (const Corner &c : rest)
      if (polygon.empty() && starts(c.next))
        polygon = {n, c.next};
    const bool is_fan = !polygon.empty();
    if (!is_fan && !rest.empty())
      polygon = {rest[0].next};
    while (!rest.empty())
      {
        const auto found =
          std::find_if(rest.begin(), rest.end(), [&](const Corner &c) { return c.next == polygon.back(); });
        if (found == rest.end())
          break;
        polygon.push_back(found->previous);
        rest.erase(found);
      }
    if (!is_fan && !polygon.empty())
      polygon.pop_back(); // back at its beginning
    if (polygon.size() == 3)
      polygon.push_back(polygon.back());
    if (!rest.empty() || polygon.size() != 4)
      return {n, n, n, n};
    return {polygon[0], polygon[2], polygon[1], polygon[3]};
  }

  void ShellElements::Implementation::list_irregular()
  {
    irregular.clear();
    for (std::uint32_t k = 0; k < entering.size(); ++k)
      if (entering[k].diagonals[0] == entering[k].diagonals[1])
        irregular.push_back(k);
  }

  void ShellElements::Implementation::build_blocks()
  {
    constexpr std::size_t chunk    = batches_per_chunk * n_lanes; // elements
    const std::size_t     n_blocks = (cells.size() + elements_per_block - 1) / elements_per_block;
    static_assert(elements_per_block % chunk == 0, "a block has whole chunks");
    std::vector<std::uint32_t> first(n_nodes, 0), last(n_nodes, 0), first_begin, last_begin;
    for (std::size_t e = cells.size(); e-- > 0;)
      for (const auto n : cells[e])
        first[n] = e / elements_per_block;
    for (std::size_t e = 0; e < cells.size(); ++e)
      for (const auto n : cells[e])
        last[n] = e / elements_per_block;
    for (const auto n : sort_by_block(first, n_blocks, first_begin))
      entering.push_back({n, find_diagonals(n)});
    for (const auto n : sort_by_block(last, n_blocks, last_begin))
      leaving.push_back({n, 0, corner_begin[n + 1] - corner_begin[n]});
    const auto    n_chunks = std::uint32_t((cells.size() + chunk - 1) / chunk);
    std::uint32_t n_sums   = 0;
    for (std::uint32_t b = 0; b < n_blocks; ++b)
      {
        const auto per_block = std::uint32_t(elements_per_block / chunk);
        blocks.push_back({b * per_block, std::min(n_chunks, (b + 1) * per_block), first_begin[b], first_begin[b + 1],
                          last_begin[b], last_begin[b + 1], n_sums});
        n_sums += (last_begin[b + 1] - last_begin[b] + nodes_per_chunk - 1) / nodes_per_chunk;
      }
    work.assign(n_sums, Row{});
    list_irregular();
  }

  std::vector<std::uint32_t> ShellElements::Implementation::assign_rows()
  {
    std::map<std::uint32_t, std::vector<std::uint32_t>> vacant; // rows that were left, by number of corners
    std::vector<std::uint32_t>                          row_begin(n_nodes, 0);
    std::uint32_t                                       n_rows = 0;
    for (const Block &block : blocks)
      {
        for (auto k = block.entering_begin; k < block.entering_end; ++k)
          {
            const std::uint32_t n = entering[k].node, n_corners = corner_begin[n + 1] - corner_begin[n];
            auto               &of_size = vacant[n_corners];
            row_begin[n]                = of_size.empty() ? n_rows : of_size.back();
            if (of_size.empty())
              n_rows += n_corners;
            else
              of_size.pop_back();
          }
        for (auto k = block.leaving_end; k-- > block.leaving_begin;)
          {
            leaving[k].row = row_begin[leaving[k].node];
            vacant[leaving[k].n_corners].push_back(leaving[k].row);
          }
      }
    corner_force.assign(n_rows + 1, Row{}); // the last one takes what copies of the last element write
    return row_begin;
  }
} // namespace birdstrike
