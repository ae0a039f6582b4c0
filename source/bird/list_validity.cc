#include <birdstrike/bird/neighbor_list.h>

#include <algorithm>
#include <cmath>
#include <limits>

/// How long a neighbour list lasts: bounds of relative displacement between cells.
namespace birdstrike
{
  namespace
  {
    constexpr std::size_t cells_per_chunk = 64;

    /// Of the particles [begin, end), at least one, along one direction: x - origin - start.
    struct Displacement
    {
      template <class Number>
      Number at(const std::size_t p) const
      {
        return load<Number>(x + p) - origin - load<Number>(start + p);
      }

      void find_extremes(const std::size_t begin, const std::size_t end, double &low, double &high) const
      {
        low = high = at<double>(begin);
        if (end - begin < n_lanes)
          {
            for (std::size_t p = begin + 1; p < end; ++p)
              {
                low  = std::min(low, at<double>(p));
                high = std::max(high, at<double>(p));
              }
            return;
          }
        Lanes least = at<Lanes>(end - n_lanes), most = least; // the last register may overlap the one before
        for (std::size_t p = begin; p + n_lanes <= end; p += n_lanes)
          {
            const Lanes a = at<Lanes>(p);
            least         = min(least, a);
            most          = max(most, a);
          }
        low  = stdx::hmin(least);
        high = stdx::hmax(most);
      }

      double sum(const std::size_t begin, const std::size_t end) const
      {
        Lanes       whole = 0.;
        std::size_t p     = begin;
        for (; p + n_lanes <= end; p += n_lanes)
          whole += at<Lanes>(p);
        double rest = stdx::reduce(whole);
        for (; p < end; ++p)
          rest += at<double>(p);
        return rest;
      }

      const double *x;
      const float  *start;
      double        origin;
    };
  } // namespace

  void NeighborList::list_near_cells()
  {
    const auto       &occupied   = grid.occupied();
    const std::size_t n_occupied = occupied.size();
    for (auto *column : {&lowest, &highest})
      for (auto &bound : *column)
        {
          if (bound.capacity() < n_occupied + n_lanes) // whole registers are read at the end of a run
            bound.reserve(n_occupied + n_occupied / 4 + n_lanes);
          bound.resize(n_occupied);
        }
    occupied_before.resize(grid.n_cells() + 1);
    std::size_t o = 0;
    for (std::size_t c = 0; c < occupied_before.size(); ++c)
      {
        occupied_before[c] = o;
        o += o < n_occupied && occupied[o] == c;
      }
    near_start.assign(1, 0);
    near_runs.clear();
    for (o = 0; o < n_occupied; ++o)
      {
        // each pair once: the other comes no later
        const auto add_run = [&](const std::size_t first_cell, const std::size_t last_cell) {
          const std::uint32_t begin = occupied_before[first_cell];
          const std::uint32_t end   = std::min<std::uint32_t>(occupied_before[last_cell + 1], o + 1);
          if (begin < end)
            near_runs.push_back({begin, end});
        };
        const auto [cx, cy, cz] = grid.cell_coordinates(occupied[o]);
        int       x[5], y[5], z[5];
        const int nx = grid.neighbors(0, cx, 2, x), ny = grid.neighbors(1, cy, 2, y), nz = grid.neighbors(2, cz, 2, z);
        for (int k = 0; k < nz; ++k)
          for (int j = 0; j < ny; ++j)
            if (!grid.is_periodic(0)) // neighbours along x are consecutive
              add_run(grid.cell_index(x[0], y[j], z[k]), grid.cell_index(x[nx - 1], y[j], z[k]));
            else
              for (int i = 0; i < nx; ++i)
                add_run(grid.cell_index(x[i], y[j], z[k]), grid.cell_index(x[i], y[j], z[k]));
        near_start.push_back(near_runs.size());
      }
  }

