#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/report/balance.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

using namespace birdstrike;

namespace
{
  /// A 0.03 kg mass at 75 m/s merges with a resting 0.01 kg one through a spring and damper (all numbers closed form).
  SystemState before()
  {
    SystemState state;
    state.bird.kinetic            = 0.5 * 0.03 * 75. * 75.;
    state.bird_momentum.momentum  = {0., 0., 0.03 * 75.};
    state.bird_momentum.retired   = {0., 0., 0.};
    state.blade_momentum.momentum = {0., 0., 0.};
    return state;
  }

  SystemState merged()
  {
    SystemState  state;
    const double v                      = 0.03 * 75. / 0.04;
    state.bird.kinetic                  = 0.5 * 0.03 * v * v;
    state.blade.kinetic                 = 0.5 * 0.01 * v * v;
    state.bird.contact_work             = state.bird.kinetic - before().bird.kinetic;
    state.blade.contact_work            = state.blade.kinetic;
    state.bird_momentum.momentum        = {0., 0., 0.03 * v};
    state.blade_momentum.momentum       = {0., 0., 0.01 * v};
    state.bird_momentum.contact_impulse = {0., 0., 0.03 * (v - 75.)};
    state.contact.elastic               = 1.;
    state.contact.dissipated            = 0.5 * (0.03 * 0.01 / 0.04) * 75. * 75. - 1.;
    return state;
  }
} // namespace

TEST(Balance, ClosesWhenContactTakesWhatThePartsLose)
{
  Balance balance(0.05);
  balance.update(before(), 0., 0);
  balance.update(merged(), 1e-4, 10);
  EXPECT_NEAR(balance.energy_error().now, 0., 1e-14);
  EXPECT_NEAR(balance.momentum_error().now, 0., 1e-14);
  // perfectly plastic impact: m1 m2 / (m1 + m2) v^2 / 2
  const double lost = 0.5 * (0.03 * 0.01 / 0.04) * 75. * 75.;
  EXPECT_NEAR(balance.contact_energy(), lost, 1e-12);
  EXPECT_NEAR(balance.state().contact.dissipated, lost - 1., 1e-12);
  EXPECT_NEAR(balance.origins().contact, 0., 1e-12);
  EXPECT_NEAR(balance.origins().steps, 0., 1e-12);
}

// No kind is what the others leave: what contact dissipates by its own rate shows against its works, what stresses
// store against the work of their forces.
TEST(Balance, TellsWhereAnErrorComesFrom)
{
  Balance balance(0.05);
  balance.update(before(), 0., 0);
  SystemState state = merged();
  state.contact.dissipated += 1.;
  state.blade.elastic = 0.5;
  state.bird.elastic  = 0.25;
  balance.update(state, 1e-4, 10);
  EXPECT_NEAR(balance.origins().contact, 1., 1e-12);
  EXPECT_NEAR(balance.origins().blade, 0.5, 1e-12);
  EXPECT_NEAR(balance.origins().bird, 0.25, 1e-12);
  EXPECT_NEAR(balance.origins().steps, 0., 1e-12);
  EXPECT_NEAR(balance.energy_error().now, 1.75 / before().bird.kinetic, 1e-12);
}

TEST(Balance, StopsWhereContactGivesBackWhatItHadDissipated)
{
  Balance balance(0.05);
  balance.update(before(), 0., 0);
  balance.update(merged(), 1e-4, 10);
  SystemState state = merged();
  state.contact.dissipated -= 2e-3 * before().bird.kinetic;
  try
    {
      balance.update(state, 2e-4, 20);
      FAIL();
    }
  catch (const NumericalFailure &failure)
    {
      EXPECT_NE(std::string(failure.what()).find("contact_dissipated"), std::string::npos);
    }
}

TEST(Balance, SeesLostAngularMomentumAndSetsSupportsAndLoadsAgainstIt)
{
  Balance     balance(0.05);
  SystemState state                    = before();
  state.bird_momentum.angular_momentum = {0., -2., 0.};
  balance.update(state, 0., 0);
  state.bird_momentum.angular_momentum  = {0., -0.5, 0.};
  state.blade_momentum.angular_momentum = {0., -1., 1.};
  state.blade_momentum.support_moment   = {0., -0.5, 0.};
  state.blade_momentum.external_moment  = {0., 0., 1.};
  balance.update(state, 1e-4, 10);
  EXPECT_NEAR(balance.angular_momentum_error().now, 0., 1e-14);
  state.blade_momentum.support_moment = {0., 0., 0.};
  balance.update(state, 2e-4, 20);
  EXPECT_NEAR(balance.angular_momentum_error().largest, 0.25, 1e-14);
}

