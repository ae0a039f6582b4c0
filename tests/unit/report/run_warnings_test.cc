#include "report/run_warnings.h"

#include <gtest/gtest.h>

#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/run_view.h>
#include <birdstrike/report/summary.h>

#include <cmath>
#include <optional>

using namespace birdstrike;

namespace
{
  /// A run of 10 ms of which nothing is doubtful, until a test makes it so.
  struct SoundRun
  {
    CaseParameters parameters;
    Observed       observed;
    Balance        balance{INFINITY};

    std::optional<ContactReport> contact = {};

    SoundRun()
    {
      parameters.blade.kind = BladeKind::shell;
      observed.tip_peak.update(5e-3, 0.1);
      observed.root_stress.update(5e-3, 1e9);
      observed.root_moment.update(5e-3, 400.);
      book(1000., 0);
    }

    void book(const double kinetic, const unsigned long step)
    {
      SystemState state;
      state.blade.kinetic = kinetic;
      balance.update(state, 1e-6 * step, step);
    }

    /// A bird pushes with `force` (N) until `end` (s), after a first touch of 1 MN for a microsecond, and has been gone
    /// for 0.3 ms afterwards, or has not.
    void push(const double force, const double end, const double channel_class, const bool has_gone)
    {
      constexpr double step = 0.1e-6, first = 1e-6;
      observed.contact = ContactWatch(channel_class);
      const long n = std::lround(end / step), n_gone = has_gone ? std::lround(0.3e-3 / step) : 0;
      for (long k = 0; k <= n + n_gone; ++k)
        {
          contact.emplace().force = {k * step < first ? 1e6 : k > n ? 0. : force, 0., 0.};
          observed.contact.update(*contact, step);
        }
      observed.force = contact->force;
      observed.filter_force(channel_class);
    }

    std::vector<std::string> codes(const double end = 10e-3) const
    {
      RunView run{parameters, observed, balance, balance, nullptr, contact ? &*contact : nullptr, false};
      run.time = end;
      std::vector<std::string> all;
      for (const Warning &warning : find_run_warnings(run))
        {
          all.push_back(warning.code);
          EXPECT_TRUE(warning.text.ends_with(".")) << warning.text;
        }
      return all;
    }
  };

  using Codes = std::vector<std::string>;
} // namespace

TEST(RunWarnings, ASoundRunHasNone)
{
  EXPECT_EQ(SoundRun().codes(), Codes{});
}

TEST(RunWarnings, EnergyThatDrifts)
{
  SoundRun run;
  run.book(1005., 1);
  EXPECT_EQ(run.codes(), Codes{}) << "half a percent";
  run.book(1020., 2);
  run.book(1000., 3); // back again: the largest error counts
  EXPECT_EQ(run.codes(), Codes{"balance/energy"});
}

TEST(RunWarnings, HourglassOverTheUsualLimit)
{
  SoundRun run;
  run.observed.hourglass_share.update(0., 0.099);
  EXPECT_EQ(run.codes(), Codes{});
  run.observed.hourglass_share.update(0., 0.101);
  EXPECT_EQ(run.codes(), Codes{"balance/hourglass"});
}

TEST(RunWarnings, PeaksThatAreTheEndOfTheRun)
{
  const SoundRun run;
  EXPECT_EQ(run.codes(5e-3), (Codes{"peak/not_reached", "peak/not_reached", "peak/not_reached"}));
}

TEST(RunWarnings, StrainBeyondTheElongation)
{
  SoundRun run; // Ti-6Al-4V tears at 14 %: true strain 0.131
  run.observed.plastic = {{.value = 0.130}};
  EXPECT_EQ(run.codes(), Codes{});
  run.observed.plastic = {{.value = 0.132}};
  EXPECT_EQ(run.codes(), Codes{"metal/elongation"});
  run.parameters.blade.material.elongation = "0.2";
  EXPECT_EQ(run.codes(), Codes{});
  run.parameters.blade.material.elongation  = "table";
  run.parameters.blade.material.failure.law = FailureLaw::plastic_strain;
  EXPECT_EQ(run.codes(), Codes{}) << "it tears where it must";
}

