#pragma once

#include <birdstrike/bird/parameters.h>
#include <birdstrike/structure/parameters.h>

#include <optional>

namespace birdstrike
{
  /// The undeformed mid-surface where a bird aims; nothing for a blade of a file that nobody has asked for shares of.
  std::optional<AimedSurface> find_aimed_surface(const BirdParameters &bird, const BladeParameters &blade);
} // namespace birdstrike
