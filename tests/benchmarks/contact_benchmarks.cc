#include "contact_workload.h"
#include "measure.h"

namespace birdstrike::benchmarks
{
  namespace
  {
    /// Pairs whose closest points were computed so far, where the report counts them: a list may let pairs sleep.
    template <class Report>
    double count_tested_pairs(const Report &report)
    {
      if constexpr (requires { report.pairs_tested; })
        return static_cast<double>(report.pairs_tested);
      else
        return 0.;
    }

    /// Runs `step` and notes what contact did, by the report or, where that is silent, by the facets in reach.
    template <class Step>
    void run_contact(benchmark::State &state, ContactWorkload &contact, const Step &step)
    {
      const auto   before = contact.contact.report();
      const double n      = static_cast<double>(contact.n_near());
      run_loop(state, step);
      const auto   after  = contact.contact.report();
      const double calls  = static_cast<double>(state.iterations());
      const double tested = count_tested_pairs(after) - count_tested_pairs(before);
      const double pairs  = tested > 0. ? tested / (calls * n) : contact.count_pairs();

      state.counters["touching_share"]       = static_cast<double>(after.n_touching) / n;
      state.counters["searches_per_call"]    = static_cast<double>(after.searches - before.searches) / calls;
      state.counters["pairs_per_near_point"] = pairs;
      count_work(state, n, "near_point", contact_work(pairs));
    }
  } // namespace

  void add_contact_benchmarks()
  {
    /// Candidate list as it stands, all points near: closest points, sides, forces, scatter.
    add("contact/forces", make_settings(100000), [](benchmark::State &state, const Setting &s, const std::string &key) {
      auto &contact                          = keep<ContactWorkload>(key, s.n, std::size_t(0), s.n_threads);
      state.counters["bytes_per_near_point"] = slot.bytes / static_cast<double>(contact.n_near());
      run_contact(state, contact, [&] { contact.compute_forces(); });
    });
    /// As in a step: eight layers of points that are not near, sliding points, lists rebuilt as they wear out.
    add(
      "contact/step", make_settings(100000),
      [](benchmark::State &state, const Setting &s, const std::string &key) {
        auto &contact = keep<ContactWorkload>(key, s.n, std::size_t(8), s.n_threads);
        run_contact(state, contact, [&] { contact.slide(); });
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
