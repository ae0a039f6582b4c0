#pragma once

#include "structure/elements/element_blocks.h"
#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/thread_pool.h>

#include <array>
#include <vector>

namespace birdstrike
{
  /// What a batch of shells needs of a node: two cache lines.
  struct alignas(64) ShellRecord
  {
    double position[3];        ///< at t^{n+1}, m
    double increment[3];       ///< displacement, m
    double rotation[3];        ///< increment, rad
    double midpoint_normal[3]; ///< mean of the normals at t^n and t^{n+1}
    double normal[3];          ///< averaged unit normal at t^{n+1}
    double unused = 0.;
  };

  /// The nodes of shells: their records, and the averaged normal of each, the normalised sum of those of its elements.
  class ShellNodes
  {
  public:
    using Cell = std::array<std::uint32_t, 4>;

    /// Positions (m) and cells, counter-clockwise about the positive normal.
    ShellNodes(const std::vector<Point3> &points, const std::vector<Cell> &cells, const ElementBlocks &blocks,
               ThreadPool &pool);

    /// Records of the nodes that enter with the block, from positions [n_nodes][3] and increments [n_nodes][6].
    void update(const ElementBlocks::Block &block, const double *position, const double *increment);

    /// The averaged normal of these stays in the plane.
    void add_symmetry_plane(std::span<const std::uint32_t> nodes, const Point3 &plane_normal);

    void take_out(const Cell &cell);    ///< what it was to the normals of its nodes becomes nothing
    void close(const double *position); ///< after all that have been taken out in a step

    /// Of one node, besides its position.
    void archive(Archive::Row &row, const std::size_t node)
    {
      row("normal", records[node].normal);
    }

    std::size_t bytes() const;

    std::size_t                n_nodes;
    AlignedVector<ShellRecord> records; ///< [n_nodes + 4]; the last four are a square of 1 m, at rest

  private:
    /// Two neighbours of a node within one element: (next - node) x (previous - node) is the normal there.
    struct Corner
    {
      std::uint32_t next, previous;
    };
    /// The normal of a node: (x_0 - x_1) x (x_2 - x_3), of four nodes, is the sum of the normals of its elements there
    /// where up to four of them close a ring or up to two a fan; other nodes, and those on planes of symmetry, have
    /// four times themselves here, and are summed over their corners.
    using Diagonals = std::array<std::uint32_t, 4>;
    struct EnteringNode
    {
      std::uint32_t node;
      Diagonals     diagonals;
    };

    void      build_corners(const std::vector<Cell> &cells);
    Diagonals find_diagonals(std::uint32_t node) const;
    void      list_irregular();
    void      update_group(const EnteringNode *nodes, std::size_t n, const double *position, const double *increment,
                           const double *last);
    void      update_irregular(std::size_t node, const double *position);
    Point3    compute_normal(std::size_t node, const double *position) const;

    ThreadPool                      &pool;
    std::vector<std::uint32_t>       corner_begin; ///< [n_nodes + 1]
    std::vector<Corner>              corners;
    std::vector<EnteringNode>        entering;    ///< by block
    std::vector<std::uint32_t>       entering_of; ///< [n_nodes], where a node is in that list
    std::vector<std::uint32_t>       irregular;   ///< which of those that enter have no diagonals
    std::vector<std::vector<Point3>> symmetry;    ///< [n_nodes], normals of symmetry planes; empty without any
    std::vector<std::uint32_t>       bared;       ///< nodes of cells that have been taken out in this step
  };
} // namespace birdstrike
