#pragma once

#include <birdstrike/contact/candidate_block.h>
#include <birdstrike/contact/narrow_phase.h>
#include <birdstrike/contact/touch_record.h>

#include <vector>

namespace birdstrike
{
  /// The touches of a block from what the narrow phase has found.
  void record_touches(const NarrowPhase &narrow_phase, const CandidateBlock &block, const PointsView &points,
                      const FacetsView &facets, bool has_friction, std::vector<TouchRecord> &touches);
} // namespace birdstrike
