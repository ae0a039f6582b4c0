#pragma once

#include "structure/elements/element_blocks.h"
#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/thread_pool.h>

#include <array>
#include <vector>

namespace birdstrike
{
  /// What a batch of bricks needs of a node: one cache line.
  struct alignas(64) SolidRecord
  {
    double position[3];  ///< at t^{n+1}, m
    double increment[3]; ///< m
    double unused[2];
  };

  /// The nodes of bricks: their records.
  struct SolidNodes
  {
    using Cell = std::array<std::uint32_t, 8>;

    SolidNodes(const std::vector<Point3> &points, const std::vector<Cell> &cells, const ElementBlocks &blocks,
               ThreadPool &pool);

    /// Records of the nodes that enter with the block, from positions and increments [n_nodes][3].
    void update(const ElementBlocks::Block &block, const double *position, const double *increment);

    void archive(Archive::Row &, std::size_t)
    {
    }

    std::size_t bytes() const
    {
      return records.capacity() * sizeof(SolidRecord);
    }

    AlignedVector<SolidRecord> records;  ///< [n_nodes + 8]; the last eight are a cube of 1 m, at rest
    const std::uint32_t       *entering; ///< nodes, by block
    ThreadPool                &pool;
  };
} // namespace birdstrike
