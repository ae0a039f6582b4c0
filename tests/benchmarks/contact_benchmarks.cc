#include "contact_workload.h"
#include "measure.h"

namespace birdstrike::benchmarks
{
  void add_contact_benchmarks()
  {
    /// Candidate list as it stands, all points near: closest points, sides, forces, scatter.
    add("contact/forces", make_settings(100000), [](benchmark::State &state, const Setting &s, const std::string &key) {
      auto        &contact = keep<ContactWorkload>(key, s.n, std::size_t(0), s.n_threads);
      const double bytes   = slot.bytes;
      run_loop(state, [&] { contact.compute_forces(); });
      state.counters["touching_share"] =
        static_cast<double>(contact.contact.report().n_touching) / static_cast<double>(contact.n_near());
      const double pairs                     = contact.count_pairs();
      state.counters["pairs_per_near_point"] = pairs;
      state.counters["bytes_per_near_point"] = bytes / static_cast<double>(contact.n_near());
      count_work(state, static_cast<double>(contact.n_near()), "near_point", contact_work(pairs));
    });
    /// As in a step: eight layers of points that are not near, sliding points, lists rebuilt as they wear out.
    add(
      "contact/step", make_settings(100000),
      [](benchmark::State &state, const Setting &s, const std::string &key) {
        auto               &contact = keep<ContactWorkload>(key, s.n, std::size_t(8), s.n_threads);
        const std::uint64_t before  = contact.contact.report().searches;
        run_loop(state, [&] { contact.slide(); });
        state.counters["searches_per_step"] =
          static_cast<double>(contact.contact.report().searches - before) / static_cast<double>(state.iterations());
        count_work(state, static_cast<double>(contact.n_near()), "near_point");
        contact.slide_back();
      },
      200);
    /// A new list at every call, and its forces.
    add("contact/search_and_forces", make_settings(100000),
        [](benchmark::State &state, const Setting &s, const std::string &key) {
          auto &contact = keep<ContactWorkload>(key, s.n, std::size_t(8), s.n_threads);
          run_loop(state, [&] { contact.search(); });
          count_work(state, static_cast<double>(contact.n_near()), "near_point");
        });
  }
} // namespace birdstrike::benchmarks
