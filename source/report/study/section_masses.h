#pragma once

#include "report/study/study_runs.h"

#include <string>
#include <vector>

namespace birdstrike
{
  /// A sentence where a section of the blade has another mass at one level of a ladder than at another, by more than a
  /// hundredth: its levels are then of several blades, and neither order nor error bar is that of the mesh. Empty where
  /// none has.
  std::string describe_changing_sections(const std::vector<PointRun> &runs);
} // namespace birdstrike
