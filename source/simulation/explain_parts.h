#pragma once

#include <birdstrike/report/text.h>

#include <array>
#include <string>

namespace birdstrike
{
  class Blade;
  struct BladeParameters;

  /// "(1, 0, -0.5) m", without what is round-off beside the largest.
  std::string vector_text(std::array<double, 3> a, const char *unit);

  void add_blade(TextTable &table, const Blade &blade, const BladeParameters &parameters);
} // namespace birdstrike
