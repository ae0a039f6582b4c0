#include <birdstrike/report/progress.h>

#include <gtest/gtest.h>

#include <vector>

using birdstrike::Progress;

TEST(Progress, TellsTimeShareSpeedAndTimeLeft)
{
  double                   wall = 100.;
  std::vector<std::string> lines;
  Progress                 progress(
                    10e-3, 2., [&] { return wall; }, [&](const std::string &line) { lines.push_back(line); });
  EXPECT_FALSE(progress.is_due());
  wall += 2.;
  EXPECT_TRUE(progress.is_due());
  // 2 ms in 2 s: the other 8 ms take 8 s.
  progress.print({2e-3, 1e-6, 2000, 0.0012, "shell element 17"});
  EXPECT_FALSE(progress.is_due());
  ASSERT_EQ(lines.size(), 1u);
  for (const char *part :
       {"t = 2.0000 ms", "20.0 %", "1000 steps/s", "dt = 1 us by shell element 17  left 8.0 s", "energy error 0.12 %"})
    EXPECT_NE(lines[0].find(part), std::string::npos) << part << " in " << lines[0];

  // The next interval is three times as fast; the rate is the mean of both.
  wall += 2.;
  progress.print({8e-3, 1e-6, 8000, 0.});
  EXPECT_NE(lines[1].find("left 1.0 s"), std::string::npos) << lines[1];
  EXPECT_NE(lines[1].find("3000 steps/s"), std::string::npos) << lines[1];
}

TEST(Progress, SaysUnknownWhileNothingMoves)
{
  double      wall = 0.;
  std::string last;
  Progress    progress(
       1., 1., [&] { return wall; }, [&](const std::string &line) { last = line; });
  wall = 5.;
  progress.print({0., 1e-6, 0, 0.});
  EXPECT_NE(last.find("left unknown"), std::string::npos) << last;
}
