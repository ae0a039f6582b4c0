#pragma once

#include "flops.h"
#include "memory.h"

#include <benchmark/benchmark.h>

#include <memory>
#include <string>

namespace birdstrike::benchmarks
{
  /// A size and a number of threads, with as many repetitions as the time allows; the smallest is what counts.
  struct Setting
  {
    std::size_t n, n_threads;
    int         n_repetitions;

    std::string suffix() const
    {
      return (n > 0 ? "/n:" + std::to_string(n) : "") + "/threads:" + std::to_string(n_threads);
    }
  };

  /// All settings up to a largest size, on one and two threads.
  inline std::vector<Setting> make_settings(const std::size_t largest)
  {
    std::vector<Setting> settings;
    for (const std::size_t n : {1000ul, 10000ul, 100000ul, 1000000ul})
      for (const std::size_t n_threads : {1ul, 2ul})
        if (n <= largest)
          settings.push_back({n, n_threads, n < 100000 ? 7 : n < 1000000 ? 3 : 1});
    return settings;
  }

  /// Time per unit of work, GFLOP/s and what they rest on (flops.h) from the time of the loop that `state` has run.
  inline void count_work(benchmark::State &state, const double n_units, const std::string &unit, const Work &work = {})
  {
    using benchmark::Counter;
    const double done                  = n_units * static_cast<double>(state.iterations());
    state.counters["time_per_" + unit] = Counter(done, Counter::kIsRate | Counter::kInvert); // s
    state.counters["units"]            = n_units;
    if (work.flops > 0.)
      {
        state.counters["flops_per_unit"] = work.flops;
        state.counters["GFLOP/s"]        = Counter(1e-9 * done * work.flops, Counter::kIsRate);
      }
    if (work.bytes > 0.)
      state.counters["bytes_per_unit"] = work.bytes;
  }

  /// Runs the loop of a benchmark and notes what it allocated.
  template <class Body>
  void run_loop(benchmark::State &state, const Body &body)
  {
    const unsigned long before = n_allocations();
    for ([[maybe_unused]] const auto _ : state)
      body();
    state.counters["allocations_per_call"] =
      static_cast<double>(n_allocations() - before) / static_cast<double>(state.iterations());
  }

  struct Slot
  {
    std::string           key;
    std::shared_ptr<void> workload;
    double                bytes = 0.; ///< that building it has taken, by operator new
  };
  inline Slot slot;

  /// Builds a workload unless the last one built has the same key: a million particles take seconds to pack, and the
  /// two largest workloads should not lie in memory together.
  template <class Workload, class... Arguments>
  Workload &keep(const std::string &key, const Arguments &...arguments)
  {
    if (slot.key != key)
      {
        slot                     = {};
        const std::size_t before = bytes_in_use();
        slot.workload            = std::make_shared<Workload>(arguments...);
        slot.bytes               = static_cast<double>(bytes_in_use() - before);
        slot.key                 = key;
      }
    return *static_cast<Workload *>(slot.workload.get());
  }

  /// Registers one benchmark for each setting.
  template <class Body>
  void add(const std::string &name, const std::vector<Setting> &settings, const Body &body, const long iterations = 0)
  {
    for (const Setting &setting : settings)
      {
        auto *const made =
          benchmark::RegisterBenchmark((name + setting.suffix()).c_str(),
                                       [=](benchmark::State &state) { body(state, setting, name + setting.suffix()); });
        made->Repetitions(setting.n_repetitions)->Unit(benchmark::kMicrosecond);
        if (setting.n_threads > 1)
          made->UseRealTime(); // on one thread its processor time: what else runs on the machine then matters less
        if (iterations > 0)
          made->Iterations(iterations);
        else
          made->MinTime(0.05);
      }
  }

  // Each source file adds its own.
  void add_bird_benchmarks();
  void add_shell_benchmarks();
  void add_solid_benchmarks();
  void add_contact_benchmarks();
  void add_material_benchmarks();
  void add_core_benchmarks();
  void add_machine_benchmarks();
  void add_scene_benchmarks();
} // namespace birdstrike::benchmarks
