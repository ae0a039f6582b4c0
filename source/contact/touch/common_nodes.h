#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace birdstrike
{
  inline std::ptrdiff_t count_common_nodes(const std::array<std::uint32_t, 4> &a, const std::array<std::uint32_t, 4> &b)
  {
    return std::count_if(a.begin(), a.end(),
                         [&](const std::uint32_t node) { return std::find(b.begin(), b.end(), node) != b.end(); });
  }
} // namespace birdstrike
