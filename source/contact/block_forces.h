#pragma once

#include "contact/law.h"
#include <birdstrike/contact/node_sums.h>
#include <birdstrike/contact/parameters.h>
#include <birdstrike/contact/point_memory.h>
#include <birdstrike/contact/report.h>
#include <birdstrike/contact/touch_record.h>

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
      const PointsView                 &points;
      const FacetsView                 &facets;
      const PointForces                &point_forces;
      std::vector<TouchRecord>         &touches; ///< get their dissipative forces
      const std::vector<PressurePatch> &patches;
      NodeSums::Sum                    *node_sums; ///< of the block, by its numbers
      const double                     *mobility;  ///< S_k/m_k of the same nodes, 1/kg
      BlockReport                      &report;
    };

    void add(const ContactLaw &law, const PointMemory &memory, const Target &target);

  private:
    void compute_batch(const ContactLaw &law, const PointMemory &memory, const Target &target, std::size_t begin);
    /// The two facets of a ridge turn together: the moments of their forces along the normal add up to that of the
    /// point if they are equal. Their dampers are limited by the masses of different nodes.
    void        join_halves(const std::vector<TouchRecord> &touches);
    void        share_out(const Target &target, bool has_friction);
    static void add_couple(const Target &target, TouchRecord &touch, bool has_friction, const Point3 &force);
    static void add_to_patches(const Target &target, const TouchRecord &touch, const Point3 &force);

    std::array<AlignedVector<double>, 3> forces, dissipative; // [touch], N, on the point
    AlignedVector<double>                stored, tangent;     // J, N/m
  };
} // namespace birdstrike
