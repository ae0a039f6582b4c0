#include "structure/elements/solid/nodes.h"

#include <cstring>
#include <functional>

namespace birdstrike
{
  SolidNodes::SolidNodes(const std::vector<Point3> &points, const std::vector<Cell> &, const ElementBlocks &blocks,
                         ThreadPool &pool)
    : records(points.size() + 8, SolidRecord{}), entering(blocks.entering.data()), pool(pool)
  {
    for (std::size_t n = 0; n < points.size(); ++n)
      std::memcpy(records[n].position, points[n].data(), sizeof records[n].position);
    for (std::size_t i = 0; i < 8; ++i)
      for (int d = 0; d < 3; ++d)
        records[points.size() + i].position[d] = (i >> d & 1u) != 0 ? 1. : 0.;
  }

  void SolidNodes::update(const ElementBlocks::Block &block, const double *position, const double *increment)
  {
    const auto body = [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t k = block.entering_begin + begin; k < block.entering_begin + end; ++k)
        {
          const std::size_t node = entering[k];
          std::memcpy(records[node].position, position + 3 * node, 3 * sizeof(double));
          std::memcpy(records[node].increment, increment + 3 * node, 3 * sizeof(double));
        }
    };
    pool.parallel_for(block.entering_end - block.entering_begin, ElementBlocks::nodes_per_chunk, std::cref(body));
  }
} // namespace birdstrike
