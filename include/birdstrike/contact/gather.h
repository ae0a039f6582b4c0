#pragma once

#include <birdstrike/core/number.h>

#include <cstdint>

namespace birdstrike
{
  /// values[index[k]] for the lanes k of one register.
  inline Lanes gather(const double *values, const std::uint32_t *index)
  {
    return Lanes([&](const auto k) { return values[index[k]]; });
  }
} // namespace birdstrike
