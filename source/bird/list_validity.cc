#include <birdstrike/bird/neighbor_list.h>

#include <algorithm>
#include <cmath>
#include <limits>

/// How long a neighbour list lasts: bounds of relative displacement between cells.
namespace birdstrike
{
  void NeighborList::list_near_cells()
  {
    const auto &occupied = grid.occupied();
    compact_index.assign(grid.n_cells(), std::numeric_limits<std::uint32_t>::max());
    for (std::size_t o = 0; o < occupied.size(); ++o)
      compact_index[occupied[o]] = o;
    near_start.assign(1, 0);
    near_cells.clear();
    boxes.resize(occupied.size());
    for (std::size_t o = 0; o < occupied.size(); ++o)
      {
        const auto [cx, cy, cz] = grid.cell_coordinates(occupied[o]);
        int       x[5], y[5], z[5];
        const int nx = grid.neighbors(0, cx, 2, x), ny = grid.neighbors(1, cy, 2, y), nz = grid.neighbors(2, cz, 2, z);
        for (int k = 0; k < nz; ++k)
          for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
              {
                const std::uint32_t other = compact_index[grid.cell_index(x[i], y[j], z[k])];
                if (other != std::numeric_limits<std::uint32_t>::max() && other <= o)
                  near_cells.push_back(other);
              }
        near_start.push_back(near_cells.size());
      }
  }

  bool NeighborList::is_outdated(const Particles &particles, ThreadPool &pool)
  {
    const auto       &occupied = grid.occupied();
    const auto       &u        = particles.displacement;
    const std::size_t n        = particles.size();
    if (n == 0)
      return false;
    Point3 mean;
    for (int d = 0; d < 3; ++d)
      mean[d] = pool.ordered_sum(n, [&](const std::size_t begin, const std::size_t end) {
        double sum = 0.;
        for (std::size_t p = begin; p < end; ++p)
          sum += u[d][p];
        return sum;
      }) / n;
    const double farthest2 = pool.ordered_max(
      occupied.size(),
      [&](const std::size_t begin, const std::size_t end) {
        double largest = 0.;
        for (std::size_t o = begin; o < end; ++o)
          {
            double sum = 0.;
            for (int d = 0; d < 3; ++d)
              {
                const auto [low, high] =
                  std::minmax_element(u[d].begin() + grid.begin(occupied[o]), u[d].begin() + grid.end(occupied[o]));
                boxes[o].low[d]  = *low;
                boxes[o].high[d] = *high;
                const double far = std::max(*high - mean[d], mean[d] - *low);
                sum += far * far;
              }
            largest = std::max(largest, sum);
          }
        return largest;
      },
      64);
    if (2. * std::sqrt(farthest2) > 2. * grid.edge() - support)
      return true;
    return pool.ordered_max(
             occupied.size(),
             [&](const std::size_t begin, const std::size_t end) {
               double largest = 0.;
               for (std::size_t o = begin; o < end; ++o)
                 for (std::size_t k = near_start[o]; k < near_start[o + 1]; ++k)
                   {
                     const Box &a = boxes[o], &b = boxes[near_cells[k]];
                     double     sum = 0.;
                     for (int d = 0; d < 3; ++d)
                       {
                         const double spread = std::max(a.high[d] - b.low[d], b.high[d] - a.low[d]);
                         sum += spread * spread;
                       }
                     largest = std::max(largest, sum);
                   }
               return largest;
             },
             64) > skin * skin;
  }
} // namespace birdstrike
