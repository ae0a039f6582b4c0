#include <birdstrike/bird/neighbor_list.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#if defined(__AVX512F__)
#  include <immintrin.h>
#endif

namespace birdstrike
{
  namespace
  {
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

    /// Squared distance of point p from n_lanes consecutive points.
    template <bool is_periodic>
    Lanes distance_squared(const Particles &particles, const Point3 &p, const std::size_t j, const Period &period)
    {
      Lanes r2 = 0.;
      for (int d = 0; d < 3; ++d)
        {
          Lanes x = load<Lanes>(&particles.x[d][j]) - p[d];
          if constexpr (is_periodic)
            if (period[d] > 0.)
              x -= period[d] * stdx::nearbyint(x * (1. / period[d]));
          r2 += x * x;
        }
      return r2;
    }

    /// Appends those of j, j+1, ... whose bit is set. Writes n_lanes entries, whatever the number kept.
    std::uint32_t *append(std::uint32_t *out, const std::uint32_t j, const LanesMask &keep)
    {
#if defined(__AVX512F__)
      if constexpr (sizeof(LanesMask) == sizeof(__mmask8)) // one bit per lane
        {
          const auto    bits = std::bit_cast<__mmask8>(keep);
          const __m512i step = _mm512_set_epi32(0, 0, 0, 0, 0, 0, 0, 0, 7, 6, 5, 4, 3, 2, 1, 0);
          const __m512i kept = _mm512_maskz_compress_epi32(bits, _mm512_add_epi32(step, _mm512_set1_epi32(j)));
          _mm256_storeu_si256(reinterpret_cast<__m256i *>(out), _mm512_castsi512_si256(kept));
          return out + __builtin_popcount(bits);
        }
#endif
      for (std::size_t k = 0; k < n_lanes; ++k)
        {
          *out = j + k;
          out += keep[k];
        }
      return out;
    }
  } // namespace

  NeighborList::NeighborList(const double support, const double skin, const Period &period, const std::size_t padding)
    : support(support), skin(skin), list_padding(padding), cell_period(period)
  {
  }

  template <bool is_periodic>
  void NeighborList::list_cells(const Particles &particles, const std::size_t chunk, const std::size_t begin,
                                const std::size_t end)
  {
    AlignedVector<std::uint32_t> &lists  = chunks[chunk];
    const double                  range2 = (support + skin) * (support + skin);
    const std::size_t             n      = particles.size();
    const Lanes                   index([](const auto k) { return static_cast<double>(k); });
    std::size_t                   used = 0;
    for (std::size_t o = begin; o < end; ++o)
      {
        const std::size_t cell = grid.occupied()[o];
        const Runs        runs = find_runs(grid, cell);
        const std::size_t most = runs.total + 28 * n_lanes + list_padding;
        for (std::size_t p = grid.begin(cell); p < grid.end(cell); ++p)
          {
            if (used + most > lists.size())
              lists.resize(2 * (used + most));
            std::uint32_t *const list = lists.data() + used;
            std::uint32_t       *out  = list;
            const Point3         here(particles.x[0][p], particles.x[1][p], particles.x[2][p]);
            for (int run = 0; run < runs.n; ++run)
              for (std::size_t j = runs.begin[run]; j < runs.end[run]; j += n_lanes)
                {
                  const Lanes r2    = distance_squared<is_periodic>(particles, here, j, cell_period);
                  const Lanes ahead = index + static_cast<double>(j);
                  out               = append(out, j,
                                             r2 < range2 && ahead != static_cast<double>(p) &&
                                               ahead < static_cast<double>(runs.end[run]));
                }
            while ((out - list) % list_padding != 0)
              *out++ = n;
            offset[p] = used;
            count[p]  = out - list;
            used += count[p];
          }
      }
  }

  void NeighborList::update(Particles &particles, ThreadPool &pool)
  {
    grid.update(particles, support + skin, cell_period, pool);
    const std::size_t n = particles.size();
    // whole registers are read at the end of the last run: columns are reserved with slack (see Bird)
    first.resize(n);
    count.resize(n);
    offset.resize(n);
    prefix.resize(n + 1);
    const auto &occupied = grid.occupied();
    chunks.resize(pool.n_threads());
    const std::size_t n_chunks = chunks.size();
    const bool        wraps    = cell_period[0] > 0. || cell_period[1] > 0. || cell_period[2] > 0.;
    const auto        border   = [&](const std::size_t c) { // chunks of about equally many particles
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
            list_cells<true>(particles, c, border(c), border(c + 1));
          else
            list_cells<false>(particles, c, border(c), border(c + 1));
          for (std::size_t o = border(c); o < border(c + 1); ++o)
            for (std::size_t p = grid.begin(occupied[o]); p < grid.end(occupied[o]); ++p)
              first[p] = chunks[c].data() + offset[p];
        }
    });
    prefix[0] = 0;
    for (std::size_t p = 0; p < n; ++p)
      prefix[p + 1] = prefix[p] + count[p] + n_lanes;
    longest_count = n == 0 ? 0 : *std::max_element(count.begin(), count.end());
    for (auto &u : particles.displacement)
      std::fill(u.begin(), u.end(), 0.);
    list_near_cells();
    ++builds;
  }
} // namespace birdstrike
