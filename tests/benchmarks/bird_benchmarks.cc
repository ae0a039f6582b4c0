#include "bird_workload.h"
#include "measure.h"

namespace birdstrike::benchmarks
{
  namespace
  {
    void count_particles(benchmark::State &state, const BirdWorkload &bird, const Work &work = {})
    {
      count_work(state, static_cast<double>(bird.n()), "particle", work);
    }

    void add_rates(const std::string &formulation, const std::size_t largest)
    {
      add("bird/rates/" + formulation, make_settings(largest),
          [=](benchmark::State &state, const Setting &setting, const std::string &key) {
            auto        &bird  = keep<BirdWorkload>(key, setting.n, setting.n_threads, formulation);
            const double bytes = slot.bytes;
            run_loop(state, [&] { bird.bird.compute_rates(); });
            const double neighbors               = bird.count_true_neighbors();
            state.counters["true_neighbors"]     = neighbors;
            state.counters["bytes_per_particle"] = bytes / static_cast<double>(bird.n());
            count_particles(state, bird, formulation == "riemann" ? pair_loop_work(neighbors) : Work());
          });
    }

    /// Always as many steps as one list lasts, or a multiple: its price is then part of the step whatever the size.
    void add_steps(const std::string &formulation, const std::size_t largest)
    {
      for (const Setting &setting : make_settings(largest))
        add(
          "bird/step/" + formulation, {setting},
          [=](benchmark::State &state, const Setting &s, const std::string &key) {
            auto &bird = keep<BirdWorkload>(key, s.n, s.n_threads, formulation);
            bird.reset();
            const std::size_t builds   = bird.bird.n_list_builds();
            const double      at_start = bird.count_true_neighbors();
            run_loop(state, [&] { bird.step(); });
            state.counters["list_builds_per_step"] =
              static_cast<double>(bird.bird.n_list_builds() - builds) / static_cast<double>(state.iterations());
            const double neighbors               = 0.5 * (at_start + bird.count_true_neighbors());
            state.counters["true_neighbors"]     = neighbors;
            state.counters["bytes_per_particle"] = slot.bytes / static_cast<double>(bird.n());
            count_particles(state, bird, formulation == "riemann" ? particle_step_work(neighbors) : Work());
          },
          setting.n < 100000 ? 100 : 25);
    }

    void add_motion()
    {
      add("bird/kick", make_settings(1000000), [](benchmark::State &state, const Setting &s, const std::string &key) {
        auto &bird = keep<BirdWorkload>(key, s.n, s.n_threads);
        bird.reset();
        // forth and back: the state stays, and with it the cost
        run_loop(state, [&] {
          bird.bird.kick(0.5 * bird.step_size, HalfKick::first);
          bird.bird.kick(-0.5 * bird.step_size, HalfKick::first);
        });
        count_particles(state, bird, Work{2. * particle_motion_work().flops, 2. * particle_motion_work().bytes});
      });
      add("bird/drift", make_settings(1000000), [](benchmark::State &state, const Setting &s, const std::string &key) {
        auto &bird = keep<BirdWorkload>(key, s.n, s.n_threads);
        bird.reset();
        run_loop(state, [&] {
          bird.bird.drift(bird.step_size);
          bird.bird.drift(-bird.step_size);
        });
        count_particles(state, bird);
      });
    }

    void add_lists_and_sums()
    {
      add("bird/list", make_settings(1000000), [](benchmark::State &state, const Setting &s, const std::string &key) {
        auto &lists = keep<ListWorkload>(key, s.n, s.n_threads);
        run_loop(state, [&] { lists.list.update(lists.particles, lists.source.pool); });
        state.counters["true_neighbors"] = lists.source.count_true_neighbors();
        count_particles(state, lists.source);
      });
      add("bird/list_check", make_settings(1000000),
          [](benchmark::State &state, const Setting &s, const std::string &key) {
            auto &lists = keep<ListWorkload>(key, s.n, s.n_threads);
            run_loop(state,
                     [&] { benchmark::DoNotOptimize(lists.list.is_outdated(lists.particles, lists.source.pool)); });
            count_particles(state, lists.source);
          });
      add("bird/energies", make_settings(1000000),
          [](benchmark::State &state, const Setting &s, const std::string &key) {
            auto &bird = keep<BirdWorkload>(key, s.n, s.n_threads);
            run_loop(state, [&] {
              benchmark::DoNotOptimize(bird.bird.energies());
              benchmark::DoNotOptimize(bird.bird.momenta());
            });
            count_particles(state, bird);
          });
      add("bird/step_limit", make_settings(1000000),
          [](benchmark::State &state, const Setting &s, const std::string &key) {
            auto &bird = keep<BirdWorkload>(key, s.n, s.n_threads);
            run_loop(state, [&] { benchmark::DoNotOptimize(bird.bird.step_limit().value); });
            count_particles(state, bird);
          });
    }
  } // namespace

  void add_bird_benchmarks()
  {
    add_steps("riemann", 1000000);
    add_steps("linear", 10000);
    add_steps("standard", 10000);
    add_rates("riemann", 1000000);
    for (const char *formulation : {"uncorrected", "linear", "strong", "standard"})
      add_rates(formulation, 100000);
    add_lists_and_sums();
    add_motion();
  }
} // namespace birdstrike::benchmarks
