#include "bird/lane_sums.h"
#include "bird/riemann_sums.h"

#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  template <class T, std::size_t n>
  void expect_sums()
  {
    std::array<LanesOf<T>, n> terms;
    std::array<double, n>     expected{};
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l < LanesOf<T>::size(); ++l)
        {
          terms[k][l] = static_cast<T>(static_cast<int>(k) - 3 + 100 * static_cast<int>(l)); // whole numbers: exact
          expected[k] += static_cast<double>(static_cast<int>(k) - 3 + 100 * static_cast<int>(l));
        }
    const auto sums = sum_lanes<T>(terms);
    for (std::size_t k = 0; k < n; ++k)
      EXPECT_EQ(sums[k], expected[k]) << k;
  }
} // namespace

TEST(LaneSums, EverySumIsThatOfItsLanes)
{
  expect_sums<double, 3>();
  expect_sums<double, 12>();
  expect_sums<float, 6>();
  expect_sums<float, 12>();
}

// Opposite forces cancel whatever the order in which they are added: the point of fixed point.
TEST(LaneSums, FloatForcesAddUpExactly)
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