// Two birds from two sides have none together: what is lost counts against what one of them has, 2 N m s, not against
// a hundredth of sums over particles (8 N m s).
TEST(Balance, HoldsLossesAgainstOneOfSeveralBirds)
{
  Balance     balance(0.05);
  SystemState state                 = before();
  state.bird_momentum               = {};
  state.bird_momentum.moment_scale  = 8.;
  state.bird_momentum.impulse_scale = 6.;
  MomentumReport one;
  one.momentum                 = {0., 0., 1.5};
  one.angular_momentum         = {0., -2., 0.};
  one.largest_momentum         = 1.5;
  one.largest_angular_momentum = 2.;
  add(state.bird_momentum, one);
  one.momentum[2] *= -1.;
  one.angular_momentum[1] *= -1.;
  add(state.bird_momentum, one);
  EXPECT_EQ(state.bird_momentum.angular_momentum[1], 0.);
  balance.update(state, 0., 0);
  state.bird_momentum.angular_momentum = {0., 0.01, 0.};
  state.bird_momentum.momentum         = {0., 0., 0.003};
  // they go on, and have less each
  state.bird_momentum.largest_momentum = state.bird_momentum.largest_angular_momentum = 0.5;
  balance.update(state, 1e-4, 10);
  EXPECT_NEAR(balance.angular_momentum_error().now, 0.01 / 2., 1e-14);
  EXPECT_NEAR(balance.momentum_error().now, 0.003 / 1.5, 1e-14);
}

TEST(Balance, SeesLostMomentumAndEnergy)
{
  Balance balance(0.05);
  balance.update(before(), 0., 0);
  SystemState state = merged();
  state.blade_momentum.momentum[2] *= 1.001;
  state.blade.kinetic *= 1.01;
  balance.update(state, 1e-4, 10);
  EXPECT_NEAR(balance.momentum_error().now, 0.001 * 0.25, 1e-12);
  EXPECT_GT(balance.energy_error().now, 0.);
  // the largest error stays on record after the state is right again
  balance.update(merged(), 2e-4, 20);
  EXPECT_NEAR(balance.momentum_error().largest, 0.001 * 0.25, 1e-12);
  EXPECT_GT(balance.energy_error().largest, 1e-4);
}

TEST(Balance, StopsTheRunPastTheLimitAndOnNaN)
{
  Balance balance(0.05);
  balance.update(before(), 0., 0);
  SystemState state = merged();
  state.blade.plastic += 0.051 * before().bird.kinetic;
  EXPECT_THROW(balance.update(state, 1e-4, 10), NumericalFailure);

  Balance other(0.05);
  other.update(before(), 0., 0);
  state               = merged();
  state.blade.elastic = std::numeric_limits<double>::quiet_NaN();
  try
    {
      other.update(state, 1e-4, 17);
      FAIL();
    }
  catch (const NumericalFailure &error)
    {
      EXPECT_NE(std::string(error.what()).find("step 17"), std::string::npos);
    }
}

// Each entry of each ledger by itself: whichever is no number ends the run, and at the latest then.
TEST(Balance, EndsWithWhatIsNoNumberInAnyEntry)
{
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  const auto       ends      = [](const SystemState &state) {
    Balance balance(0.05);
    balance.update(before(), 0., 0);
    try
      {
        balance.update(state, 1e-4, 10);
      }
    catch (const NumericalFailure &)
      {
        return true;
      }
    return false;
  };
  EXPECT_FALSE(ends(merged()));
  for (auto part : {&SystemState::bird, &SystemState::blade})
    for (const EnergyKind &kind : energy_kinds)
      {
        SystemState state         = merged();
        (state.*part).*kind.value = no_number;
        EXPECT_TRUE(ends(state)) << kind.name;
      }
  for (auto part : {&SystemState::bird_momentum, &SystemState::blade_momentum})
    for (const MomentumKind &kind : momentum_kinds)
      for (const int component : {0, 2})
        {
          SystemState state                      = merged();
          ((state.*part).*kind.value)[component] = no_number;
          EXPECT_TRUE(ends(state)) << kind.name << component;
        }
}
