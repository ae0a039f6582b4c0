#include "measure.h"

#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/number.h>
#include <birdstrike/core/thread_pool.h>

namespace birdstrike::benchmarks
{
  namespace
  {
    /// The machine's ceilings for the roofline: arithmetic and bandwidth, by loops that do nothing else.
    constexpr std::size_t n_chains = 12;      // latency 4, two units: eight chains in flight fill both
    constexpr std::size_t n_rounds = 1 << 12; // 50 us

    /// x <- a x + b on registers.
    template <class Number>
    double multiply_and_add(const double start)
    {
      using T = typename Number::value_type;
      Number       x[n_chains];
      const Number a = T(0.999999), b = T(1e-6);
      for (std::size_t k = 0; k < n_chains; ++k)
        x[k] = static_cast<T>(start) + static_cast<T>(k);
      for (std::size_t round = 0; round < n_rounds; ++round)
#pragma GCC unroll 12
        for (std::size_t k = 0; k < n_chains; ++k)
          x[k] = a * x[k] + b;
      Number sum = T(0);
      for (const Number &chain : x)
        sum += chain;
      return static_cast<double>(stdx::reduce(sum));
    }

    template <class Number>
    void add_peak(const std::string &name)
    {
      add(name, {{1000, 1, 7}, {1000, 2, 7}}, [](benchmark::State &state, const Setting &s, const std::string &) {
        ThreadPool            pool(s.n_threads);
        AlignedVector<double> sink(8 * s.n_threads);
        run_loop(state, [&] {
          pool.parallel_for(s.n_threads, 1, [&](const std::size_t begin, const std::size_t end) {
            for (std::size_t t = begin; t < end; ++t)
              sink[8 * t] = multiply_and_add<Number>(sink[8 * t]);
          });
        });
        benchmark::DoNotOptimize(sink.data());
        count_work(state, static_cast<double>(s.n_threads * n_chains * n_rounds), "register",
                   {2. * static_cast<double>(Number::size()), 0.});
      });
    }

    struct Triad
    {
      Triad(const std::size_t n, const std::size_t n_threads) : pool(n_threads), a(n), b(n, 1.), c(n, 2.)
      {
      }
      ThreadPool            pool;
      AlignedVector<double> a, b, c;
    };

    /// a = b + s c (McCalpin's triad): 24 bytes an entry, not counting that a store first reads its line.
    void add_triad(const std::string &where, const std::size_t entries_per_thread)
    {
      for (const std::size_t n_threads : {1ul, 2ul})
        add("machine/triad/" + where, {{entries_per_thread * n_threads, n_threads, 7}},
            [](benchmark::State &state, const Setting &s, const std::string &key) {
              auto &arrays = keep<Triad>(key, s.n, s.n_threads);
              run_loop(state, [&] {
                arrays.pool.parallel_for(s.n, n_lanes, [&](const std::size_t begin, const std::size_t end) {
                  double *const       a = arrays.a.data();
                  const double *const b = arrays.b.data(), *const c = arrays.c.data();
                  for (std::size_t p = begin; p + n_lanes <= end; p += n_lanes)
                    store(load<Lanes>(b + p) + 0.5 * load<Lanes>(c + p), a + p);
                });
                benchmark::ClobberMemory();
              });
              state.counters["GB/s"] =
                benchmark::Counter(24e-9 * static_cast<double>(s.n) * static_cast<double>(state.iterations()),
                                   benchmark::Counter::kIsRate);
              count_work(state, static_cast<double>(s.n), "entry", {2., 24.});
            });
    }
  } // namespace

  void add_machine_benchmarks()
  {
    add_peak<Lanes>("machine/fma/double");
    add_peak<FloatLanes>("machine/fma/float");
    add_triad("l2", 20 << 10);    // 3 arrays of 160 KiB
    add_triad("memory", 8 << 20); // 3 arrays of 64 MiB
  }
} // namespace birdstrike::benchmarks
