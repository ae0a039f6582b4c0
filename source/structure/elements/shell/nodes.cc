#include "structure/elements/shell/nodes.h"
#include "structure/elements/element_group.h"
#include <birdstrike/core/simd/registers.h>

#include <birdstrike/core/simd/inverse_root.h>
#include <birdstrike/core/simd/records.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <iterator>

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

  ShellNodes::ShellNodes(const std::vector<Point3> &points, const std::vector<Cell> &cells, const ElementBlocks &blocks,
                         ThreadPool &pool)
    : n_nodes(points.size())
    , records(points.size() + 4, ShellRecord{})
    , pool(pool)
    , corner_begin(points.size() + 1, 0)
    , entering_of(points.size())
  {
    build_corners(cells);
    for (const auto n : blocks.entering)
      {
        entering_of[n] = entering.size();
        entering.push_back({n, find_diagonals(n)});
      }
    list_irregular();
    const std::vector<double> still(6 * n_nodes, 0.);
    for (const auto &block : blocks.blocks)
      update(block, points[0].data(), still.data());
    for (std::size_t i = 0; i < 4; ++i)
      {
        ShellRecord &record = records[n_nodes + i];
        record.position[0]  = i == 1 || i == 2 ? 1. : 0.;
        record.position[1]  = i >= 2 ? 1. : 0.;
        record.normal[2] = record.midpoint_normal[2] = 1.;
      }
  }

  void ShellNodes::build_corners(const std::vector<Cell> &cells)
  {
    for (const auto &cell : cells)
      for (const auto node : cell)
        ++corner_begin[node + 1];
    for (std::size_t n = 0; n < n_nodes; ++n)
      corner_begin[n + 1] += corner_begin[n];
    corners.resize(4 * cells.size());
    std::vector<std::uint32_t> next(corner_begin.begin(), corner_begin.end() - 1);
    for (const auto &cell : cells)
      for (std::uint32_t i = 0; i < 4; ++i)
        corners[next[cell[i]]++] = {cell[(i + 1) % 4], cell[(i + 3) % 4]};
  }

  ShellNodes::Diagonals ShellNodes::find_diagonals(const std::uint32_t n) const
  {
    std::vector<Corner> rest; // but those of failed elements, see take_out
    std::copy_if(corners.begin() + corner_begin[n], corners.begin() + corner_begin[n + 1], std::back_inserter(rest),
                 [n](const Corner &c) { return c.next != n; });
    // the polygon around the node: from `next` to `previous` of one element after the other
    std::vector<std::uint32_t> polygon;
    const auto                 starts = [&](const std::uint32_t node) {
      return std::none_of(rest.begin(), rest.end(), [node](const Corner &c) { return c.previous == node; });
    };
    for (const Corner &c : rest)
      if (polygon.empty() && starts(c.next))
        polygon = {n, c.next};
    const bool is_fan = !polygon.empty();
    if (!is_fan && !rest.empty())
      polygon = {rest[0].next};
    while (!rest.empty())
      {
        const auto found =
          std::find_if(rest.begin(), rest.end(), [&](const Corner &c) { return c.next == polygon.back(); });
        if (found == rest.end())
          break;
        polygon.push_back(found->previous);
        rest.erase(found);
      }
    if (!is_fan && !polygon.empty())
      polygon.pop_back(); // back at its beginning
    if (polygon.size() == 3)
      polygon.push_back(polygon.back());
    if (!rest.empty() || polygon.size() != 4)
      return {n, n, n, n};
    return {polygon[0], polygon[2], polygon[1], polygon[3]};
  }

  void ShellNodes::list_irregular()
  {
    irregular.clear();
    for (std::uint32_t k = 0; k < entering.size(); ++k)
      if (entering[k].diagonals[0] == entering[k].diagonals[1])
        irregular.push_back(k);
  }

  Point3 ShellNodes::compute_normal(const std::size_t node, const double *position) const
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

  void ShellNodes::update_irregular(const std::size_t node, const double *position)
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
  void ShellNodes::update_group(const EnteringNode *nodes, const std::size_t n, const double *position,
                                const double *increment, const double *last)
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
        ShellRecord      &record = records[node];
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

  void ShellNodes::update(const ElementBlocks::Block &block, const double *position, const double *increment)
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
    pool.parallel_for(block.entering_end - block.entering_begin, ElementBlocks::nodes_per_chunk, std::cref(body));
  }

  void ShellNodes::add_symmetry_plane(const std::span<const std::uint32_t> nodes, const Point3 &plane_normal)
  {
    std::vector<double> position;
    for (const auto &record : records)
      position.insert(position.end(), record.position, record.position + 3);
    symmetry.resize(n_nodes);
    for (const auto node : nodes)
      {
        symmetry.at(node).push_back(plane_normal.normalized());
        entering[entering_of[node]].diagonals = {node, node, node, node};
        Point3::Map(records[node].normal)     = compute_normal(node, position.data());
      }
    list_irregular();
  }

  void ShellNodes::take_out(const Cell &cell)
  {
    for (std::uint32_t i = 0; i < 4; ++i)
      {
        const std::uint32_t n = cell[i];
        const auto          corner =
          std::find_if(corners.begin() + corner_begin[n], corners.begin() + corner_begin[n + 1],
                       [&](const Corner &c) { return c.next == cell[(i + 1) % 4] && c.previous == cell[(i + 3) % 4]; });
        *corner = {n, n}; // spans no area, so adds nothing to the normal
        bared.push_back(n);
      }
  }

  void ShellNodes::close(const double *position)
  {
    std::sort(bared.begin(), bared.end());
    bared.erase(std::unique(bared.begin(), bared.end()), bared.end());
    for (const std::uint32_t n : bared)
      {
        const bool is_summed               = !symmetry.empty() && !symmetry[n].empty();
        entering[entering_of[n]].diagonals = is_summed ? Diagonals{n, n, n, n} : find_diagonals(n);
        // the next step's mean is then of two normals of the same elements
        Point3::Map(records[n].normal) = compute_normal(n, position);
      }
    bared.clear();
    list_irregular();
  }

  std::size_t ShellNodes::bytes() const
  {
    return bytes_of(records) + bytes_of(corner_begin) + bytes_of(corners) + bytes_of(entering) + bytes_of(entering_of) +
           bytes_of(irregular);
  }
} // namespace birdstrike
