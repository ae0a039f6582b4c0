#include <birdstrike/contact/local_numbers.h>
#include <birdstrike/contact/node_records.h>

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace birdstrike;

TEST(LocalNumbers, EachKeyKeepsTheNumberOfItsFirstSight)
{
  std::mt19937 random(3);
  LocalNumbers numbers;
  for (const std::size_t n : {0u, 1u, 500u, 3u})
    {
      numbers.restart(n);
      std::map<std::uint32_t, std::uint32_t> expected;
      for (std::size_t k = 0; k < 4 * n; ++k)
        {
          const auto key = static_cast<std::uint32_t>(random() % (n + 1)) * 4096u; // collide in the low bits
          if (expected.size() == n && expected.count(key) == 0)
            continue;
          const auto number = static_cast<std::uint32_t>(expected.emplace(key, expected.size()).first->second);
          EXPECT_EQ(numbers.number(key), number);
          EXPECT_EQ(numbers.keys()[number], key);
        }
      EXPECT_EQ(numbers.keys().size(), expected.size());
    }
}

TEST(NodeRecords, AreTransposedIntoLanes)
{
  std::array<NodeRecord, 20> records;
  for (std::size_t n = 0; n < records.size(); ++n)
    for (std::size_t c = 0; c < 8; ++c)
      records[n].value[c] = static_cast<double>(10 * n + c);
  std::array<std::uint32_t, n_lanes> index;
  for (std::size_t k = 0; k < n_lanes; ++k)
    index[k] = static_cast<std::uint32_t>((7 * k + 3) % records.size());
  const auto components = load_records(records.data(), index.data());
  for (std::size_t c = 0; c < 8; ++c)
    for (std::size_t k = 0; k < n_lanes; ++k)
      EXPECT_EQ(components[c][k], 10. * index[k] + c);
}
