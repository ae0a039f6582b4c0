#include <birdstrike/time_control/step_limiters.h>

#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  StepLimiters some_steps()
  {
    StepLimiters limiters;
    limiters.count({2e-6, "bird particle, sound", {"particle", 3, {{1., 0., 0.}}}}, 0.);
    limiters.count({4e-6, "shell element, wave", {"element", 17, {{0.1, 0.2, 0.3}}}}, 1e-5);
    limiters.count({3e-6, "shell element, wave", {"element", 18, {{0.4, 0.5, 0.6}}}}, 2e-5);
    limiters.count({3.5e-6, "shell element, wave", {"element", 19, {}}}, 3e-5);
    limiters.count({1e-6, "end of the run", {}}, 4e-5);
    limiters.count({2.5e-6, "bird particle, sound", {"particle", 4, {}}}, 5e-5);
    return limiters;
  }

  void expect_some_steps(const std::vector<StepLimiters::Limiter> &all)
  {
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].reason, "shell element, wave");
    EXPECT_EQ(all[0].n_steps, 3u);
    EXPECT_EQ(all[0].step, 3e-6);
    EXPECT_EQ(all[0].time, 2e-5);
    EXPECT_EQ(all[0].kind, "element");
    EXPECT_EQ(all[0].id, 18u);
    EXPECT_EQ(all[0].position[1], 0.5);
    EXPECT_EQ(all[1].reason, "bird particle, sound");
    EXPECT_EQ(all[1].n_steps, 2u);
    EXPECT_EQ(all[1].id, 3u);
    EXPECT_EQ(all[2].reason, "end of the run");
    EXPECT_EQ(all[2].kind, "");
  }
} // namespace

TEST(StepLimiters, KeepTheShortestStepOfEachReasonThatOfMostStepsFirst)
{
  EXPECT_TRUE(StepLimiters().all().empty());
  expect_some_steps(some_steps().all());
}

TEST(StepLimiters, GoOnAfterACheckpoint)
{
  StepLimiters  before = some_steps(), after;
  ArchivedState state;
  Archive       writing = Archive::writing(state);
  before.archive(writing);
  Archive reading = Archive::reading(state);
  after.archive(reading);
  reading.finish();
  expect_some_steps(after.all());
  after.count({1e-6, "bird particle, sound", {"particle", 5, {}}}, 6e-5);
  after.count({1e-6, "bird particle, sound", {"particle", 6, {}}}, 7e-5);
  EXPECT_EQ(after.all()[0].n_steps, 4u);
  EXPECT_EQ(after.all()[0].id, 5u);
}