// Al 2024 has no elongation but damage constants: slow tension breaks it at 0.13 + 0.13 exp(-1.5/3) = 0.2088.
TEST(RunWarnings, StrainBeyondTheDamageOfAMetalWithoutElongation)
{
  SoundRun run;
  run.parameters.blade.material.name = "Al 2024 Johnson-Cook";
  run.observed.plastic               = {{.value = 0.208}};
  EXPECT_EQ(run.codes(), Codes{});
  run.observed.plastic = {{.value = 0.209}};
  EXPECT_EQ(run.codes(), Codes{"metal/elongation"});
  run.parameters.blade.material.elongation = "0.3"; // what is given comes first: true strain 0.262
  EXPECT_EQ(run.codes(), Codes{});
  run.parameters.blade.material.elongation  = "table";
  run.parameters.blade.material.failure.law = FailureLaw::johnson_cook;
  EXPECT_EQ(run.codes(), Codes{}) << "it tears where it must";
}

TEST(RunWarnings, AMetalOfWhichNothingIsKnownIsSaidToBeSo)
{
  SoundRun run;
  auto    &metal = run.parameters.blade.material;
  metal.name     = "custom";
  metal.density = metal.young = metal.yield = "1e6";
  metal.poisson                             = "0.3";
  run.observed.plastic                      = {{.value = 0.049}};
  EXPECT_EQ(run.codes(), Codes{});
  run.observed.plastic = {{.value = 0.051}};
  EXPECT_EQ(run.codes(), Codes{"metal/no_elongation"});
  metal.failure.law = FailureLaw::plastic_strain;
  EXPECT_EQ(run.codes(), Codes{}) << "it tears where it must";
}

// A soft skin may be strained as far as it bears, whatever the metal below it would bear: each section is held against
// its own metal, and of a row, whose sections come again, the blade that is strained most.
TEST(RunWarnings, EachSectionsStrainAgainstItsOwnMetal)
{
  SoundRun run; // the blade's own: Ti-6Al-4V, 0.131
  auto    &skin            = run.parameters.blade.sections[0];
  skin.material_ids        = "1";
  skin.material            = run.parameters.blade.material;
  skin.material.elongation = "0.5"; // true strain 0.405
  run.observed.plastic     = {{.value = 0.130, .section = 0}, {.value = 0.404, .section = 1}};
  EXPECT_EQ(run.codes(), Codes{});
  run.observed.plastic = {{.value = 0.001, .section = 0}, {.value = 0.406, .section = 1}};
  EXPECT_EQ(run.codes(), Codes{"metal/elongation"});
  run.observed.plastic = {{.value = 0.001, .section = 0}, {.value = 0.132, .section = 0}};
  EXPECT_EQ(run.codes(), Codes{"metal/elongation"});
  run.observed.plastic = {{.value = 0.132, .section = 0}, {.value = 0.406, .section = 1}};
  EXPECT_EQ(run.codes(), (Codes{"metal/elongation", "metal/elongation"}));
}

TEST(RunWarnings, ElementsThatFailInPartAndWhatHangsOnThem)
{
  SoundRun run;
  run.observed.failure.n_partly = 3;
  run.observed.failure.n_points = 5;
  EXPECT_EQ(run.codes(), Codes{"metal/partly_failed"});
  run.observed.failure.n_at_root    = 1;
  run.observed.failure.has_lost_tip = true;
  EXPECT_EQ(run.codes(), (Codes{"metal/partly_failed", "metal/failed_at_root", "metal/lost_tip"}));
}

// 5 kN are half a percent of the first touch as it is and more than 1 % of what a channel shows of it, in 2 us (one
// interval of the filter is 5 us) as in 2 ms. Whether anybody has asked for the channel does not matter.
TEST(RunWarnings, ABirdThatStillPushes)
{
  for (const double channel_class : {1000., 0.})
    for (const double end : {2e-6, 4.9e-6, 30e-6, 2e-3})
      {
        SoundRun run;
        run.push(5e3, end, channel_class, false);
        EXPECT_EQ(run.codes(), (Codes{"peak/not_reached", "contact/unfinished"}))
          << channel_class << " Hz, " << end << " s";
        EXPECT_EQ(run.observed.filtered_force.values.empty(), channel_class == 0.);
        run.push(5e3, end, channel_class, true);
        EXPECT_EQ(run.codes(), Codes{}) << channel_class << " Hz, " << end << " s";
      }
}

TEST(RunWarnings, StandInTheSummaryAfterThoseOfTheCase)
{
  SoundRun run;
  run.observed.failure.n_partly = 1;
  RunView view{run.parameters, run.observed, run.balance, run.balance, nullptr, nullptr, false};
  view.time          = 10e-3;
  view.case_warnings = {{"unit/speed", "Fast."}};
  const Warnings all = Summary(view).warnings();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].code, "unit/speed");
  EXPECT_EQ(all[0].text, "Fast.");
  EXPECT_EQ(all[1].code, "metal/partly_failed");
}
