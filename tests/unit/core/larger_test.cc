#include <birdstrike/core/simd/larger.h>
#include <birdstrike/core/thread_pool.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

using namespace birdstrike;

namespace
{
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
}

TEST(Larger, KeepsWhatIsNoNumberFromEitherSide)
{
  EXPECT_EQ(larger(1., 2.), 2.);
  EXPECT_EQ(larger(2., 1.), 2.);
  EXPECT_EQ(smaller(1., 2.), 1.);
  EXPECT_EQ(smaller(2., 1.), 1.);
  EXPECT_TRUE(std::isnan(larger(1., no_number)));
  EXPECT_TRUE(std::isnan(larger(no_number, 1.)));
  EXPECT_TRUE(std::isnan(smaller(1., no_number)));
  EXPECT_TRUE(std::isnan(smaller(no_number, 1.)));
  EXPECT_TRUE(exceeds(no_number, 1.));
  EXPECT_FALSE(exceeds(1., no_number));
  EXPECT_FALSE(exceeds(1., 1.));
}

TEST(Larger, OfRegistersKeepsItInEveryLane)
{
  for (std::size_t at = 0; at < n_lanes; ++at)
    {
      Lanes       one([](const auto k) { return static_cast<double>(k); });
      const Lanes other(3.);
      EXPECT_EQ(largest_lane(larger(one, other)), std::max(3., n_lanes - 1.));
      one[at] = no_number;
      EXPECT_TRUE(std::isnan(largest_lane(larger(one, other)))) << at;
      EXPECT_TRUE(std::isnan(largest_lane(larger(other, one)))) << at;
    }
}

// Wherever the chunk lies that has it, and however many threads there are.
TEST(Larger, OfAThreadPoolKeepsItFromEveryChunk)
{
  for (const std::size_t n_threads : {1U, 3U})
    for (const std::size_t at : {0U, 1U, 57U, 99U})
      {
        ThreadPool          pool(n_threads);
        std::vector<double> values(100, 1.);
        values[40]         = 7.;
        const auto largest = [&] {
          return pool.ordered_max(
            100, [&](const std::size_t k, std::size_t) { return values[k]; }, 1);
        };
        EXPECT_EQ(largest(), 7.);
        values[at] = no_number;
        EXPECT_TRUE(std::isnan(largest())) << at;
      }
}

TEST(Larger, AVoteThatIsNoNumberDecides)
{
  EXPECT_TRUE(goes_before(1., 2.));
  EXPECT_FALSE(goes_before(2., 1.));
  EXPECT_FALSE(goes_before(1., 1.));
  EXPECT_TRUE(goes_before(no_number, 1.));
  EXPECT_FALSE(goes_before(1., no_number));
}
