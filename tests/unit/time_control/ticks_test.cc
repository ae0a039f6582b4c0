#include <birdstrike/time_control/peak.h>
#include <birdstrike/time_control/ticks.h>

#include <gtest/gtest.h>

using namespace birdstrike;

TEST(Ticks, OneTickAnInterval)
{
  Ticks        ticks(1e-5);
  unsigned int n = 0;
  for (int step = 0; step <= 1000; ++step)
    n += ticks.is_due(step * 1e-6);
  EXPECT_EQ(n, 101u); // 0, 10, 20 ... 1000 us
}

TEST(Ticks, LongStepsSkipTicksButNeverDouble)
{
  Ticks        ticks(1.);
  unsigned int n = 0;
  for (const double time : {0., 2.5, 2.6, 3.1, 9., 9.5})
    n += ticks.is_due(time);
  EXPECT_EQ(n, 4u); // 0, 2.5, 3.1, 9
}

TEST(Ticks, ZeroIsAlwaysNegativeIsNever)
{
  Ticks always(0.), never(-1.);
  EXPECT_TRUE(always.is_due(0.) && always.is_due(0.));
  EXPECT_FALSE(never.is_due(0.));
}

TEST(Peak, KeepsTheLargestValueAndItsTime)
{
  Peak peak;
  EXPECT_EQ(peak.value(), 0.);
  for (const auto &[time, value] : {std::pair{0., -1.}, {1., 1.}, {2., 0.97}, {3., 2.}, {4., 1.5}})
    peak.update(time, value);
  EXPECT_DOUBLE_EQ(peak.value(), 2.);
  EXPECT_DOUBLE_EQ(peak.time(), 3.);
}
