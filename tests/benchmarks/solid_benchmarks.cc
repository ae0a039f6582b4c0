#include "measure.h"
#include "solid_workload.h"

namespace birdstrike::benchmarks
{
  namespace
  {
    void add_elements(const std::string &name, const SolidCase &what, const std::size_t largest)
    {
      for (const Setting &setting : make_settings(largest))
        add(
          "solid/forces/" + name, {setting},
          [=](benchmark::State &state, const Setting &s, const std::string &key) {
            // a plastic plate is stretched on from where the last repetition left it: 200 steps are 0.4 % of strain
            auto        &solid = keep<SolidWorkload>(key, s.n, s.n_threads, what);
            const double bytes = slot.bytes, n = static_cast<double>(solid.n());
            run_loop(state, [&] { solid.step(); });
            state.counters["bytes_per_element"] = bytes / n;
            count_work(state, n, "element", solid_work(what.formulation, what.is_plastic));
          },
          setting.n < 100000 ? 200 : 20);
    }
  } // namespace

  void add_solid_benchmarks()
  {
    using enum SolidFormulation;
    add_elements("one_point/elastic", {one_point, false}, 1000000);
    add_elements("one_point/plastic", {one_point, true}, 1000000);
    add_elements("solid_shell/elastic", {solid_shell, false}, 1000000);
    add_elements("solid_shell/plastic", {solid_shell, true}, 1000000);
    add_elements("b_bar/elastic", {b_bar, false}, 10000);
    add_elements("b_bar/plastic", {b_bar, true}, 100000);
  }
} // namespace birdstrike::benchmarks
