#pragma once

#include <birdstrike/core/warning.h>

namespace birdstrike
{
  struct CaseParameters;
  struct Scene;

  /// What a case's entries alone make doubtful: values far from any bird, blade or metal, of which most are of another
  /// unit (mm, g, ms, MPa), entries that mean nothing here, a file without any. Codes "unit/...", "entry/...",
  /// "case/...".
  Warnings find_input_warnings(const CaseParameters &parameters);

  /// What shows once the parts stand: a blade that nothing holds, elements that cannot bend, a bird that flies past in
  /// part or is coarse, fields that fill a disk. Codes "blade/...", "bird/...", "output/...". Looks only.
  Warnings find_scene_warnings(const CaseParameters &parameters, const Scene &scene);
} // namespace birdstrike
