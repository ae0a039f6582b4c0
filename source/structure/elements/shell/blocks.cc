#include "structure/elements/shell/implementation.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace birdstrike
{
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

  std::vector<std::uint32_t> ShellElements::Implementation::build_blocks()
  {
    constexpr std::size_t chunk = batches_per_chunk * n_lanes; // elements
    static_assert(elements_per_block % chunk == 0, "a block has whole chunks");
    ElementBlocks order({cells[0].data(), 4 * cells.size()}, 4, n_nodes, elements_per_block);
    for (const auto n : order.entering)
      entering.push_back({n, find_diagonals(n)});
    leaving              = std::move(order.leaving);
    std::uint32_t n_sums = 0;
    for (const auto &block : order.blocks)
      {
        blocks.push_back({std::uint32_t(block.element_begin / chunk),
                          std::uint32_t((block.element_end + chunk - 1) / chunk), block.entering_begin,
                          block.entering_end, block.leaving_begin, block.leaving_end, n_sums});
        n_sums += (block.leaving_end - block.leaving_begin + nodes_per_chunk - 1) / nodes_per_chunk;
      }
    work.assign(n_sums, Row{});
    corner_force.assign(order.n_rows + 1, Row{}); // the last one takes what copies of the last element write
    list_irregular();
    return std::move(order.corner_row);
  }
} // namespace birdstrike
