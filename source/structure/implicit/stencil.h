#pragma once

#include "structure/implicit/free_unknowns.h"

#include <cstdint>
#include <span>
#include <vector>

namespace birdstrike
{
  /// Lists of nodes by node.
  struct NodeLists
  {
    std::vector<std::size_t>   begin; ///< [n + 1]
    std::vector<std::uint32_t> nodes;

    std::span<const std::uint32_t> of(const std::size_t n) const
    {
      return {nodes.data() + begin[n], begin[n + 1] - begin[n]};
    }
  };

  /// Nodes that share a cell with a node, itself among them, ascending; cells of n_corners nodes, one after the other.
  NodeLists find_neighbours(std::span<const std::uint32_t> cells, std::size_t n_corners, std::size_t n_nodes);
  /// A colour for each node, so that no two of one colour reach the same node (Curtis, Powell & Reid 1974): columns of
  /// a matrix that are found by one difference.
  std::vector<std::uint32_t> find_colours(const NodeLists &reach);

  /// A sparse square matrix by rows, columns ascending.
  struct SparseRows
  {
    std::vector<std::size_t>   begin; ///< [n + 1]
    std::vector<std::uint32_t> column;
    std::vector<double>        value;

    std::size_t size() const
    {
      return begin.size() - 1;
    }
    /// Where in its row a column is that is stored.
    std::size_t place(std::size_t row, std::uint32_t column_number) const;
    double     &at(const std::size_t row, const std::uint32_t column_number)
    {
      return value[begin[row] + place(row, column_number)];
    }
    double      find(std::size_t row, std::uint32_t column_number) const; ///< zero where nothing is stored
    std::size_t n_not_zero(std::size_t row) const;
    /// Takes the symmetric part, where the pattern is symmetric; returns |K - K^T| over |K| (Frobenius).
    double make_symmetric();
  };

  /// Zeros where forces on an unknown may depend on another.
  SparseRows make_pattern(const FreeUnknowns &unknowns, const NodeLists &reach);
} // namespace birdstrike
