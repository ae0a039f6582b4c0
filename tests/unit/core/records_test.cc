#include <birdstrike/core/simd/records.h>

#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  /// value[c] of record r is 100 r + c: every component in every lane is known.
  template <class T, std::size_t n>
  void expect_transposed()
  {
    Records<T, n> records(40);
    for (std::size_t r = 0; r < records.size(); ++r)
      for (std::size_t c = 0; c < n; ++c)
        records[r].value[c] = static_cast<T>(100 * r + c);
    std::array<std::uint32_t, 16> index;
    for (std::size_t k = 0; k < index.size(); ++k)
      index[k] = (7 * k + 3) % 40;
    const auto components = load_records(records, index.data());
    for (std::size_t c = 0; c < n; ++c)
      for (std::size_t k = 0; k < LanesOf<T>::size(); ++k)
        EXPECT_EQ(components[c][k], static_cast<T>(100 * index[k] + c)) << c << ' ' << k;
  }

  template <class T>
  void expect_stored()
  {
    std::array<Lanes, 16> components;
    for (std::size_t c = 0; c < 16; ++c)
      for (std::size_t k = 0; k < n_lanes; ++k)
        components[c][k] = 10. * c + k;
    Records<T, 16> records(2 * n_lanes);
    store_records(components, records, n_lanes);
    for (std::size_t k = 0; k < n_lanes; ++k)
      for (std::size_t c = 0; c < 16; ++c)
        EXPECT_EQ(records[n_lanes + k].value[c], static_cast<T>(10. * c + k)) << c << ' ' << k;
    EXPECT_EQ(records[n_lanes - 1].value[15], T(0)); // neighbours untouched
  }
} // namespace

TEST(Records, LoadTransposesWholeLines)
{
  expect_transposed<double, 8>();
  expect_transposed<double, 16>();
  expect_transposed<float, 16>();
}

TEST(Records, StoreIsTheInverse)
{
  expect_stored<double>();
  expect_stored<float>();
}
