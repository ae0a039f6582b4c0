#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike
{
  /// A sentence where a section of the blade has another share of its mass in one of these complete runs, the levels of
  /// a ladder, than in another, by more than a hundredth: they are then of several blades, and neither order nor error
  /// bar is that of the mesh. Empty where none has.
  std::string describe_changing_sections(const std::vector<std::filesystem::path> &folders);
} // namespace birdstrike
