#pragma once

#include <cstddef>
#include <set>
#include <vector>

/// Which nodes may move at once, so that each force tells by whose motion it is: columns of a stiffness by few moves.
namespace birdstrike::test
{
  using NodeSets   = std::vector<std::set<std::size_t>>;
  using NodeGroups = std::vector<std::vector<std::size_t>>;

  /// Of each node those that share a cell with it, itself included.
  template <typename Cells>
  NodeSets find_neighbors(const std::size_t n_nodes, const Cells &cells)
  {
    NodeSets neighbors(n_nodes);
    for (const auto &cell : cells)
      for (const auto node : cell)
        neighbors[node].insert(cell.begin(), cell.end());
    return neighbors;
  }

  /// No two nodes of a group have a neighbour in common; in the order of the nodes, each into the first that takes it.
  NodeGroups find_groups(const NodeSets &neighbors);
} // namespace birdstrike::test
