#include "strike_harness.h"

#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/core/prices.h>
#include <birdstrike/simulation/commands.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace birdstrike;
using namespace birdstrike::test;

/// What a scene does not need is not computed: counted, not timed.
namespace
{
  Strike run_coarsely(std::vector<std::string> more, const std::string &file = "quickstart.prm")
  {
    more.insert(more.begin(), {"Bird/Particle spacing=0.005", "Blade/Mesh/Elements along span=20",
                               "Blade/Mesh/Elements along chord=6"});
    return run_shipped(file, more);
  }

  double count_of(const Strike &run, const std::string &what)
  {
    const double count = run.summary.number("skipped/" + what + "/count");
    return std::isnan(count) ? 0. : count;
  }
} // namespace

TEST(Skipping, ARigidTargetHasNoFiniteElements)
{
  const Strike run = run_shipped("rigid-plate.prm", {"Time/End time=5e-6"});
  EXPECT_EQ(run.summary.number("steps/blade"), 0u);
  EXPECT_EQ(run.summary.number("cost/ns_per_element_step"), 0.) << "no element-step was counted";
  EXPECT_EQ(count_of(run, "finite elements of the rigid target"), 1.);
}

TEST(Skipping, ABladeAloneHasNoParticles)
{
  const Strike run = run_shipped("blade-impulse.prm", {"Time/End time=50e-6"});
  EXPECT_EQ(run.summary.number("bird/particles"), 0u);
  EXPECT_EQ(run.summary.number("steps/bird"), 0u);
  EXPECT_EQ(run.summary.number("cost/ns_per_particle_step"), 0.) << "no particle-step was counted";
  EXPECT_EQ(count_of(run, "bird"), 1.);
  EXPECT_EQ(count_of(run, "contact"), 1.);
}

TEST(Skipping, TheFlightBeforeFirstTouchIsNotComputed)
{
  const Strike near = run_coarsely({"Time/End time=20e-6", "Bird/Stand-off=0.05"}),
               far  = run_coarsely({"Time/End time=20e-6", "Bird/Stand-off=0.5"});
  EXPECT_EQ(near.summary.number("steps/bird"), far.summary.number("steps/bird"));
  EXPECT_NEAR(count_of(far, "flight before first touch") - count_of(near, "flight before first touch"), 0.45 / 177.4,
              1e-12);
}

TEST(Skipping, RetiredParticlesTakeNoSteps)
{
  const Strike run =
    run_coarsely({"Time/End time=1.4e-3", "Output/History interval=0", "Time/Multirate=false"}, "oblique.prm");
  const auto &n = run.curves.at("particles");
  ASSERT_EQ(n.size(), run.summary.number("steps/bird") + 1) << "one row before the first step and one after each";
  const double present = std::accumulate(n.begin(), n.end() - 1, 0.);
  const double all     = static_cast<double>(run.summary.number("bird/particles") * run.summary.number("steps/bird"));
  EXPECT_GT(all - present, 0.1 * all);
  EXPECT_EQ(count_of(run, "removed particles"), all - present);
}

TEST(Skipping, ContactRestsWhileBoxesAreApart)
{
  CaseParameters parameters;
  parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/quickstart.prm",
                  {"Bird/Particle spacing=0.005", "Blade/Mesh/Elements along span=20",
                   "Blade/Mesh/Elements along chord=6", "Time/End time=0.2e-3"});
  Scene scene(parameters);
  scene.birds.front().bird->advance_in_flight(-0.15e-3); // 27 mm back: the search looks 5 mm ahead
  BirdStrike strike(parameters, scene);
  strike.run();
  const ContactReport &report = scene.birds.front().contact->report();
  EXPECT_GT(report.skipped, report.calls / 2);
  EXPECT_LE(report.searches + report.reused, report.calls - report.skipped);
  const Strike run{strike.compute_summary(), {}};
  EXPECT_EQ(count_of(run, "contact steps with boxes apart"), static_cast<double>(report.skipped));
}

