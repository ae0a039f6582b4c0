#include <birdstrike/core/step_limit.h>

#include <gtest/gtest.h>

using namespace birdstrike;

TEST(EntityPlace, IsWordsOnlyWhereThereIsAnEntity)
{
  EXPECT_EQ(EntityPlace{}.text(), "");
  EXPECT_EQ((EntityPlace{"element", 17, {{0.01, 0.02, 0.}}}.text()), "element 17 at (0.01, 0.02, 0)");
}

TEST(StepLimit, SaysPartAndEntityAtLengthAndInBrief)
{
  const StepLimit of_element{1e-6, "shell element, largest eigenvalue", {"element", 17, {{0.01, 0.02, 0.}}}};
  EXPECT_EQ(of_element.text(), "shell element, largest eigenvalue, element 17 at (0.01, 0.02, 0)");
  EXPECT_EQ(of_element.brief(), "shell element 17");
  const StepLimit of_node{1e-6, "contact, stiffness of the touches", {"node", 5, {}}};
  EXPECT_EQ(of_node.brief(), "contact, node 5");
  const StepLimit of_nothing{1e-6, "end of the run", {}};
  EXPECT_EQ(of_nothing.text(), "end of the run");
  EXPECT_EQ(of_nothing.brief(), "end of the run");
}
