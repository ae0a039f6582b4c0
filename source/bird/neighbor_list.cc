#include <birdstrike/bird/neighbor_list.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace birdstrike
{
  namespace
  {
    /// Chunks are what a thread lists at a time. Each holds memory of its own, an eighth more than it needs.
    constexpr std::size_t chunks_per_thread = 4;

    /// Runs of consecutive particles that may be neighbours of the particles of one cell: at most 27 of them.
    struct Runs
    {
      std::array<std::uint32_t, 27> begin, end;
      int                           n     = 0;
      std::size_t                   total = 0;
    };

    void add_run(Runs &runs, const std::size_t begin, const std::size_t end)
    {
      if (begin == end)
        return;
      runs.begin[runs.n] = begin;
      runs.end[runs.n++] = end;
      runs.total += end - begin;
    }

    Runs find_runs(const CellGrid &grid, const std::size_t cell)
    {
      const auto [cx, cy, cz] = grid.cell_coordinates(cell);
      int       x[3], y[3], z[3];
      const int nx = grid.neighbors(0, cx, 1, x), ny = grid.neighbors(1, cy, 1, y), nz = grid.neighbors(2, cz, 1, z);
      Runs      runs;
      for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
          if (!grid.is_periodic(0)) // neighbours along x are consecutive in memory
            add_run(runs, grid.begin(grid.cell_index(x[0], y[j], z[k])),
                    grid.end(grid.cell_index(x[nx - 1], y[j], z[k])));
          else
            for (int i = 0; i < nx; ++i)
              {
                const std::size_t c = grid.cell_index(x[i], y[j], z[k]);
                add_run(runs, grid.begin(c), grid.end(c));
              }
      return runs;
    }
  } // namespace

  NeighborList::NeighborList(const double support, const double skin, const Period &period, const std::size_t padding)
    : support(support), skin(skin), list_padding(padding), cell_period(period)
  {
  }

  /// Distances are computed in float, relative to one particle, with a range that is larger by its round-off.
  void NeighborList::update_positions(const Particles &particles)
  {
    const std::size_t n       = particles.size();
    double            largest = 0.;
    for (int d = 0; d < 3; ++d)
      {
        positions[d].resize(n);
        origin[d] = n == 0 || (is_mirrored && d == 1) ? 0. : particles.x[d][0];
        for (std::size_t p = 0; p < n; ++p)
          {
            const double x  = particles.x[d][p] - origin[d];
            positions[d][p] = static_cast<float>(x);
            largest         = std::max(largest, std::abs(x));
          }
      }
    safe_range = support + skin + 4. * std::numeric_limits<float>::epsilon() * largest;
    reflect_positions(n);
  }

  void NeighborList::reflect_positions(const std::size_t n)
  {
    const std::size_t n_all = n + 1 + mirror_images.size();
    for (int d = 0; d < 3; ++d)
      {
        positions[d].reserve(n_all + FloatLanes::size()); // whole registers are read at the end of the last run
        positions[d].resize(n_all);
        for (std::size_t g = 0; g < mirror_images.size(); ++g)
          {
            const float x           = positions[d][mirror_images.source(g)];
            positions[d][n + 1 + g] = d == 1 ? -x : x;
          }
      }
  }

  /// The images that may be near the particles of a cell.
  void NeighborList::add_images(const std::size_t cell, CellCandidates &candidates) const
  {
    const std::size_t first = positions[0].size() - mirror_images.size();
    const auto [cx, cy, cz] = grid.cell_coordinates(cell);
    int       x[3], z[3];
    const int nx = grid.neighbors(0, cx, 1, x), nz = grid.neighbors(2, cz, 1, z);
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < grid.count(1) && MirrorImages::may_meet(grid, cy, j); ++j)
        {
          const std::size_t begin = grid.begin(grid.cell_index(x[0], j, z[k]));
          const std::size_t end   = grid.end(grid.cell_index(x[nx - 1], j, z[k]));
          candidates.add<false>(positions, first + mirror_images.count_before(begin),
                                first + mirror_images.count_before(end));
        }
  }

  template <bool is_periodic>
  void NeighborList::list_cells(const std::size_t n, const std::size_t chunk, const std::size_t begin,
                                const std::size_t end)
  {
    using Numbers                            = LaneNumbers<FloatLanes>;
    AlignedVector<std::uint32_t> &lists      = chunks[chunk];
    CellCandidates               &candidates = candidates_of_chunk[chunk];
    std::array<float, 3>          period;
    std::copy(cell_period.begin(), cell_period.end(), period.begin());
    std::size_t used = 0;
    for (std::size_t o = begin; o < end; ++o)
      {
        const std::size_t cell = grid.occupied()[o];
        const Runs        runs = find_runs(grid, cell);
        const std::size_t most = runs.total + mirror_images.size() + FloatLanes::size() + list_padding;
        candidates.clear(runs.total + mirror_images.size(), static_cast<float>(safe_range * safe_range));
        candidates.set_box(positions, grid.begin(cell), grid.end(cell));
        for (int run = 0; run < runs.n; ++run)
          candidates.add<is_periodic>(positions, runs.begin[run], runs.end[run]);
        if (mirror_images.size() > 0)
          add_images(cell, candidates);
        candidates.close();
        for (std::size_t p = grid.begin(cell); p < grid.end(cell); ++p)
          {
            if (used + most > lists.size())
              {
                lists.reserve(used + used / 8 + most); // not twice: lists are most of a bird's memory
                lists.resize(lists.capacity());
              }
            std::uint32_t *const       list = lists.data() + used;
            const std::array<float, 3> place{positions[0][p], positions[1][p], positions[2][p]};
            const std::size_t          listed =
              candidates.list<is_periodic>(list, static_cast<std::uint32_t>(p), place, period) - list;
            // whole registers, of which what is beyond the list is written over: a loop's length would be guessed wrong
            const std::size_t padded = (listed + list_padding - 1) / list_padding * list_padding;
            for (std::size_t k = listed; k < padded; k += FloatLanes::size())
              Numbers(static_cast<std::uint32_t>(n)).copy_to(list + k, stdx::element_aligned);
            offset[p] = used;
            count[p]  = padded;
            used += padded;
          }
      }
  }

  void NeighborList::update(Particles &particles, ThreadPool &pool)
  {
    grid.update(particles, support + skin, cell_period, pool);
    const std::size_t n = particles.size();
    if (is_mirrored)
      {
        const auto  &y      = particles.x[1];
        const double lowest = n == 0 ? 0. : *std::min_element(y.begin(), y.end());
        const double range  = support + skin - std::min(0., lowest);
        mirror_images.update(n, [&](const std::size_t p) { return y[p] < range; });
      }
    update_positions(particles);
    make_lists(n, pool);
    ++builds;
  }

  void NeighborList::make_lists(const std::size_t n, ThreadPool &pool)
  {
    first.resize(n);
    count.resize(n);
    offset.resize(n);
    prefix.resize(n + 1);
    const auto &occupied = grid.occupied();
    chunks.resize(pool.n_threads() == 1 ? 1 : chunks_per_thread * pool.n_threads());
    const std::size_t n_chunks = chunks.size();
    candidates_of_chunk.resize(n_chunks);
    const bool wraps  = cell_period[0] > 0. || cell_period[1] > 0. || cell_period[2] > 0.;
    const auto border = [&](const std::size_t c) { // chunks of about equally many particles
      if (c == n_chunks)
        return occupied.size();
      const auto cell = std::partition_point(occupied.begin(), occupied.end(),
                                             [&](const std::uint32_t o) { return grid.begin(o) < n * c / n_chunks; });
      return static_cast<std::size_t>(cell - occupied.begin());
    };
    pool.parallel_for(n_chunks, 1, [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        {
          if (wraps)
            list_cells<true>(n, c, border(c), border(c + 1));
          else
            list_cells<false>(n, c, border(c), border(c + 1));
          for (std::size_t o = border(c); o < border(c + 1); ++o)
            for (std::size_t p = grid.begin(occupied[o]); p < grid.end(occupied[o]); ++p)
              first[p] = chunks[c].data() + offset[p];
        }
    });
    prefix[0] = 0;
    for (std::size_t p = 0; p < n; ++p)
      prefix[p + 1] = prefix[p] + count[p] + n_lanes;
    longest_count = n == 0 ? 0 : *std::max_element(count.begin(), count.end());
    list_near_cells();
  }
} // namespace birdstrike
