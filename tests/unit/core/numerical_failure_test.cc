#include <birdstrike/core/numerical_failure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace birdstrike;

namespace
{
  FailureFacts some_facts()
  {
    FailureFacts facts{"A node has run away", "speed", 12345., "m/s", 9000.};
    facts.where   = {"node", 17, {{0.01, 0.02, 0.}}};
    facts.details = "Details.";
    facts.advice  = "Advice.";
    return facts;
  }
} // namespace

TEST(NumericalFailure, SaysWhatWhenWhereAndHowToGoOnInSixLines)
{
  NumericalFailure failure(some_facts());
  failure.add_instant(1.5e-3, 42);
  failure.add_checkpoint("run/checkpoints/a.h5", "Go on.");
  EXPECT_STREQ(failure.what(), "A node has run away: speed = 12345 m/s (limit 9000 m/s).\n"
                               "At t = 0.0015 s, step 42, node 17 at (0.01, 0.02, 0) m.\nDetails.\nAdvice.\nGo on.");
  EXPECT_EQ(failure.facts().checkpoint, "run/checkpoints/a.h5");
}

TEST(NumericalFailure, KeepsTheInstantOfWhoKnewIt)
{
  FailureFacts facts = some_facts();
  facts.time         = 1e-3;
  NumericalFailure failure(facts);
  failure.add_instant(2e-3, 42);
  EXPECT_EQ(failure.facts().time, 1e-3);
  EXPECT_FALSE(failure.facts().step) << "that of another time";
}

TEST(NumericalFailure, LeavesOutWhatIsNotKnown)
{
  EXPECT_STREQ(NumericalFailure("Lost: a.").what(), "Lost: a.");
  EXPECT_STREQ(NumericalFailure(FailureFacts{"It is none", "x", std::nan("")}).what(), "It is none: x = nan.");
}
