#include "report/quantities.h"
#include <birdstrike/report/summary.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "recorded_run.h"

using namespace birdstrike;

TEST(Summary, HasTheStableKeys)
{
  const nlohmann::json json = nlohmann::json::parse(to_text(make_empty_summary("")));
  const std::vector<std::pair<std::string, std::vector<std::string>>> keys{
    {"schema", {}},
    {"case", {}},
    {"units", {}},
    {"program", {"version", "build"}},
    {"inputs", {}},
    {"end", {"time", "reason"}},
    {"blade", {"kind", "elements", "nodes", "mass", "added_rotary_inertia", "materials"}},
    {"bird", {"particles", "mass", "kinetic_energy", "momentum"}},
    {"aim",
     {"point", "span", "chord", "velocity", "speed", "angle", "normal_speed", "hugoniot_pressure",
      "stagnation_pressure", "duration"}},
    {"steps", {"blade", "bird", "limited_by"}},
    {"tip", {"peak", "peak_time", "peak_reached", "final"}},
    {"root",
     {"peak_normal_stress", "peak_normal_stress_time", "peak_normal_stress_reached", "peak_moment",
      "peak_moment_reached", "peak_force"}},
    {"contact",
     {"impulse", "peak_force", "peak_force_time", "filtered", "released_energy", "max_penetration",
      "max_penetration_over_spacing"}},
    {"plastic", {"max_strain", "position", "work"}},
    {"failed",
     {"elements", "collapsed", "at_root", "partly", "points", "partly_at", "mass", "free_mass", "fibre_mass",
      "matrix_mass", "energy"}},
    {"energy",
     {"initial", "final", "max_relative_error", "max_hourglass_over_internal", "bird_internal", "parts",
      "error_origins"}},
    {"momentum", {"max_relative_error"}},
    {"angular_momentum", {"max_relative_error"}},
    {"retired", {"particles", "mass", "energy"}},
    {"warnings", {}},
    {"skipped", {}},
    {"cost", {"wall", "threads", "ns_per_particle_step", "ns_per_element_step", "peak_memory"}}};
  EXPECT_EQ(json.size(), keys.size());
  for (const auto &[key, members] : keys)
    {
      ASSERT_TRUE(json.contains(key)) << key;
      EXPECT_TRUE(members.empty() || json[key].size() == members.size()) << key;
      for (const std::string &member : members)
        EXPECT_TRUE(json[key].contains(member)) << key << "/" << member;
    }
  EXPECT_TRUE(json["skipped"].is_object());
  EXPECT_TRUE(json["energy"]["parts"].is_object());
  EXPECT_EQ(json["bird"]["momentum"].size(), 3u);
}

// What a reader finds in `birdstrike columns` and in the attributes of results.h5: no column without words or unit.
TEST(Quantities, EveryColumnHasAUnitAndAMeaning)
{
  for (const Quantity &each : quantities())
    if (!each.column.empty())
      {
        EXPECT_NE(each.unit, "") << each.column;
        EXPECT_GT(each.meaning.size(), 10u) << each.column;
      }
}

namespace
{
  /// Where a run stands that has computed nothing but what a test gives it.
  struct SomeRun
  {
    CaseParameters parameters;
    Observed       observed;
    Balance        balance{1e9};

    RunView view() const
    {
      return {parameters, observed, balance, balance, nullptr, nullptr, false};
    }
  };
} // namespace

// Particles of one bird have one mass, of two birds two: 10 of 1 g and 30 of 0.1 g are 13 g. By the mean mass of all
// 400 (0.22 kg of 200 and 200 particles are 0.55 g each) they were 22 g. To round-off.
TEST(Summary, WeighsWhatLeftByTheBirdItIsOf)
{
  const SomeRun some;
  RunView       run = some.view();
  run.birds.resize(2);
  run.birds[0].at_start  = {200, 0.2, 0., {}};
  run.birds[0].n_retired = 10;
  run.birds[1].at_start  = {200, 0.02, 0., {}};
  run.birds[1].n_retired = 30;
  run.bird_at_start      = {400, 0.22, 0., {}};
  EXPECT_EQ(Summary(run).number("retired/particles"), 40.);
  EXPECT_NEAR(Summary(run).number("retired/mass"), 0.013, 1e-15);
}

