#include "measure.h"

#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/number.h>
#include <birdstrike/core/thread_pool.h>

namespace birdstrike::benchmarks
{
  namespace
  {
    /// A pool with two arrays; the second holds the small numbers that are added to the first.
    struct Columns
    {
      Columns(const std::size_t n, const std::size_t n_threads) : pool(n_threads), x(n, 1.), v(n, 1e-9)
      {
      }
      ThreadPool            pool;
      AlignedVector<double> x, v;
    };

    double add_up(const AlignedVector<double> &x, const std::size_t begin, const std::size_t end)
    {
      Lanes       sum  = 0.;
      double      tail = 0.;
      std::size_t p    = begin;
      for (; p + n_lanes <= end; p += n_lanes)
        sum += load<Lanes>(&x[p]);
      for (; p < end; ++p)
        tail += x[p];
      return stdx::reduce(sum) + tail;
    }
  } // namespace

  void add_core_benchmarks()
  {
    add("core/ordered_sum", make_settings(1000000),
        [](benchmark::State &state, const Setting &s, const std::string &key) {
          auto &columns = keep<Columns>(key, s.n, s.n_threads);
          run_loop(state, [&] {
            benchmark::DoNotOptimize(columns.pool.ordered_sum(
              s.n, [&](const std::size_t begin, const std::size_t end) { return add_up(columns.x, begin, end); }));
          });
          count_work(state, static_cast<double>(s.n), "entity", {1., 8.});
        });
    add("core/integration", make_settings(1000000),
        [](benchmark::State &state, const Setting &s, const std::string &key) {
          auto &columns = keep<Columns>(key, s.n, s.n_threads);
          run_loop(state, [&] {
            columns.pool.parallel_for(s.n, 64, [&](const std::size_t begin, const std::size_t end) {
              for (std::size_t p = begin; p < end; ++p)
                columns.x[p] += 1e-6 * columns.v[p];
            });
          });
          count_work(state, static_cast<double>(s.n), "entity", {2., 24.});
        });
    /// What it costs to hand a loop without work to the pool and to have it back.
    add("core/parallel_for_empty", {{1000, 1, 7}, {1000, 2, 7}},
        [](benchmark::State &state, const Setting &s, const std::string &key) {
          auto &columns = keep<Columns>(key, s.n, s.n_threads);
          run_loop(state, [&] {
            columns.pool.parallel_for(s.n, 1,
                                      [](const std::size_t begin, std::size_t) { benchmark::DoNotOptimize(begin); });
          });
          count_work(state, 1., "loop");
        });
  }
} // namespace birdstrike::benchmarks
