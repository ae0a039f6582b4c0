#include "bird/riemann_sums.h"

#include <gtest/gtest.h>

using namespace birdstrike;

// Opposite forces cancel whatever the order in which they are added: the point of fixed point.
TEST(ForceSum, FloatForcesAddUpExactly)
{
  ForceSum<float> forwards, backwards;
  for (int k = 0; k < 7; ++k)
    {
      FloatLanes f([&](const auto l) { return 1e6f * std::sin(1.f + 7.f * l + 1.3f * k); });
      forwards.add({f, 0.5f * f, -f});
    }
  for (int k = 6; k >= 0; --k)
    {
      FloatLanes f([&](const auto l) { return 1e6f * std::sin(1.f + 7.f * l + 1.3f * k); });
      backwards.add({-f, -0.5f * f, f});
    }
  for (int d = 0; d < 3; ++d)
    {
      EXPECT_EQ(forwards.value()[d] + backwards.value()[d], 0.);
      EXPECT_NE(forwards.value()[d], 0.);
    }
}