TEST(Summary, NamesSkippedWork)
{
  const SomeRun some;
  RunView       run = some.view();
  run.skipped       = {{"flight", 2e-3, "s", 0.25}, {"bird", 1., "part", std::numeric_limits<double>::quiet_NaN()}};
  const auto json   = nlohmann::json::parse(to_text(Summary(run)))["skipped"];
  EXPECT_EQ(json["flight"]["count"], 2e-3);
  EXPECT_EQ(json["flight"]["saved"], 0.25);
  EXPECT_TRUE(json["bird"]["saved"].is_null());
}

TEST(Summary, KeepsEveryDigitAndTurnsNanIntoNull)
{
  SomeRun     some;
  SystemState state;
  state.blade.plastic                  = 12.5;
  state.blade_momentum.contact_impulse = {{1., 2., -3.}};
  some.balance.update(state, 0., 0);
  some.parameters.name = "frontal \"strike\"";
  some.observed.tip_peak.update(1e-3, 0.1 + 0.2);
  some.observed.root_moment.update(0., std::numeric_limits<double>::quiet_NaN());
  RunView run       = some.view();
  run.n_blade_steps = 1234567890123;
  const auto json   = nlohmann::json::parse(to_text(Summary(run)));
  EXPECT_EQ(json["case"], "frontal \"strike\"");
  EXPECT_EQ(json["tip"]["peak"].get<double>(), 0.1 + 0.2);
  EXPECT_TRUE(json["root"]["peak_moment"].is_null());
  EXPECT_EQ(json["contact"]["impulse"], (std::vector<double>{1., 2., -3.}));
  EXPECT_EQ(json["energy"]["parts"]["blade_plastic"], 12.5);
  EXPECT_EQ(json["plastic"]["work"], 12.5) << "the same energy by another key";
  EXPECT_EQ(json["steps"]["blade"], 1234567890123);
}

TEST(Summary, NamesWhatLimitedTheSteps)
{
  SomeRun some;
  RunView run     = some.view();
  run.limiters    = {{"shell element, largest eigenvalue", 900, 1e-6, 2e-3, "element", 17, {{1., 2., 3.}}},
                     {"end of the run", 1, 1e-7, 3e-3, "", 0, {}}};
  const auto json = nlohmann::json::parse(to_text(Summary(run)))["steps"]["limited_by"];
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["reason"], "shell element, largest eigenvalue");
  EXPECT_EQ(json[0]["steps"], 900);
  EXPECT_EQ(json[0]["smallest_step"], 1e-6);
  EXPECT_EQ(json[0]["time"], 2e-3);
  EXPECT_EQ(json[0]["entity"], "element");
  EXPECT_EQ(json[0]["id"], 17);
  EXPECT_EQ(json[0]["position"], (std::vector<double>{1., 2., 3.}));
  EXPECT_FALSE(json[1].contains("entity")) << "no entity ends a run";
}

TEST(Summary, APeakAtTheLastInstantIsNotReached)
{
  SomeRun some;
  some.observed.tip_peak.update(1e-3, 0.1);
  some.observed.root_stress.update(1e-3, 1e9);
  RunView run = some.view();
  run.time    = 1e-3;
  EXPECT_TRUE(Summary(run).is_false("tip/peak_reached"));
  EXPECT_TRUE(Summary(run).is_false("root/peak_normal_stress_reached"));
  run.time = 1.001e-3;
  EXPECT_EQ(Summary(run).json["tip"]["peak_reached"], true);
  EXPECT_FALSE(Summary(run).is_false("root/peak_normal_stress_reached"));
}

