#include "structure/implicit/stencil.h"

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    void append_sorted(std::vector<std::uint32_t> &list, NodeLists &lists)
    {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      lists.nodes.insert(lists.nodes.end(), list.begin(), list.end());
      lists.begin.push_back(lists.nodes.size());
      list.clear();
    }
  } // namespace

  NodeLists find_neighbours(const std::span<const std::uint32_t> cells, const std::size_t n_corners,
                            const std::size_t n_nodes)
  {
    std::vector<std::vector<std::uint32_t>> of_node(n_nodes);
    for (std::size_t c = 0; c < cells.size(); c += n_corners)
      for (std::size_t i = 0; i < n_corners; ++i)
        of_node[cells[c + i]].insert(of_node[cells[c + i]].end(), cells.begin() + c, cells.begin() + c + n_corners);
    NodeLists lists{{0}, {}};
    for (auto &list : of_node)
      append_sorted(list, lists);
    return lists;
  }

  std::vector<std::uint32_t> find_colours(const NodeLists &reach)
  {
    constexpr std::uint32_t    none = -1;
    const std::size_t          n    = reach.begin.size() - 1;
    std::vector<std::uint32_t> colour(n, none), taken_by;
    for (std::uint32_t node = 0; node < n; ++node)
      {
        for (const std::uint32_t reached : reach.of(node))
          for (const std::uint32_t other : reach.of(reached))
            if (colour[other] != none)
              taken_by[colour[other]] = node;
        std::uint32_t free = 0;
        while (free < taken_by.size() && taken_by[free] == node)
          ++free;
        if (free == taken_by.size())
          taken_by.push_back(none);
        colour[node] = free;
      }
    return colour;
  }

  std::size_t SparseRows::place(const std::size_t row, const std::uint32_t column_number) const
  {
    const auto first = column.begin() + begin[row];
    return std::lower_bound(first, column.begin() + begin[row + 1], column_number) - first;
  }

  double SparseRows::find(const std::size_t row, const std::uint32_t column_number) const
  {
    const auto first = column.begin() + begin[row], last = column.begin() + begin[row + 1];
    const auto found = std::lower_bound(first, last, column_number);
    return found != last && *found == column_number ? value[found - column.begin()] : 0.;
  }

  std::size_t SparseRows::n_not_zero(const std::size_t row) const
  {
    return begin[row + 1] - begin[row] - std::count(value.begin() + begin[row], value.begin() + begin[row + 1], 0.);
  }

  double SparseRows::make_symmetric()
  {
    double difference = 0., norm = 0.;
    for (std::size_t row = 0; row < size(); ++row)
      for (std::size_t e = begin[row]; e < begin[row + 1]; ++e)
        {
          norm += value[e] * value[e];
          if (column[e] <= row)
            continue;
          double &mirrored = at(column[e], static_cast<std::uint32_t>(row));
          difference += 2. * (value[e] - mirrored) * (value[e] - mirrored);
          value[e] = mirrored = 0.5 * (value[e] + mirrored);
        }
    return std::sqrt(difference / norm);
  }

  SparseRows make_pattern(const FreeUnknowns &unknowns, const NodeLists &reach)
  {
    SparseRows                 rows{{0}, {}, {}};
    std::vector<std::uint32_t> columns;
    for (std::uint32_t node = 0; node < unknowns.n_nodes(); ++node)
      {
        columns.clear();
        for (const std::uint32_t other : reach.of(node))
          for (const bool is_rotation : {false, true})
            for (auto [k, end] = unknowns.of(other, is_rotation); k < end; ++k)
              columns.push_back(k);
        std::sort(columns.begin(), columns.end());
        const std::size_t n_rows = unknowns.of(node, true).second - unknowns.of(node, false).first;
        for (std::size_t row = 0; row < n_rows; ++row)
          {
            rows.column.insert(rows.column.end(), columns.begin(), columns.end());
            rows.begin.push_back(rows.column.size());
          }
      }
    rows.value.assign(rows.column.size(), 0.);
    return rows;
  }
} // namespace birdstrike
