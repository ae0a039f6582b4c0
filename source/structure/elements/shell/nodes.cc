#include "structure/elements/shell/nodes.h"
#include "structure/elements/element_group.h"
#include <birdstrike/core/simd/registers.h>

#include <birdstrike/core/simd/inverse_root.h>
#include <birdstrike/core/simd/records.h>

#include <algorithm>
#include <cstring>
#include <functional>

namespace birdstrike
{
  namespace
  {
    /// Of three coordinates; the fourth component means nothing.
    [[gnu::always_inline]] inline Four cross(const Four &a, const Four &b)
    {
      const Four a_yzx = __builtin_shufflevector(a, a, 1, 2, 0, 3), a_zxy = __builtin_shufflevector(a, a, 2, 0, 1, 3);
      const Four b_yzx = __builtin_shufflevector(b, b, 1, 2, 0, 3), b_zxy = __builtin_shufflevector(b, b, 2, 0, 1, 3);
      return a_yzx * b_zxy - a_zxy * b_yzx;
    }

    void set_director(ShellRecord &record, const Point3 &sum)
    {
      const double square = sum.squaredNorm();
      const Point3 unit   = sum * (square > 0. ? inverse_root(square) : 0.);
      for (int c = 0; c < 3; ++c)
        record.normal[c] = record.midpoint_normal[c] = unit[c];
    }
  } // namespace

  ShellNodes::ShellNodes(const std::vector<Point3> &points, const std::vector<Cell> &cells, const ElementBlocks &blocks,
                         ThreadPool &pool)
    : n_nodes(points.size())
    , records(points.size() + 4, ShellRecord{})
    , pool(pool)
    , entering(blocks.entering.begin(), blocks.entering.end())
    , sums(points.size(), Point3::Zero())
  {
    for (const auto &cell : cells)
      for (std::uint32_t i = 0; i < 4; ++i)
        {
          const Point3 &x = points[cell[i]];
          sums[cell[i]] += (points[cell[(i + 1) % 4]] - x).cross(points[cell[(i + 3) % 4]] - x);
        }
    for (std::size_t n = 0; n < n_nodes; ++n)
      {
        std::copy(points[n].data(), points[n].data() + 3, records[n].position);
        set_director(records[n], sums[n]);
      }
    for (std::size_t i = 0; i < 4; ++i)
      {
        ShellRecord &record = records[n_nodes + i];
        record.position[0]  = i == 1 || i == 2 ? 1. : 0.;
        record.position[1]  = i >= 2 ? 1. : 0.;
        record.normal[2] = record.midpoint_normal[2] = 1.;
      }
  }

  /// Up to n_lanes nodes.
  void ShellNodes::update_group(const std::uint32_t *group, const std::size_t n, const double *position,
                                const double *increment)
  {
    alignas(64) double square[n_lanes] = {};
    for (std::size_t k = 0; k < n; ++k)
      {
        const double *const r = increment + 6 * group[k] + 3;
        square[k]             = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
      }
    store(Lanes(1.) / (Lanes(1.) + 0.25 * load<Lanes>(square)), square);
    for (std::size_t k = 0; k < n; ++k)
      {
        const std::size_t node   = group[k];
        ShellRecord      &record = records[node];
        std::memcpy(record.position, position + 3 * node, sizeof record.position);
        std::memcpy(record.increment, increment + 6 * node, sizeof record.increment + sizeof record.rotation);
        // The fourth number of either means nothing. The rotation is read where it came from: a load of what two
        // shorter stores have just written to the record would wait until they have left the store buffer.
        Four uz_and_rotation, old;
        read(increment + 6 * node + 2, uz_and_rotation);
        read(record.normal, old);
        const Four rotation = __builtin_shufflevector(uz_and_rotation, uz_and_rotation, 1, 2, 3, 0);
        const Four once = cross(rotation, old), change = square[k] * (once + 0.5 * cross(rotation, once));
        write(old + 0.5 * change, record.midpoint_normal); // the fourth number is written over
        write(old + change, record.normal);
      }
  }

  void ShellNodes::update(const ElementBlocks::Block &block, const double *position, const double *increment)
  {
    const auto body = [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t k = begin; k < end; k += n_lanes)
        update_group(&entering[block.entering_begin + k], std::min(n_lanes, end - k), position, increment);
    };
    pool.parallel_for(block.entering_end - block.entering_begin, ElementBlocks::nodes_per_chunk, std::cref(body));
  }

  void ShellNodes::add_symmetry_plane(const std::span<const std::uint32_t> nodes, const Point3 &plane_normal)
  {
    const Point3 plane = plane_normal.normalized();
    for (const auto node : nodes)
      {
        Point3 &sum = sums.at(node);
        sum -= sum.dot(plane) * plane;
        set_director(records[node], sum);
      }
  }

  std::size_t ShellNodes::bytes() const
  {
    return bytes_of(records) + bytes_of(entering) + bytes_of(sums);
  }
} // namespace birdstrike
