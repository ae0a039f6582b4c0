#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace birdstrike
{
  /// Whether two facets have the same nodes in the same places; the library's == of arrays calls memcmp.
  inline bool are_same(const std::array<std::uint32_t, 4> &a, const std::array<std::uint32_t, 4> &b)
  {
    using Halves = std::array<std::uint64_t, 2>;
    const auto x = std::bit_cast<Halves>(a), y = std::bit_cast<Halves>(b);
    return ((x[0] ^ y[0]) | (x[1] ^ y[1])) == 0;
  }

  inline std::ptrdiff_t count_common_nodes(const std::array<std::uint32_t, 4> &a, const std::array<std::uint32_t, 4> &b)
  {
    return std::count_if(a.begin(), a.end(),
                         [&](const std::uint32_t node) { return std::find(b.begin(), b.end(), node) != b.end(); });
  }
} // namespace birdstrike
