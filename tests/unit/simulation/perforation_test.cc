#include "strike_harness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace birdstrike;
using namespace birdstrike::test;

namespace
{
  const std::vector<std::string> coarse{"Bird/Particle spacing=0.004", "Blade/Mesh/Elements along span=30",
                                        "Blade/Mesh/Elements along chord=30", "Time/End time=0.3e-3"};

  Strike run_coarse(std::vector<std::string> more = {})
  {
    more.insert(more.begin(), coarse.begin(), coarse.end());
    return run_shipped("perforation.prm", more);
  }
} // namespace

TEST(Perforation, TheBirdGoesThroughAndTheBalanceHolds)
{
  const Strike  run     = run_coarse();
  const Summary summary = run.summary;
  EXPECT_EQ(summary.end.reason, "end time reached");
  EXPECT_LT(summary.energy.max_relative_error, 5e-3); // coupled gate
  EXPECT_LT(summary.momentum.max_relative_error, 1e-8);
  EXPECT_GT(summary.failed.elements, 10u);
  EXPECT_LT(summary.failed.elements, 900u / 4);
  EXPECT_GT(summary.failed.energy, 0.);
  EXPECT_EQ(summary.energy.parts.at("blade_eroded"), summary.failed.energy);
  // the plate takes some of the bird's momentum, m v = 25.1 N s; what goes through keeps most of it
  EXPECT_GT(summary.contact.impulse[2], 1.);
  EXPECT_LT(summary.contact.impulse[2], 0.7 * 25.1);
  const auto &failed = run.curves.at("failed_elements");
  EXPECT_TRUE(std::is_sorted(failed.begin(), failed.end())) << "what has failed stays failed";
  const auto &dissipated = run.curves.at("contact_dissipated");
  for (std::size_t k = 1; k < dissipated.size(); ++k)
    EXPECT_GT(dissipated[k], dissipated[k - 1] - 1e-3 * summary.energy.initial)
      << "a facet that goes gives nothing back";
}

TEST(Perforation, IsBitwiseTheSameForOneAndTwoThreads)
{
  const Strike one = run_coarse({"Time/Threads=1"}), two = run_coarse({"Time/Threads=2"});
  EXPECT_EQ(one.curves, two.curves);
}

// The other half is the mirror image; the packings differ, and with them the hole by some elements.
TEST(Perforation, HalfOfItTellsOfTheWhole)
{
  const Strike whole = run_coarse(), half = run_coarse({"Case/Symmetry plane=y"});
  EXPECT_NEAR(half.summary.contact.impulse[2] / whole.summary.contact.impulse[2], 1., 0.1);
  EXPECT_LT(half.summary.energy.max_relative_error, 5e-3);
  EXPECT_GT(half.summary.failed.elements, 10u);
}
