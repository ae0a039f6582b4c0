#include "crossings.h"
#include "folded_sheet.h"
#include "strike_harness.h"

#include "simulation/stepper.h"
#include <birdstrike/contact/self_contact.h>
#include <birdstrike/structure/blade.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace birdstrike;
using namespace birdstrike::test;
using namespace birdstrike::test::folded_sheet;

// A sheet folded to a U: two legs of 100 mm, 20 mm apart, joined and held at the riser x = 0. The bird throws the upper
// leg onto the lower one. Without self-contact the two pass through each other, in silence.
namespace
{
  struct Outcome
  {
    std::size_t           crossings = 0, touches = 0; ///< worst, sum
    double                deepest      = 0.;          ///< m, largest depth of a touch
    double                energy_error = 0., momentum_error = 0., dissipated = 0., fall = 0.;
    std::array<double, 3> momentum{};
    std::uint64_t         n_tested = 0;
  };

  /// A brick has no thickness beyond its skin: nodes are within it by 2.2 steps' flight of the legs, which approach at
  /// 60 m/s. A tenth of a millimetre on either side is a fifteenth of the thickness.
  constexpr double depth_of_bricks = 0.1e-3;

  /// Runs the strike and looks every ten steps whether anything goes through anything.
  Outcome run_folded(const bool is_solid, const std::vector<std::string> &overrides = {})
  {
    std::string                 pattern = (std::filesystem::temp_directory_path() / "birdstrike-fold-XXXXXX").string();
    const std::filesystem::path folder  = mkdtemp(pattern.data());
    std::ofstream(folder / "folded.msh") << folded_mesh(is_solid);
    std::ofstream(folder / "case.prm") << folded_case(is_solid, (folder / "folded.msh").string());
    CaseParameters parameters;
    parameters.read((folder / "case.prm").string(), overrides);
    std::filesystem::remove_all(folder / "case.prm");

    const double depth = is_solid ? depth_of_bricks : 0.;

    Scene    scene(parameters);
    Timings  timings;
    Stepper  stepper(scene, timings);
    Balance  balance(10.);
    Outcome  result;
    Schedule schedule = scene.plan(parameters.time.end_time);
    stepper.compute_initial_forces(schedule.blade_step());
    balance.update(scene.state(), 0., 0);
    double        now = 0., dissipated = 0.;
    unsigned long k = 0;
    while (now < parameters.time.end_time * (1. - 1e-12))
      {
        schedule = scene.plan(parameters.time.end_time - now);
        stepper.advance(schedule);
        now += schedule.step;
        balance.update(scene.state(), now, ++k);
        result.fall = std::max(result.fall, dissipated - balance.state().self_contact.dissipated);
        dissipated  = balance.state().self_contact.dissipated;
        if (k % 10 == 0)
          result.crossings = std::max(result.crossings, count_crossings(scene.blade->facets(), depth));
      }
    std::filesystem::remove_all(folder);
    result.energy_error   = balance.energy_error().largest;
    result.momentum_error = balance.momentum_error().largest;
    result.dissipated     = dissipated;
    result.momentum       = balance.state().blade_momentum.momentum;
    if (scene.self_contact)
      {
        result.deepest  = scene.self_contact->report().max_penetration;
        result.touches  = scene.self_contact->report().touches;
        result.n_tested = scene.self_contact->report().pairs_tested;
      }
    return result;
  }

  class FoldedBlade : public ::testing::TestWithParam<bool>
  {
  };
} // namespace

TEST_P(FoldedBlade, LegsPassThroughOneAnotherOnlyWithoutSelfContact)
{
  EXPECT_GT(run_folded(GetParam(), {"Contact/Self-contact=false"}).crossings, 10U);
  const Outcome folded = run_folded(GetParam());
  EXPECT_EQ(folded.crossings, 0U);
  EXPECT_GT(folded.touches, 100U);
  EXPECT_LT(folded.deepest, 0.1 * thickness); // as the law promises for 150 m/s: 2.2 steps' flight, 0.2 mm
  EXPECT_GT(folded.dissipated, 0.);
  EXPECT_EQ(folded.fall, 0.);
  EXPECT_LT(folded.energy_error, 1e-2);    // found 0.06 % for shells, 0.6 % for bricks
  EXPECT_LT(folded.momentum_error, 1e-12); // forces between its own nodes are equal and opposite, held ones are booked
}

INSTANTIATE_TEST_SUITE_P(Kinds, FoldedBlade, ::testing::Bool(),
                         [](const auto &info) { return info.param ? "Solid" : "Shell"; });

TEST(SelfContactInAStrike, IsTheSameForAnyNumberOfThreads)
{
  const Outcome one   = run_folded(false, {"Time/End time=0.3e-3"}),
                three = run_folded(false, {"Time/End time=0.3e-3", "Time/Threads=3", "Time/Force threads=true"});
  EXPECT_GT(one.touches, 0U);
  EXPECT_EQ(one.momentum, three.momentum);
  EXPECT_EQ(one.dissipated, three.dissipated);
}

TEST(SelfContactInAStrike, ComputesNothingWhereNothingFolds)
{
  CaseParameters parameters;
  parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/quickstart.prm", {"Time/End time=0.2e-3"});
  Scene      scene(parameters);
  BirdStrike strike(parameters, scene);
  strike.run();
  ASSERT_TRUE(scene.self_contact);
  const SelfContactReport &report = scene.self_contact->report();
  EXPECT_GT(report.calls, 100U);
  EXPECT_LT(report.looks, report.calls / 4);
  EXPECT_EQ(report.pairs_tested, 0U);
}