TEST(Skipping, ABirdThatCanGiveNothingMoreIsDropped)
{
  const Strike kept    = run_coarsely({"Time/End time=7e-3", "Time/Bird phase tolerance=0"}),
               dropped = run_coarsely({"Time/End time=7e-3", "Time/Bird phase tolerance=1e-3"});
  EXPECT_GT(count_of(dropped, "bird and contact after the bird's phase"), 0.1 * kept.summary.number("steps/bird"));
  EXPECT_LT(dropped.summary.number("steps/bird"), 0.9 * kept.summary.number("steps/bird"));
  EXPECT_NEAR(dropped.summary.number("contact/impulse/2") / kept.summary.number("contact/impulse/2"), 1., 1e-3);
  EXPECT_NEAR(dropped.summary.number("tip/peak") / kept.summary.number("tip/peak"), 1., 2e-3);
  // its energy and momentum stay in the books
  EXPECT_LT(dropped.summary.number("momentum/max_relative_error"), 1e-8);
  EXPECT_LT(dropped.summary.number("energy/max_relative_error"), 5e-3);
  EXPECT_EQ(dropped.summary.number("energy/parts/bird_kinetic"), 0.);
}

// The forecast is no simulation: within a factor of 1.5 of how long particles were computed in the mean.
TEST(Skipping, TheForecastOfTheRunTimeKnowsWhenParticlesLeave)
{
  const double end      = 7e-3;
  const auto   forecast = [](const double end_time, const std::string &retires) {
    return forecast_run_time(BIRDSTRIKE_SOURCE_DIR "/prm/quickstart.prm",
                               {"Bird/Particle spacing=0.005", "Blade/Mesh/Elements along span=20",
                              "Blade/Mesh/Elements along chord=6", "Bird/Retire=" + retires,
                              fmt::format("Time/End time={:g}", end_time)});
  };
  // the start of the program, and the blade: by then the bird has gone
  const double others = forecast(1e-6, "true") + forecast(2. * end, "true") - forecast(end, "true");
  const double share  = (forecast(end, "true") - others) / (forecast(end, "false") - others);
  // Liquid until it has spread over four diameters, spray at a quarter of its price after that, contact always: from
  // the share of the cost to that of the particles' time.
  constexpr double contact = prices::contact_particle / prices::riemann_particle, spray = prices::spray_share;
  const double     dense   = (1. - spray) * 4. * 0.04069 / 177.4;
  const double     present = (share * (dense + (spray + contact) * end) - dense) / ((spray + contact) * end);
  const Strike     run     = run_coarsely({fmt::format("Time/End time={:g}", end), "Time/Bird phase tolerance=0"});
  const double     all     = run.summary.number("bird/particles") * run.summary.number("steps/bird");
  EXPECT_NEAR(std::log(present / (1. - count_of(run, "removed particles") / all)), 0., std::log(1.5));
}

TEST(Skipping, AStopAtTheTipPeakReportsWhatTheFullRunDoes)
{
  const Strike full  = run_coarsely({"Time/End time=16e-3"}),
               early = run_coarsely({"Time/End time=16e-3", "Time/Stop at tip peak=true"});
  EXPECT_EQ(early.summary.text("end/reason"), "tip peak passed");
  EXPECT_EQ(early.summary.number("tip/peak"), full.summary.number("tip/peak"));
  EXPECT_EQ(early.summary.number("tip/peak_time"), full.summary.number("tip/peak_time"));
  EXPECT_LT(value_at(early.curves, "tip_mid_chord", 0.25e-3), 0.) << "the tip has moved backwards before";
  EXPECT_NEAR(early.summary.number("end/time"), full.summary.number("tip/peak_time") + 1e-3, 0.05e-3);
  EXPECT_GT(count_of(early, "time after the tip's peak"), 1e-3);
}
