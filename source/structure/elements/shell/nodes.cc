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
    , sheets(points, cells, static_cast<std::uint32_t>(first_fold()))
    , records(first_fold() + sheets.nodes.size(), ShellRecord{})
    , pool(pool)
    , entering(blocks.entering.begin(), blocks.entering.end())
    , sums(records.size(), Point3::Zero())
  {
    const auto &of_corners = sheets.records_of_corners.empty() ? cells : sheets.records_of_corners;
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (std::uint32_t i = 0; i < 4; ++i)
        {
          const auto   &cell = cells[c];
          const Point3 &x    = points[cell[i]];
          sums[of_corners[c][i]] += (points[cell[(i + 1) % 4]] - x).cross(points[cell[(i + 3) % 4]] - x);
        }
    const auto place = [&](const std::size_t record, const std::size_t node) {
      std::copy(points[node].data(), points[node].data() + 3, records[record].position);
      set_director(records[record], sums[record]);
    };
    for (std::size_t n = 0; n < n_nodes; ++n)
      place(n, n);
    for (std::size_t k = 0; k < sheets.nodes.size(); ++k)
      place(first_fold() + k, sheets.nodes[k]);
    sort_folds(blocks);
    for (std::size_t i = 0; i < 4; ++i)
      {
        ShellRecord &record = records[n_nodes + i];
        record.position[0]  = i == 1 || i == 2 ? 1. : 0.;
        record.position[1]  = i >= 2 ? 1. : 0.;
        record.normal[2] = record.midpoint_normal[2] = 1.;
      }
  }

  void ShellNodes::sort_folds(const ElementBlocks &blocks)
  {
    if (sheets.nodes.empty())
      return;
    for (const ElementBlocks::Block &block : blocks.blocks)
      {
        folds_begin.push_back(static_cast<std::uint32_t>(folds.size()));
        for (auto k = block.entering_begin; k < block.entering_end; ++k)
          {
            const auto [begin, end] = std::equal_range(sheets.nodes.begin(), sheets.nodes.end(), entering[k]);
            for (auto node = begin; node != end; ++node)
              {
                folds.push_back(static_cast<std::uint32_t>(first_fold() + (node - sheets.nodes.begin())));
                folded.push_back(*node);
              }
          }
      }
    folds_begin.push_back(static_cast<std::uint32_t>(folds.size()));
  }

  /// Up to n_lanes records, and their nodes.
  void ShellNodes::update_group(const std::uint32_t *of_nodes, const std::uint32_t *of_records, const std::size_t n,
                                const double *position, const double *increment)
  {
    alignas(64) double square[n_lanes] = {};
    for (std::size_t k = 0; k < n; ++k)
      {
        const double *const r = increment + 6 * of_nodes[k] + 3;
        square[k]             = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
      }
    store(Lanes(1.) / (Lanes(1.) + 0.25 * load<Lanes>(square)), square);
    for (std::size_t k = 0; k < n; ++k)
      {
        const std::size_t node   = of_nodes[k];
        ShellRecord      &record = records[of_records[k]];
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
    const auto update_all = [&](const std::uint32_t *of_nodes, const std::uint32_t *of_records, const std::size_t n) {
      const auto body = [&](const std::size_t begin, const std::size_t end) {
        for (std::size_t k = begin; k < end; k += n_lanes)
          update_group(of_nodes + k, of_records + k, std::min(n_lanes, end - k), position, increment);
      };
      pool.parallel_for(n, ElementBlocks::nodes_per_chunk, std::cref(body));
    };
    const std::uint32_t *const nodes = entering.data() + block.entering_begin;
    update_all(nodes, nodes, block.entering_end - block.entering_begin);
    if (!folds.empty())
      {
        const auto begin = folds_begin[block.number()], end = folds_begin[block.number() + 1];
        update_all(folded.data() + begin, folds.data() + begin, end - begin);
      }
  }

  void ShellNodes::add_symmetry_plane(const std::span<const std::uint32_t> nodes, const Point3 &plane_normal)
  {
    const Point3 plane   = plane_normal.normalized();
    const auto   enclose = [&](const std::size_t record) {
      const Point3 part   = sums[record].dot(plane) * plane;
      const Point3 in     = sums[record] - part;
      const double cosine = in.squaredNorm() - part.squaredNorm(); // to the mirror image, times the square of the sum
      if (cosine <= ShellSheets::least_cosine * sums[record].squaredNorm())
        return false; // a fold
      sums[record] = in;
      set_director(records[record], in);
      return true;
    };
    for (const auto node : nodes)
      {
        if (!enclose(node))
          folded_on_plane.insert(std::lower_bound(folded_on_plane.begin(), folded_on_plane.end(), node), node);
        const auto [begin, end] = std::equal_range(sheets.nodes.begin(), sheets.nodes.end(), node);
        for (auto other = begin; other != end; ++other)
          enclose(first_fold() + static_cast<std::size_t>(other - sheets.nodes.begin()));
      }
  }

  void ShellNodes::archive_folds(Archive &archive, const double *position)
  {
    if (sheets.nodes.empty())
      return;
    archive.entities("folds", sheets.nodes.size(), [&](Archive::Row &row, const std::size_t k) {
      ShellRecord &record = records[first_fold() + k];
      row("normal", record.normal);
      std::copy(position + 3 * sheets.nodes[k], position + 3 * sheets.nodes[k] + 3, record.position);
    });
  }

  Point3 ShellNodes::director(const std::uint32_t node) const
  {
    constexpr double same = 0.9999; // cosine: from there on what turns about one of two hardly bends the other
    const Point3     first(records[node].normal);
    if (std::binary_search(folded_on_plane.begin(), folded_on_plane.end(), node))
      return Point3::Zero();
    const auto [begin, end] = std::equal_range(sheets.nodes.begin(), sheets.nodes.end(), node);
    for (auto other = begin; other != end; ++other)
      if (std::abs(first.dot(
            Point3(records[first_fold() + static_cast<std::size_t>(other - sheets.nodes.begin())].normal))) < same)
        return Point3::Zero();
    return first;
  }

  std::size_t ShellNodes::bytes() const
  {
    return bytes_of(records) + bytes_of(entering) + bytes_of(sums) + bytes_of(sheets.records_of_corners) +
           bytes_of(sheets.nodes) + bytes_of(folds) + bytes_of(folded) + bytes_of(folds_begin) +
           bytes_of(folded_on_plane);
  }
} // namespace birdstrike
