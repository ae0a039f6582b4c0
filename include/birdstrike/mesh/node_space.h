#pragma once

#include <cstdint>
#include <memory>

namespace dealii
{
  class IndexSet;
  namespace Utilities::MPI
  {
    class Partitioner;
  }
} // namespace dealii

namespace birdstrike
{
  /// The nodes that one process knows of a mesh that may be shared by several: its own, [0, n_owned), in the order of
  /// their global numbers, then ghosts, [n_owned, size), of which it reads positions and velocities and adds up
  /// nothing. A process has every cell that touches one of its nodes: forces on them are complete without an exchange.
  ///
  /// Global numbers are those of the vertices' DoFs over the unknowns of a node; each process owns a contiguous range.
  class NodeSpace
  {
  public:
    NodeSpace() = default; ///< of no nodes

    /// `owned` and `ghosts` are subsets of all nodes, `owned` one range.
    NodeSpace(const dealii::IndexSet &owned, const dealii::IndexSet &ghosts);

    std::uint32_t n_owned() const;
    std::uint32_t size() const;
    bool          is_whole() const; ///< every node is owned

    bool is_owned(const std::uint32_t node) const
    {
      return node < n_owned();
    }
    std::uint32_t global(std::uint32_t node) const;
    std::uint32_t local(std::uint32_t global) const; ///< of an owned node or a ghost
    bool          has(std::uint32_t global) const;

    /// For vectors of n unknowns a node, unknown c of node k at n k + c.
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> unknowns(unsigned int n) const;

  private:
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> nodes;
  };
} // namespace birdstrike