  double NeighborList::update_extremes(const Particles &particles, ThreadPool &pool)
  {
    const auto       &occupied = grid.occupied();
    const std::size_t n        = particles.size();
    const auto u    = [&](const int d) { return Displacement{particles.x[d].data(), positions[d].data(), origin[d]}; };
    const auto sums = pool.ordered_sums<3>(n, [&](const std::size_t begin, const std::size_t end) {
      return std::array<double, 3>{u(0).sum(begin, end), u(1).sum(begin, end), u(2).sum(begin, end)};
    });
    return pool.ordered_max(
      occupied.size(),
      [&](const std::size_t begin, const std::size_t end) {
        double farthest = 0.;
        for (std::size_t o = begin; o < end; ++o)
          {
            double sum = 0.;
            for (int d = 0; d < 3; ++d)
              {
                double low, high;
                u(d).find_extremes(grid.begin(occupied[o]), grid.end(occupied[o]), low, high);
                lowest[d][o]      = low;
                highest[d][o]     = high;
                const double mean = is_mirrored && d == 1 ? 0. : sums[d] / n; // the images' mean is the same
                const double far  = std::max(high - mean, mean - low);
                sum += far * far;
              }
            farthest = std::max(farthest, sum);
          }
        return farthest;
      },
      cells_per_chunk);
  }

  double NeighborList::compute_largest_spread(const std::size_t begin, const std::size_t end) const
  {
    const Lanes index([](const auto k) { return static_cast<double>(k); });
    Lanes       largest   = 0.;
    double      of_images = 0.;
    for (std::size_t o = begin; is_mirrored && o < end; ++o)
      of_images = std::max(of_images, compute_image_spread(o));
    for (std::size_t o = begin; o < end; ++o)
      for (std::size_t r = near_start[o]; r < near_start[o + 1]; ++r)
        for (std::size_t c = near_runs[r].begin; c < near_runs[r].end; c += n_lanes)
          {
            Lanes sum = 0.;
            for (int d = 0; d < 3; ++d)
              {
                const Lanes spread =
                  max(highest[d][o] - load<Lanes>(&lowest[d][c]), load<Lanes>(&highest[d][c]) - lowest[d][o]);
                sum += spread * spread;
              }
            largest = max(largest, select(index < static_cast<double>(near_runs[r].end - c), sum, Lanes(0.)));
          }
    return std::max(of_images, static_cast<double>(stdx::hmax(largest)));
  }

  /// As compute_largest_spread for one cell and the images of all cells that may come near it.
  double NeighborList::compute_image_spread(const std::size_t o) const
  {
    const auto [cx, cy, cz] = grid.cell_coordinates(grid.occupied()[o]);
    int       x[5], z[5];
    const int nx = grid.neighbors(0, cx, 2, x), nz = grid.neighbors(2, cz, 2, z);
    double    largest = 0.;
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < grid.count(1) && MirrorImages::may_meet(grid, cy, j); ++j)
        for (std::size_t c = occupied_before[grid.cell_index(x[0], j, z[k])];
             c < occupied_before[grid.cell_index(x[nx - 1], j, z[k]) + 1]; ++c)
          {
            double sum = 0.;
            for (int d = 0; d < 3; ++d)
              {
                const double spread = d == 1 ? std::max(highest[d][o] + highest[d][c], -lowest[d][o] - lowest[d][c])
                                             : std::max(highest[d][o] - lowest[d][c], highest[d][c] - lowest[d][o]);
                sum += spread * spread;
              }
            largest = std::max(largest, sum);
          }
    return largest;
  }

  bool NeighborList::is_outdated(const Particles &particles, ThreadPool &pool)
  {
    if (particles.size() == 0)
      return false;
    const double farthest2 = update_extremes(particles, pool);
    if (4. * farthest2 <= skin * skin)
      return false;
    if (2. * std::sqrt(farthest2) > 2. * grid.edge() - support)
      return true;
    return pool.ordered_max(
             grid.occupied().size(),
             [&](const std::size_t begin, const std::size_t end) { return compute_largest_spread(begin, end); },
             cells_per_chunk) > skin * skin;
  }
} // namespace birdstrike
