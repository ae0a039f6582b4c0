#pragma once

#include <birdstrike/core/warning.h>

namespace birdstrike
{
  class Blade;
  struct BladeCensus;
  struct CaseParameters;

  /// What a deformable blade's mesh makes doubtful: that nothing or everything holds it, a thickness or a tip that
  /// nobody gave, too few layers of bricks, nodes that lie on one another and are not joined, lengths of another unit.
  void check_mesh(const CaseParameters &parameters, const Blade &blade, Warnings &warnings);
} // namespace birdstrike
