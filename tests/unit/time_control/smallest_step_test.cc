#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/time_control/smallest_step.h>

#include <gtest/gtest.h>

#include <limits>

using namespace birdstrike;

namespace
{
  StepLimit limit(const double value)
  {
    return {value, "membrane wave", {"element", 17, {{0.1, 0.2, 0.3}}}};
  }
} // namespace

TEST(SmallestStep, EndsARunBelowTheShareOfTheFirstStep)
{
  SmallestStep step("blade", 1e-3);
  step.check(limit(1e-6), 1e-2, "advice");
  EXPECT_NO_THROW(step.check(limit(1.001e-9), 1e-3, "advice"));
  EXPECT_NEAR(step.smallest_share(), 1.001e-3, 1e-12);
  try
    {
      step.check(limit(0.999e-9), 1e-3, "Do this.");
      FAIL() << "not stopped";
    }
  catch (const NumericalFailure &failure)
    {
      const std::string message = failure.what();
      for (const char *part :
           {"blade", "0.000999", "Time/Smallest step 0.001", "membrane wave", "element 17", "(0.1, ", "Do this."})
        EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
    }
}

TEST(SmallestStep, ZeroNeverEndsARunThatStepsCanFinish)
{
  SmallestStep step("blade", 0.);
  step.check(limit(1e-6), 1e-2, "advice");
  EXPECT_NO_THROW(step.check(limit(1e-15), 1e-7, "advice"));
}

TEST(SmallestStep, EndsARunThatWouldNeverEnd)
{
  SmallestStep step("blade", 0.);
  EXPECT_THROW(step.check(limit(1e-14), 1e-2, "advice"), NumericalFailure);
}

TEST(SmallestStep, EndsARunWhoseStepIsNoNumber)
{
  for (const bool is_first : {true, false})
    {
      SmallestStep step("bird", 0.);
      if (!is_first)
        step.check(limit(1e-6), 1e-2, "advice");
      try
        {
          step.check(limit(std::numeric_limits<double>::quiet_NaN()), 1e-2, "advice");
          FAIL() << "not stopped";
        }
      catch (const NumericalFailure &failure)
        {
          const std::string message = failure.what();
          for (const char *part : {"bird", "no number", "membrane wave", "element 17"})
            EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
        }
    }
}
