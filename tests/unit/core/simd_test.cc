#include <birdstrike/core/simd/compress.h>
#include <birdstrike/core/simd/inverse_root.h>
#include <birdstrike/core/simd/lane_sums.h>

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

  /// Every pattern of the lowest eight lanes, and all lanes: what is kept stands in order.
  template <class Register>
  void expect_compressed()
  {
    using T          = typename Register::value_type;
    constexpr auto n = Register::size();
    for (std::uint32_t pattern = 0; pattern <= 256; ++pattern)
      {
        const auto       chosen = [&](const std::size_t k) { return pattern == 256 || ((pattern >> k % 8) & 1u) != 0; };
        const Register   is_set([&](const auto k) { return chosen(k) ? T(1) : T(0); });
        std::array<T, n> out{};
        const auto       count    = compress_lanes(count_lanes<Register>() + T(7), to_bits(is_set > T(0)), out.data());
        std::size_t      expected = 0;
        for (std::size_t k = 0; k < n; ++k)
          if (chosen(k))
            {
              EXPECT_EQ(out[expected++], static_cast<T>(7 + k)) << pattern;
            }
        EXPECT_EQ(count, expected);
      }
  }
} // namespace

TEST(Simd, EverySumIsThatOfItsLanes)
{
  expect_sums<double, 3>();
  expect_sums<double, 12>();
  expect_sums<float, 6>();
  expect_sums<float, 12>();
}

TEST(Simd, CompressKeepsChosenLanesInOrder)
{
  expect_compressed<Lanes>();
  expect_compressed<FloatLanes>();
  expect_compressed<LaneNumbers<Lanes>>();
  expect_compressed<LaneNumbers<FloatLanes>>();
}

TEST(Simd, InverseRootIsExactToRoundOff)
{
  for (const double a : {1e-20, 3e-7, 0.5, 1., 2., 1e18})
    {
      EXPECT_NEAR(inverse_root(Lanes(a))[0] * std::sqrt(a), 1., 4e-16);
      const float f = static_cast<float>(a);
      EXPECT_NEAR(inverse_root(FloatLanes(f))[0] * std::sqrt(f), 1.f, 3e-7f);
    }
}
