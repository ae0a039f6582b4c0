#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/time_control/schedule.h>

#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  StepVote vote(const double limit, const double cost)
  {
    return {{limit, "test", {"particle", 7, {}}}, cost};
  }
} // namespace

TEST(Schedule, EveryCandidateKeepsBothLimits)
{
  for (const double bird : {0.3, 0.99, 1., 1.01, 2.5, 7.3})
    for (const double cost : {0.01, 1., 100.})
      {
        const Schedule s = plan_step(vote(bird, cost), vote(1., 1.), 8, 1e9);
        EXPECT_LE(s.bird_step(), bird * (1. + 1e-15));
        EXPECT_LE(s.blade_step(), 1. * (1. + 1e-15));
        EXPECT_TRUE(s.n_bird == 1 || s.n_blade == 1);
      }
}

TEST(Schedule, CheapPartsSubCycle)
{
  // bird twice as slow and a hundred times dearer: two blade steps to one of the bird
  const Schedule s = plan_step(vote(2., 100.), vote(1., 1.), 8, 1e9);
  EXPECT_EQ(s.n_blade, 2u);
  EXPECT_EQ(s.n_bird, 1u);
  EXPECT_DOUBLE_EQ(s.step, 2.);
  // blade three times as slow and dearer
  const Schedule t = plan_step(vote(1., 1.), vote(3., 50.), 8, 1e9);
  EXPECT_EQ(t.n_bird, 3u);
  EXPECT_DOUBLE_EQ(t.step, 3.);
}

TEST(Schedule, ADearPartIsNotSteppedTwiceForALittle)
{
  // the blade's limit is 5 % below the bird's: one common step beats two blade steps of half the size
  const Schedule s = plan_step(vote(1.05, 10.), vote(1., 10.), 8, 1e9);
  EXPECT_EQ(s.n_blade, 1u);
  EXPECT_DOUBLE_EQ(s.step, 1.);
}

TEST(Schedule, RatioOneForbidsSubCycling)
{
  const Schedule s = plan_step(vote(1., 1.), vote(10., 1.), 1, 1e9);
  EXPECT_EQ(s.n_bird, 1u);
  EXPECT_EQ(s.n_blade, 1u);
  EXPECT_DOUBLE_EQ(s.step, 1.);
}

TEST(Schedule, AbsentPartHasNoVoteAndTheEndIsHit)
{
  EXPECT_DOUBLE_EQ(plan_step({}, vote(1., 1.), 8, 1e9).step, 1.);
  EXPECT_DOUBLE_EQ(plan_step(vote(2., 1.), {}, 8, 1e9).step, 2.);
  EXPECT_DOUBLE_EQ(plan_step({}, vote(1., 1.), 8, 0.25).step, 0.25);
  EXPECT_DOUBLE_EQ(plan_step({}, vote(1., 1.), 8, 1.5).step, 0.75);
}

TEST(Schedule, ACollapsedStepNamesWhoCollapsed)
{
  try
    {
      plan_step(vote(0., 1.), vote(1., 1.), 8, 1.);
      FAIL();
    }
  catch (const NumericalFailure &error)
    {
      EXPECT_NE(std::string(error.what()).find("bird"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("particle 7"), std::string::npos);
    }
}
