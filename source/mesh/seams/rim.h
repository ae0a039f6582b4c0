#pragma once

#include <birdstrike/core/number.h>

#include <deal.II/grid/tria.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace birdstrike
{
  /// The boundary of a mesh in plain arrays: edges of shells with one element, faces of bricks with one. Nodes are the
  /// vertices of the triangulation.
  struct Rim
  {
    struct Side
    {
      std::array<std::uint32_t, 4> nodes; ///< round a face; of an edge both ends, and again the second
      std::array<std::uint32_t, 8> of_cell;
      std::uint32_t                cell;
      double                       size;   ///< m, smallest height or edge of the cell
      Point3                       inward; ///< unit: in the shell, square to the edge; of a face minus its normal
    };

    template <int dim>
    explicit Rim(const dealii::Triangulation<dim, 3> &triangulation);

    std::span<const std::uint32_t> sides_at(const std::uint32_t node) const
    {
      return {side_of.data() + begin[node], begin[node + 1] - begin[node]};
    }
    bool is_of_cell(std::uint32_t node, const Side &side) const;
    /// Smallest of the cells with a side at a node, m.
    double size_at(std::uint32_t node) const;
    /// Most that a curved edge may bow out of its chord along the normal of the shell, m: of an edge that turns by
    /// phi this is L phi/8; twice that, for normals at the ends of a mesh know one side only. Of bricks 0.
    double bow(const Side &side) const;

    unsigned int        n_corners; ///< of a side
    std::vector<Point3> x;         ///< m
    std::vector<Side>   sides;
    std::vector<Point3> normal; ///< per node of a shell, unit, of either sign

  private:
    void sort_sides();

    std::vector<std::uint32_t> begin, side_of;
  };
} // namespace birdstrike
