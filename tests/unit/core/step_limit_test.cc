#include <birdstrike/core/step_limit.h>

#include <gtest/gtest.h>

using namespace birdstrike;

TEST(EntityPlace, IsWordsOnlyWhereThereIsAnEntity)
{
  EXPECT_EQ(EntityPlace{}.text(), "");
  EXPECT_EQ((EntityPlace{"element", 17, {{0.01, 0.02, 0.}}}.text()), "element 17 at (0.01, 0.02, 0)");
}
