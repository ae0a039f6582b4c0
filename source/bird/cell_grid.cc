#include <birdstrike/bird/cell_grid.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace birdstrike
{
  namespace
  {
    /// More cells than this per particle cost more to sweep than they save; spray then shares larger cells.
    constexpr double largest_cells_per_particle = 64.;

    double wrap(const double x, const double period)
    {
      return period > 0. ? x - period * std::floor(x / period) : x;
    }
  } // namespace

  void CellGrid::lay_out(const Particles &particles, const double range, const Period &period)
  {
    Point3 extent;
    for (int d = 0; d < 3; ++d)
      {
        periodic[d] = period[d] > 0.;
        if (periodic[d])
          {
            origin[d] = 0.;
            extent[d] = period[d];
            continue;
          }
        const auto [low, high] = std::minmax_element(particles.x[d].begin(), particles.x[d].end());
        origin[d]              = *low;
        extent[d]              = *high - *low;
      }
    double edge = range;
    for (;; edge *= 1.25)
      {
        double cells = 1.;
        for (int d = 0; d < 3; ++d)
          cells *= std::max(1., std::floor(extent[d] / edge) + (periodic[d] ? 0. : 1.));
        if (cells <= largest_cells_per_particle * particles.size() + 1000.)
          break;
      }
    smallest_edge = edge;
    for (int d = 0; d < 3; ++d)
      {
        n[d]            = std::max(1, static_cast<int>(std::floor(extent[d] / edge)) + (periodic[d] ? 0 : 1));
        inverse_edge[d] = periodic[d] ? n[d] / extent[d] : 1. / edge;
      }
  }

  void CellGrid::update(Particles &particles, const double range, const Period &period, ThreadPool &pool)
  {
    lay_out(particles, range, period);
    const std::size_t n_particles = particles.size();
    cell_of.resize(n_particles);
    pool.parallel_for(n_particles, 256, [&](const std::size_t first, const std::size_t last) {
      for (std::size_t p = first; p < last; ++p)
        {
          std::array<int, 3> c;
          for (int d = 0; d < 3; ++d)
            c[d] = std::clamp(static_cast<int>((wrap(particles.x[d][p], period[d]) - origin[d]) * inverse_edge[d]), 0,
                              n[d] - 1);
          cell_of[p] = cell_index(c[0], c[1], c[2]);
        }
    });
    sort(particles, pool);
  }

  void CellGrid::sort(Particles &particles, ThreadPool &pool)
  {
    const std::size_t n_particles = particles.size();
    order.resize(n_particles);
    start.assign(n_cells() + 1, 0);
    for (std::size_t p = 0; p < n_particles; ++p)
      ++start[cell_of[p] + 1];
    occupied_cells.clear();
    for (std::size_t c = 0; c < n_cells(); ++c)
      {
        if (start[c + 1] > 0)
          occupied_cells.push_back(c);
        start[c + 1] += start[c];
      }
    for (std::size_t p = 0; p < n_particles; ++p)
      order[start[cell_of[p]]++] = p;
    for (std::size_t c = n_cells(); c > 0; --c)
      start[c] = start[c - 1];
    start[0] = 0;
    permute(particles, pool);
  }

  void CellGrid::permute(Particles &particles, ThreadPool &pool)
  {
    const std::size_t n_particles = particles.size();
    scratch.resize(n_particles);
    const auto permute_column = [&](auto &column) {
      using Entry    = typename std::decay_t<decltype(column)>::value_type;
      auto *const to = reinterpret_cast<Entry *>(scratch.data());
      pool.parallel_for(n_particles, 512, [&](const std::size_t first, const std::size_t last) {
        for (std::size_t p = first; p < last; ++p)
          to[p] = column[order[p]];
      });
      // copied back, not swapped: views of the columns stay valid
      pool.parallel_for(n_particles, 512, [&](const std::size_t first, const std::size_t last) {
        std::copy(to + first, to + last, column.begin() + first);
      });
    };
    particles.for_each_column(permute_column);
    permute_column(particles.id);
  }

  std::array<int, 3> CellGrid::cell_coordinates(const std::size_t cell) const
  {
    const int c = static_cast<int>(cell);
    return {c % n[0], c / n[0] % n[1], c / (n[0] * n[1])};
  }

  int CellGrid::neighbors(const int d, const int c, const int reach, int *coordinates) const
  {
    int count = 0;
    if (!periodic[d])
      for (int k = std::max(0, c - reach); k <= std::min(n[d] - 1, c + reach); ++k)
        coordinates[count++] = k;
    else if (n[d] <= 2 * reach + 1)
      for (int k = 0; k < n[d]; ++k)
        coordinates[count++] = k;
    else
      for (int k = c - reach; k <= c + reach; ++k)
        coordinates[count++] = (k + n[d]) % n[d];
    return count;
  }
} // namespace birdstrike
