#include "structure/elements/shell/nodes.h"

#include <algorithm>
#include <numeric>

namespace birdstrike
{
  namespace
  {
    /// A corner of a cell, by its node.
    struct Corner
    {
      std::uint32_t node, cell, number;
    };

    /// Whether two cells that meet at a node have an edge from it in common.
    bool share_edge(const Corner &a, const Corner &b, const std::vector<ShellNodes::Cell> &cells)
    {
      const auto ends_at = [&](const std::uint32_t node) {
        return cells[b.cell][(b.number + 1) % 4] == node || cells[b.cell][(b.number + 3) % 4] == node;
      };
      return ends_at(cells[a.cell][(a.number + 1) % 4]) || ends_at(cells[a.cell][(a.number + 3) % 4]);
    }

    /// By corner of a node the first one of its sheet: the smallest that a chain of cells leads to that go on without a
    /// fold, across common edges or, where two chains meet in the node alone, from one to the other.
    std::vector<std::size_t> first_of_sheet(const std::span<const Corner>        corners,
                                            const std::vector<ShellNodes::Cell> &cells,
                                            const std::vector<Point3>           &normals)
    {
      std::vector<std::size_t> first(corners.size());
      std::iota(first.begin(), first.end(), std::size_t(0));
      const auto join_where = [&](const auto &go_on) {
        for (std::size_t i = 0; i < corners.size(); ++i)
          for (std::size_t j = 0; j < i; ++j)
            if (first[i] != first[j] &&
                normals[corners[i].cell].dot(normals[corners[j].cell]) > ShellSheets::least_cosine && go_on(i, j))
              {
                const auto [kept, gone] = std::minmax(first[i], first[j]);
                std::replace(first.begin(), first.end(), std::size_t(gone), std::size_t(kept));
              }
      };
      join_where([&](const std::size_t i, const std::size_t j) { return share_edge(corners[i], corners[j], cells); });
      join_where([&](const std::size_t i, const std::size_t j) {
        for (std::size_t k = 0; k < corners.size(); ++k)
          for (std::size_t l = 0; l < corners.size(); ++l)
            if (first[k] == first[i] && first[l] == first[j] && share_edge(corners[k], corners[l], cells))
              return false; // along which they are folded
        return true;
      });
      return first;
    }
  } // namespace

  ShellSheets::ShellSheets(const std::vector<Point3> &points, const std::vector<ShellNodes::Cell> &cells,
                           const std::uint32_t first_record)
  {
    std::vector<Point3> normals;
    std::vector<Corner> corners;
    for (std::uint32_t c = 0; c < cells.size(); ++c)
      {
        const auto &cell = cells[c];
        normals.push_back((points[cell[2]] - points[cell[0]]).cross(points[cell[3]] - points[cell[1]]).normalized());
        for (std::uint32_t i = 0; i < 4; ++i)
          corners.push_back({cell[i], c, i});
      }
    std::stable_sort(corners.begin(), corners.end(), [](const Corner &a, const Corner &b) { return a.node < b.node; });
    for (auto begin = corners.begin(), end = begin; begin != corners.end(); begin = end)
      {
        end = std::find_if(begin, corners.end(), [&](const Corner &c) { return c.node != begin->node; });
        const auto                 first = first_of_sheet({begin, end}, cells, normals);
        std::vector<std::uint32_t> record(first.size(), begin->node); // by the sheet's first corner
        for (std::size_t i = 1; i < first.size(); ++i)
          {
            if (first[i] == 0)
              continue;
            if (records_of_corners.empty())
              records_of_corners = cells;
            if (first[i] == i)
              {
                record[i] = first_record + static_cast<std::uint32_t>(nodes.size());
                nodes.push_back(begin->node);
              }
            records_of_corners[begin[i].cell][begin[i].number] = record[first[i]];
          }
      }
  }
} // namespace birdstrike
