#pragma once

#include <birdstrike/contact/law.h>
#include <birdstrike/contact/narrow_phase.h>
#include <birdstrike/contact/node_sums.h>
#include <birdstrike/contact/parameters.h>
#include <birdstrike/contact/report.h>

#include <array>
#include <vector>

namespace birdstrike
{
  /// The forces of one block's touches: computed, and shared out to points and to the block's node sums.
  class BlockForces
  {
  public:
    struct Target
    {
      const ContactScene               &scene;
      const CandidateBlock             &block;
      const std::vector<PressurePatch> &patches;
      NodeSums::Force                  *node_sums;
      BlockReport                      &report;
    };

    void add(const ContactLaw &law, const NarrowPhase &narrow_phase, const PointMemory &memory, const Target &target);

  private:
    void        compute_batch(const ContactLaw &law, const NarrowPhase &narrow_phase, const PointMemory &memory,
                              const Target &target, std::size_t begin);
    void        share_out(const NarrowPhase &narrow_phase, const Target &target, bool has_friction);
    static void add_couple(const Target &target, const TouchingPair &touch, const PairGeometry &geometry,
                           const Point3 &force);
    static void add_to_patches(const Target &target, const TouchingPair &touch, const Point3 &closest,
                               const Point3 &force);

    std::array<AlignedVector<double>, 3> forces; // [touch], N, on the point
    AlignedVector<double>                stored, dissipated;
  };
} // namespace birdstrike
