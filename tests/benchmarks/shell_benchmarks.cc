#include "measure.h"
#include "shell_workload.h"

#include "structure/deformable_blade.h"

namespace birdstrike::benchmarks
{
  namespace
  {
    Work work_of(const ShellCase &what)
    {
      switch (what.formulation)
        {
        case ShellFormulation::one_point_physical:
          return shell_work(what.is_plastic, what.n_points);
        case ShellFormulation::fully_integrated:
          return full_shell_work(what.is_plastic, what.n_points);
        default:
          return {}; // not counted
        }
    }

    void add_elements(const std::string &name, const ShellCase &what, const std::size_t largest)
    {
      for (const Setting &setting : make_settings(largest))
        add(
          "shell/forces/" + name, {setting},
          [=](benchmark::State &state, const Setting &s, const std::string &key) {
            // a plastic plate is stretched on from where the last repetition left it: 200 steps are 0.4 % of strain
            auto        &shell = keep<ShellWorkload>(key, s.n, s.n_threads, what);
            const double bytes = slot.bytes, n = static_cast<double>(shell.n());
            run_loop(state, [&] { shell.step(); });
            state.counters["promoted_share"]    = static_cast<double>(shell.elements.n_promoted()) / n;
            state.counters["bytes_per_element"] = bytes / n;
            count_work(state, n, "element", work_of(what));
          },
          setting.n < 100000 ? 200 : 20);
    }

    /// A blade of the scene: deal.II mesh, supports, kicks and drift around the elements.
    struct BladeWorkload
    {
      BladeWorkload(const std::size_t n, const std::size_t n_threads)
        : pool(n_threads), blade(make_parameters(n), pool), step_size(0.9 * blade.step_limit().value)
      {
      }

      void step()
      {
        blade.kick_internal(0.5 * step_size, HalfKick::first);
        blade.drift(step_size);
        blade.compute_internal_forces();
        blade.kick_internal(0.5 * step_size, HalfKick::second);
      }

      static BladeParameters make_parameters(const std::size_t n)
      {
        BladeParameters   p;
        const std::size_t n_span = static_cast<std::size_t>(std::sqrt(2. * static_cast<double>(n)));
        p.mesh.n_span            = static_cast<unsigned int>(n_span);
        p.mesh.n_chord           = static_cast<unsigned int>(n / n_span);
        p.mesh.length            = 5e-3 * p.mesh.n_span;
        p.mesh.chord             = 5e-3 * p.mesh.n_chord;
        p.material.hardening     = "linear";
        p.material.modulus       = "1.25e9";
        p.supports.clamped       = "";
        p.loads.initial_velocity = "x; 0; 0"; // far from yielding
        return p;
      }

      ThreadPool pool;
      ShellBlade blade;
      double     step_size; ///< s
    };

    void add_blades()
    {
      // a yielding blade costs as much more as its elements: shell/forces
      for (const Setting &setting : make_settings(100000))
        add(
          "shell/step/elastic", {setting},
          [](benchmark::State &state, const Setting &s, const std::string &key) {
            auto &blade = keep<BladeWorkload>(key, s.n, s.n_threads);
            run_loop(state, [&] { blade.step(); });
            state.counters["bytes_per_element"] = slot.bytes / static_cast<double>(blade.blade.n_elements());
            count_work(state, static_cast<double>(blade.blade.n_elements()), "element");
          },
          setting.n < 100000 ? 200 : 20);
      add("shell/kick_and_drift", make_settings(100000),
          [](benchmark::State &state, const Setting &s, const std::string &key) {
            auto &blade = keep<BladeWorkload>(key, s.n, s.n_threads);
            run_loop(state, [&] {
              blade.blade.kick_internal(0.5 * blade.step_size, HalfKick::first);
              blade.blade.drift(blade.step_size);
              blade.blade.kick_internal(-0.5 * blade.step_size, HalfKick::second);
              blade.blade.drift(-blade.step_size);
            });
            count_work(state, static_cast<double>(blade.blade.n_elements()), "element");
          });
      add("shell/energies", make_settings(100000),
          [](benchmark::State &state, const Setting &s, const std::string &key) {
            auto &blade = keep<BladeWorkload>(key, s.n, s.n_threads);
            run_loop(state, [&] {
              benchmark::DoNotOptimize(blade.blade.energies());
              benchmark::DoNotOptimize(blade.blade.momenta());
            });
            count_work(state, static_cast<double>(blade.blade.n_elements()), "element");
          });
      add("shell/step_limit", make_settings(100000),
          [](benchmark::State &state, const Setting &s, const std::string &key) {
            auto &blade = keep<BladeWorkload>(key, s.n, s.n_threads);
            run_loop(state, [&] { benchmark::DoNotOptimize(blade.blade.step_limit().value); });
            count_work(state, static_cast<double>(blade.blade.n_elements()), "element");
          });
    }
  } // namespace

  void add_shell_benchmarks()
  {
    using enum ShellFormulation;
    add_elements("physical/elastic", {one_point_physical, 5, false}, 1000000);
    add_elements("physical/plastic_5", {one_point_physical, 5, true}, 1000000);
    add_elements("physical/plastic_3", {one_point_physical, 3, true}, 10000);
    add_elements("physical/plastic_7", {one_point_physical, 7, true}, 10000);
    add_elements("belytschko_tsay/elastic", {belytschko_tsay, 5, false}, 10000);
    add_elements("belytschko_tsay/plastic_5", {belytschko_tsay, 5, true}, 10000);
    add_elements("fully_integrated/elastic", {fully_integrated, 5, false}, 100000);
    add_elements("fully_integrated/plastic_5", {fully_integrated, 5, true}, 100000);
    add_blades();
  }
} // namespace birdstrike::benchmarks
