#include <birdstrike/core/simd/registers.h>

#include "structure/elements/shell/implementation.h"

#include <algorithm>
#include <cstring>
#include <functional>

namespace birdstrike
{
  namespace
  {
    /// Differences a and b of three coordinates; the fourth component means nothing.
    [[gnu::always_inline]] inline void cross(const Four &a, const Four &b, double *result)
    {
      const Four a_yzx = __builtin_shufflevector(a, a, 1, 2, 0, 3), a_zxy = __builtin_shufflevector(a, a, 2, 0, 1, 3);
      const Four b_yzx = __builtin_shufflevector(b, b, 1, 2, 0, 3), b_zxy = __builtin_shufflevector(b, b, 2, 0, 1, 3);
      write(a_yzx * b_zxy - a_zxy * b_yzx, result);
    }
  } // namespace

  Point3 ShellElements::Implementation::compute_normal(const std::size_t node, const double *position) const
  {
    const auto   point  = [position](const std::size_t n) { return Point3(position + 3 * n); };
    const Point3 x      = point(node);
    Point3       normal = Point3::Zero();
    for (std::size_t k = corner_begin[node]; k < corner_begin[node + 1]; ++k)
      normal += (point(corners[k].next) - x).cross(point(corners[k].previous) - x);
    if (!symmetry.empty())
      for (const Point3 &plane : symmetry[node])
        normal -= normal.dot(plane) * plane;
    const double square = normal.squaredNorm();
    return normal * (square > 0. ? inverse_root(square) : 0.);
  }

  void ShellElements::Implementation::update_irregular(const std::size_t node, const double *position)
  {
    // the diagonals are nothing: so far the new normal is zero, and the mean half of the old one
    const Point3 normal = compute_normal(node, position);
    for (int c = 0; c < 3; ++c)
      {
        records[node].normal[c] = normal[c];
        records[node].midpoint_normal[c] += 0.5 * normal[c];
      }
  }

  /// Up to n_lanes nodes. `last`: four numbers, the position of the last node, so that four can be read of every node.
  void ShellElements::Implementation::update_group(const EnteringNode *nodes, const std::size_t n,
                                                   const double *position, const double *increment, const double *last)
  {
    alignas(64) double normal[n_lanes][4], square[n_lanes];
    const auto         point = [&](const std::uint32_t node, Four &x) {
      read(node + 1 == n_nodes ? last : position + 3 * node, x);
    };
    for (std::size_t k = 0; k < n_lanes; ++k)
      {
        const Diagonals &d = nodes[std::min(k, n - 1)].diagonals;
        Four             x[4];
        for (int i = 0; i < 4; ++i)
          point(d[i], x[i]);
        cross(x[0] - x[1], x[2] - x[3], normal[k]);
        square[k] = normal[k][0] * normal[k][0] + normal[k][1] * normal[k][1] + normal[k][2] * normal[k][2];
      }
    const Lanes s = load<Lanes>(square);
    store(select(s > Lanes(0.), inverse_root(s), Lanes(0.)), square);
    for (std::size_t k = 0; k < n; ++k)
      {
        const std::size_t node   = nodes[k].node;
        NodeRecord       &record = records[node];
        std::memcpy(record.position, position + 3 * node, sizeof record.position);
        std::memcpy(record.increment, increment + 6 * node, sizeof record.increment + sizeof record.rotation);
        Four unit, old;
        read(normal[k], unit);
        read(record.normal, old);
        unit *= square[k];
        write(0.5 * (old + unit), record.midpoint_normal); // the fourth number is written over
        write(unit, record.normal);
      }
  }

  void ShellElements::Implementation::update_nodes(const Block &block, const double *position, const double *increment)
  {
    const double *const tail    = position + 3 * (n_nodes - 1);
    const double        last[4] = {tail[0], tail[1], tail[2], 0.};
    const auto          body    = [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t k = begin; k < end; k += n_lanes)
        update_group(&entering[block.entering_begin + k], std::min(n_lanes, end - k), position, increment, last);
      const auto first = std::lower_bound(irregular.begin(), irregular.end(), block.entering_begin + begin);
      for (auto k = first; k != irregular.end() && *k < block.entering_begin + end; ++k)
        update_irregular(entering[*k].node, position);
    };
    pool.parallel_for(block.entering_end - block.entering_begin, nodes_per_chunk, std::cref(body));
  }

  void ShellElements::Implementation::gather_forces(const Block &block, double *force)
  {
    const std::size_t n    = block.leaving_end - block.leaving_begin;
    const auto        body = [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t chunk = begin; chunk < end; ++chunk)
        {
          Eight work_of_chunk;
          read(work[block.work_begin + chunk].value, work_of_chunk);
          for (std::size_t i = chunk * nodes_per_chunk; i < std::min(n, (chunk + 1) * nodes_per_chunk); ++i)
            {
              const auto [node, first, n_corners] = leaving[block.leaving_begin + i];
              Eight f{}, row, old, u;
              for (std::size_t k = first; k < first + n_corners; ++k)
                {
                  read(corner_force[k].value, row);
                  f += row;
                }
              read(node_force[node].value, old);
              read(records[node].increment, u); // and rotation; what follows meets zeros
              work_of_chunk += 0.5 * (old + f) * u;
              write(f, node_force[node].value);
              f = -f;
              std::memcpy(force + 6 * node, &f, 6 * sizeof(double));
            }
          write(work_of_chunk, work[block.work_begin + chunk].value);
        }
    };
    pool.parallel_for((n + nodes_per_chunk - 1) / nodes_per_chunk, 1, std::cref(body));
  }
} // namespace birdstrike
