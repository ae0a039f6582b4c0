#pragma once

#include <birdstrike/core/warning.h>

namespace birdstrike
{
  struct CaseParameters;

  /// Entries that were changed from their defaults and mean nothing in this case: the run is the same to every bit
  /// without them. Code "entry/unused".
  Warnings find_unused_entries(const CaseParameters &parameters);
} // namespace birdstrike
