#include "measure.h"

#include "simulation/scene.h"
#include "simulation/stepper.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/structure/blade.h>

namespace birdstrike::benchmarks
{
  namespace
  {
    /// prm/frontal.prm brought to the start of a phase; a macro step is the plan of the next step and the step itself.
    struct Phase
    {
      Phase(const std::vector<std::string> &overrides, const double start)
      {
        parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/frontal.prm", overrides);
        scene.emplace(parameters);
        stepper.emplace(*scene, timings);
        stepper->compute_initial_forces(scene->plan(1.).bird_step());
        while (now < start)
          step();
      }

      void step()
      {
        const Schedule schedule = scene->plan(1.);
        stepper->advance(schedule);
        now += schedule.step;
      }

      CaseParameters         parameters;
      Timings                timings;
      std::optional<Scene>   scene;
      std::optional<Stepper> stepper;
      double                 now = 0.; ///< s since first touch
    };

    /// A tenth of a million particles, and a million, take minutes to reach a phase: the scene is measured at the sizes
    /// in which it is run.
    struct Size
    {
      std::string              name;
      std::vector<std::string> overrides;
    };

    const std::vector<Size> &sizes()
    {
      static const std::vector<Size> all = {
        {"particles:1700",
         {"Bird/Particle spacing=0.004", "Blade/Mesh/Elements along span=31", "Blade/Mesh/Elements along chord=9"}},
        {"particles:6800", {}},
        {"particles:20000",
         {"Bird/Particle spacing=0.00174", "Blade/Mesh/Elements along span=131",
          "Blade/Mesh/Elements along chord=38"}}};
      return all;
    }

    void add_phase(const std::string &phase, const Size &size, const double start,
                   const std::vector<std::string> &more = {})
    {
      for (const std::size_t n_threads : {1ul, 2ul})
        add(
          "scene/" + phase + "/" + size.name, {{0, n_threads, 3}},
          [=](benchmark::State &state, const Setting &s, const std::string &) {
            std::vector<std::string> overrides = size.overrides;
            overrides.insert(overrides.end(), more.begin(), more.end());
            overrides.push_back("Time/Threads=" + std::to_string(s.n_threads));
            slot = {};
            Phase        scene(overrides, start);
            const auto   before = scene.stepper->counts();
            const double from   = scene.now;
            run_loop(state, [&] { scene.step(); });
            const double steps = static_cast<double>(state.iterations());
            const auto   after = scene.stepper->counts();
            state.counters["particle_steps"] =
              static_cast<double>(after.particle_steps - before.particle_steps) / steps;
            state.counters["element_steps"] =
              static_cast<double>((after.blade - before.blade) * scene.scene->blade->n_elements()) / steps;
            state.counters["simulated_ns_per_step"] = 1e9 * (scene.now - from) / steps;
            const bool   has_bird                   = !scene.scene->birds.empty();
            const double units =
              has_bird ? state.counters["particle_steps"].value : state.counters["element_steps"].value;
            count_work(state, units, has_bird ? "particle" : "element");
          },
          100);
    }
  } // namespace

  void add_scene_benchmarks()
  {
    for (const Size &size : sizes())
      {
        add_phase("early_impact", size, 5e-6);
        add_phase("peak_flow", size, 100e-6);
        add_phase("blade_only", size, 5e-6, {"Bird/Enabled=false", "Blade/Loads/Initial velocity=0; 0; 100*x"});
      }
  }
} // namespace birdstrike::benchmarks
