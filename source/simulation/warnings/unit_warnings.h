#pragma once

#include <birdstrike/core/warning.h>

namespace birdstrike
{
  struct CaseParameters;

  /// Numbers that are no bird's, blade's or metal's in the entry's unit, or have another sign than usual.
  void check_units(const CaseParameters &parameters, Warnings &warnings);
} // namespace birdstrike
