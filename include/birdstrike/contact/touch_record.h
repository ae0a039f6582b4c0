#pragma once

#include <birdstrike/core/number.h>

#include <array>
#include <cstdint>

namespace birdstrike
{
  /// One touch of a point and a facet, with all that its force needs. Made by the narrow phase of a block while the
  /// geometry is in the cache; forces come in a second pass, for they depend on all touches of the same nodes.
  struct TouchRecord
  {
    Point3 normal;   ///< -grad d: from the surface to the point (law.h)
    Point3 velocity; ///< of the point relative to the facet's closest point and spin (couple.h), m/s
    Point3 offset;   ///< from there to the point, m
    /// At an edge the facet's turn is a part of -d's change: a force F along the normal puts -F turn_weights[k]
    /// turn_normal on node k, without a sum.
    Point3                turn_normal = Point3::Zero();
    std::array<double, 4> turn_weights{};
    /// And what of its moment that leaves, over the force along the normal, m: a facet's part, of the couple.
    Point3                left_over = Point3::Zero();
    std::array<double, 4> weights; ///< of the facet's nodes in its closest point
    std::array<double, 4> loads;   ///< sizes of their forces for a unit force: the weights, if there is no couple
    Point3                dissipative = Point3::Zero(); ///< force of damper and friction on the point, N
    Point3                turn = Point3::Zero(); ///< their couple on the nodes, -turn x (x_k - mean of the nodes), N/m
    Point3                tilt = Point3::Zero(); ///< and at an edge -turn_weights[k] tilt, N
    double                penetration;           ///< m
    double                share;                 ///< -, in (0, 1], of force and potential

    bool is_oblique;      ///< not along the offset: the force leaves a couple
    bool is_edge = false; ///< with the turns of an edge: of a couple only what friction leaves
    bool is_half = false; ///< the next one is on the other facet of a ridge, with the same force along the normal

    std::uint32_t                point; ///< its index in PointsView
    std::uint32_t                facet; ///< its index in FacetsView
    std::array<std::uint32_t, 4> nodes; ///< the facet's, by the numbers of the block
  };
} // namespace birdstrike
