#pragma once

#include <birdstrike/core/contact_views.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace birdstrike
{
  /// Numbers the pieces of a mesh that hang together across sides, in the order of their first cells: of each cell its
  /// piece. `neighbors(cell)`: a range of the cells across its sides, negative where there is none.
  template <class Neighbors>
  std::vector<std::uint32_t> number_pieces(const std::size_t n_cells, const Neighbors &neighbors)
  {
    constexpr auto             none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> piece(n_cells, none);
    std::vector<std::size_t>   reached;
    std::uint32_t              n_pieces = 0;
    for (std::size_t first = 0; first < n_cells; ++first)
      {
        if (piece[first] != none)
          continue;
        piece[first] = n_pieces;
        reached      = {first};
        while (!reached.empty())
          {
            const std::size_t cell = reached.back();
            reached.pop_back();
            for (const auto other : neighbors(cell))
              if (other >= 0 && piece[static_cast<std::size_t>(other)] == none)
                {
                  piece[static_cast<std::size_t>(other)] = n_pieces;
                  reached.push_back(static_cast<std::size_t>(other));
                }
          }
        ++n_pieces;
      }
    return piece;
  }

  /// Of each facet: one piece, or a row of blades of which piece 0 is the one that is described.
  inline std::vector<std::uint32_t> pieces_of(const FacetsView &surface)
  {
    return number_pieces(
      surface.n_facets, [&](const std::size_t facet) -> const auto & { return surface.neighbor[facet]; });
  }
} // namespace birdstrike
