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
    double midpoint_normal[3]; ///< mean of the directors at t^n and t^{n+1}
    double normal[3];          ///< unit director at t^{n+1}
    double unused = 0.;
  };

  /// The nodes of shells: their records, and the director of each. At rest it is the averaged normal, the normalised
  /// sum of those of the node's elements; then it turns with the node. Of a step's rotation increment theta, taken as a
  /// Cayley (Rodrigues) vector, n^{n+1} - n^n = theta x (n^n + n^{n+1})/2 to round-off, which is what strain increments
  /// at the midpoint count (Hughes & Winget 1980). A director that followed the positions instead would leave bending
  /// moments a tangent that is not symmetric, on which short waves of elements as thick as long grow by flutter.
  class ShellNodes
  {
  public:
    using Cell = std::array<std::uint32_t, 4>;

    /// Positions (m) and cells, counter-clockwise about the positive normal.
    ShellNodes(const std::vector<Point3> &points, const std::vector<Cell> &cells, const ElementBlocks &blocks,
               ThreadPool &pool);

    /// Records of the nodes that enter with the block, from positions [n_nodes][3] and increments [n_nodes][6].
    void update(const ElementBlocks::Block &block, const double *position, const double *increment);

    /// The directors of these are in the plane, before the first step.
    void add_symmetry_plane(std::span<const std::uint32_t> nodes, const Point3 &plane_normal);

    /// Of one node, besides its position.
    void archive(Archive::Row &row, const std::size_t node)
    {
      row("normal", records[node].normal);
    }

    std::size_t bytes() const;

    std::size_t                n_nodes;
    AlignedVector<ShellRecord> records; ///< [n_nodes + 4]; the last four are a square of 1 m, at rest

  private:
    void update_group(const std::uint32_t *group, std::size_t n, const double *position, const double *increment);

    ThreadPool                &pool;
    std::vector<std::uint32_t> entering; ///< nodes by block
    std::vector<Point3>        sums;     ///< [n_nodes], of the area vectors of a node's elements at rest, m^2
  };
} // namespace birdstrike
