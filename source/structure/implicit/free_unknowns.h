#pragma once

#include <birdstrike/core/number.h>

#include <cstdint>
#include <span>
#include <vector>

namespace birdstrike
{
  /// An unknown of implicit equations: the displacement (m) of a node along an axis, or its rotation (rad) about one.
  struct FreeUnknown
  {
    std::uint32_t node;
    bool          is_rotation;
    Point3        axis;
  };

  /// What moves, node after node, displacements before rotations. Nodes of solids have three unknowns, of shells five:
  /// rotations about the director d have neither stiffness nor effect (no drilling), so those of a node are about two
  /// axes across it. Of rotations of which some are held, what is left is taken whole unless d lies in it.
  class FreeUnknowns
  {
  public:
    /// `is_held` [n_nodes][n_unknowns]; directors [n_nodes] of shells, none of solids.
    FreeUnknowns(const std::vector<bool> &is_held, std::size_t n_nodes, std::span<const Point3> directors);

    std::size_t size() const
    {
      return all.size();
    }
    std::size_t n_nodes() const
    {
      return first.size() - 1;
    }
    const FreeUnknown &operator[](const std::size_t k) const
    {
      return all[k];
    }
    /// [begin, end) of the displacements, or of the rotations, of a node.
    std::pair<std::size_t, std::size_t> of(const std::uint32_t node, const bool rotations) const
    {
      return rotations ? std::pair(first_rotation[node], first[node + 1])
                       : std::pair(first[node], first_rotation[node]);
    }

    /// Nodal values [n_nodes][n_unknowns] of values of the unknowns, and the transpose: forces on the unknowns.
    void expand(std::span<const double> values, std::vector<double> &nodal) const;
    void restrict(std::span<const double> nodal, std::vector<double> &forces) const;

  private:
    unsigned int             n_unknowns;
    std::vector<FreeUnknown> all;
    std::vector<std::size_t> first, first_rotation; ///< [n_nodes + 1], [n_nodes]
  };
} // namespace birdstrike
