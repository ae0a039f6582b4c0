#include "contact/touch_records.h"
#include "contact/couple.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    /// What a couple changes in the relative velocity and in the forces on the nodes.
    void add_spin(const FacetsView &facets, const bool has_friction, TouchRecord &touch)
    {
      const Couple couple(facets, has_friction, touch);
      touch.velocity -= couple.velocity(facets);
      const Point3 normal = touch.normal.normalized();
      touch.loads         = couple.loads(normal);
      const Point3 slip   = touch.velocity - touch.velocity.dot(normal) * normal;
      if (!has_friction || slip == Point3::Zero())
        return;
      const auto along = couple.loads(slip.normalized());
      for (unsigned int k = 0; k < 4; ++k)
        touch.loads[k] = std::max(touch.loads[k], along[k]);
    }
  } // namespace

  void record_touches(const NarrowPhase &narrow_phase, const CandidateBlock &block, const FacetsView &facets,
                      const bool has_friction, std::vector<TouchRecord> &touches)
  {
    const PairGeometry &pairs = narrow_phase.geometry();
    touches.clear();
    for (const TouchingPair &touch : narrow_phase.touches())
      {
        const std::uint32_t facet = block.pair_facet[pairs.pair[touch.place]];
        TouchRecord         record;
        record.normal      = touch.normal;
        record.velocity    = pairs.velocity_of(touch.place);
        record.offset      = pairs.offset_of(touch.place);
        record.weights     = pairs.weights_of(touch.place);
        record.penetration = touch.penetration;
        record.share       = touch.share;
        record.is_oblique  = touch.is_oblique;
        record.point       = block.points[touch.near];
        record.facet       = block.facets.keys()[facet];
        record.nodes       = block.facet_nodes[facet];
        record.loads       = record.weights;
        if (has_friction || record.is_oblique)
          add_spin(facets, has_friction, record);
        touches.push_back(record);
      }
  }
} // namespace birdstrike
