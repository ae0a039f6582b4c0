#pragma once

#include <birdstrike/core/simd/records.h>

namespace birdstrike
{
  /// What contact needs of a node, in one cache line: position, velocity, inverse mass, half thickness.
  using NodeRecord = Record<double, 8>;
} // namespace birdstrike