// The tip swings backwards first, by a hundredth of what is to come: -2 mm at 0.3 ms of a peak of 177 mm at 8 ms.
TEST(Summary, NoPeakIsReachedWhileTheBirdPushes)
{
  SomeRun some;
  some.observed.tip_peak.update(0.3e-3, -2e-3);
  some.observed.root_stress.update(0.3e-3, 1e9);
  some.observed.smooth_peak = 1e4;
  ContactReport contact{};
  const auto    push = [&](const double force, const int n_steps) { // N, in steps of 1 us
    contact.force = {{0., 0., force}};
    for (int k = 0; k < n_steps; ++k)
      some.observed.contact.update(contact, 1e-6);
  };
  push(101., 600);
  RunView run = some.view();
  run.time    = 0.6e-3;
  run.contact = &contact;
  EXPECT_TRUE(Summary(run).is_false("tip/peak_reached"));
  EXPECT_TRUE(Summary(run).is_false("root/peak_normal_stress_reached"));
  run.end_reason = EndReason::tip_peak;
  EXPECT_EQ(Summary(run).json["tip"]["peak_reached"], true) << "it has been seen to turn back";
  EXPECT_TRUE(Summary(run).is_false("root/peak_normal_stress_reached")) << "of the root nothing was seen";
  run.end_reason = EndReason::end_time;
  push(99., 260);
  EXPECT_EQ(Summary(run).json["tip"]["peak_reached"], true);
  push(0., 300);
  push(5000., 1); // a drop that has come late
  EXPECT_EQ(Summary(run).json["tip"]["peak_reached"], true);
  EXPECT_NEAR(run.closing_force(), 0.5 * 5000. / 250., 0.3);
}

TEST(Summary, HoldsTheFilteredPeak)
{
  SomeRun some;
  EXPECT_TRUE(std::isnan(Summary(some.view()).number("contact/filtered/peak_force"))) << "there was no contact";
  some.observed.filtered_force      = {0., 5e-6, {{3., 0., 4.}}, 5., 1e-3};
  const nlohmann::ordered_json json = Summary(some.view()).json["contact"]["filtered"];
  EXPECT_EQ(json["class"], "CFC 1000");
  EXPECT_EQ(json["peak_force"], 5.);
  EXPECT_EQ(json["peak_time"], 1e-3);
}

TEST(Summary, WhatNeverLeftZeroHasNoPeak)
{
  SomeRun some; // neither tip nor root
  some.observed.root_stress.update(0., 0.);
  some.observed.tip_peak.update(0., 0.);
  const nlohmann::json json = nlohmann::json::parse(to_text(Summary(some.view())));
  EXPECT_EQ(json["tip"]["peak"], 0.) << "a number still: scripts format it";
  EXPECT_TRUE(json["tip"]["peak_reached"].is_null());
  for (const char *key : {"peak_normal_stress_reached", "peak_moment_reached"})
    EXPECT_TRUE(json["root"][key].is_null()) << key;
  EXPECT_FALSE(Summary(some.view()).is_false("tip/peak_reached")) << "what is absent says nothing";
}

TEST(Summary, ReadsWhatItHoldsByPaths)
{
  Summary summary                    = make_empty_summary("plate");
  summary.json["contact"]["impulse"] = {3., 0., -4.};
  EXPECT_EQ(summary.number("contact/impulse/2"), -4.);
  EXPECT_EQ(summary.text("case"), "plate");
  EXPECT_TRUE(std::isnan(summary.number("tip/none")));
  EXPECT_TRUE(std::isnan(summary.number("case"))) << "no number";
  EXPECT_EQ(Summary().text("case"), "");
}

// Each quantity once: a name in history.csv or a key of summary.json belongs to one row of the table.
TEST(Quantities, HaveNamesOfTheirOwn)
{
  std::set<std::string> columns, keys;
  for (const Quantity &each : quantities())
    {
      EXPECT_TRUE(!each.column.empty() || !each.key.empty());
      EXPECT_TRUE(each.column.empty() || columns.insert(each.column).second) << each.column;
      EXPECT_TRUE(each.key.empty() || keys.insert(each.key).second) << each.key;
    }
  for (const LedgerEntry &entry : ledger)
    EXPECT_TRUE(columns.contains(std::string(entry.column))) << entry.name << " is in the ledger and nowhere shown";
}

TEST(Summary, PeakMemoryGrowsWithWhatIsTouched)
{
  const std::size_t       before = compute_peak_memory();
  const std::vector<char> block(2 * before, 'x');
  EXPECT_GE(compute_peak_memory(), 2 * before) << block.back();
}
