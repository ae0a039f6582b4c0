#pragma once

#include <birdstrike/contact/point_memory.h>
#include <birdstrike/contact/search.h>
#include <birdstrike/contact/surface_topology.h>
#include <birdstrike/core/aligned_vector.h>

#include <array>
#include <vector>

namespace birdstrike
{
  /// One point that touches one facet.
  struct TouchingPair
  {
    std::uint32_t pair;        ///< of the candidate list
    double        share;       ///< -, in (0, 1]: weight of a second facet, see NarrowPhase
    double        penetration; ///< m, > 0
    Point3        normal;      ///< from the surface to the point
  };

  /// What the decision rests on.
  struct ContactScene
  {
    const PointsView      &points;
    const FacetsView      &facets;
    const CandidateSearch &candidates;
    const SurfaceTopology &topology;
    double                 step;     ///< s
    bool                   is_first; ///< penetrations found now become references
  };

  /// Decides which candidates touch, on which side and how deep: signed distance s to the closest point against the
  /// offset g = t/2 + V^(1/3)/2,  d = g - s.
  ///
  /// *Side.* The sign is that of the closest facet's normal; where facets tie at a common edge, that of the facet seen
  /// least edge-on (the angle-weighted pseudo-normal of Baerentzen and Aanaes 2005 decides alike at an edge). It is
  /// remembered per point and piece of surface while the point is near: a fast point that has come through the middle
  /// surface is pushed back to where it came from. Beyond a free edge there is no side: the distance is unsigned, the
  /// surface ends in a half cylinder of radius g, and from there a point may pass to the other side.
  ///
  /// *Several facets.* A point touches its closest facet, and a second one only where that is a local minimum of the
  /// distance and pushes in another direction (between two shells, in a notch). With the cosine between the two
  /// directions falling from 0.5 to 0.2 the second share rises from 0 to 1; so a slightly folded surface never counts
  /// twice. A third facet (inner corner of a box) is not seen.
  class NarrowPhase
  {
  public:
    /// Fills `touches` in the order of the candidate list. To be called at every step, also without candidates: memory
    /// lasts from one call to the next.
    void update(const ContactScene &scene, PointMemory &memory, ThreadPool &pool);

    const std::vector<TouchingPair> &touches() const
    {
      return touching;
    }

    /// Of one pair: p - q, m, and the shares of the four nodes.
    Point3 offset(const std::uint32_t pair) const
    {
      return Point3(offsets[0][pair], offsets[1][pair], offsets[2][pair]);
    }
    double weight(const std::uint32_t pair, const unsigned int k) const
    {
      return weights[k][pair];
    }

  private:
    struct Gap;
    void          compute_closest_points(const ContactScene &scene, ThreadPool &pool);
    void          decide(const ContactScene &scene, std::size_t near, PointMemory &memory);
    std::uint32_t nearest(std::uint32_t begin, std::uint32_t end) const;
    std::int64_t  opposed(const ContactScene &scene, std::size_t near, std::uint32_t first, double reach) const;
    bool          is_local_minimum(const ContactScene &scene, std::size_t near, std::uint32_t pair) const;
    Gap           compute_gap(const ContactScene &scene, std::uint32_t pair, double size) const;
    bool          touch(const ContactScene &scene, std::uint32_t pair, const PointRecord &before, TouchingPair &result,
                        PointRecord::Side &side) const;

    std::array<AlignedVector<double>, 3> offsets, normals; // [pair], m; unit normals of the facets
    std::array<AlignedVector<double>, 4> weights;
    AlignedVector<double>                distances; // m
    std::vector<TouchingPair>            slots;     // two for each near point; share 0: free
    std::vector<TouchingPair>            touching;
    std::uint64_t                        n_calls = 0;
  };
} // namespace birdstrike
