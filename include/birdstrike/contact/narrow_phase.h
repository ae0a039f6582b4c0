#pragma once

#include <birdstrike/contact/pair_geometry.h>
#include <birdstrike/contact/point_memory.h>
#include <birdstrike/contact/surface_topology.h>

#include <vector>

namespace birdstrike
{
  /// One point that touches one facet.
  struct TouchingPair
  {
    std::uint32_t place;              ///< in PairGeometry
    std::uint32_t near;               ///< place of the point in CandidateBlock::points
    double        share       = 0.;   ///< -, in (0, 1]: weight of the less deep of two, see NarrowPhase
    double        penetration = 0.;   ///< m, > 0
    Point3        normal;             ///< from the surface to the point
    bool          is_oblique = false; ///< not along the point's offset from q: the force leaves a couple
    EdgePlace     edge{};             ///< where the force acts, if not at q
  };

  /// A depth that has fallen by more than the way of its point, as that came to another facet or out behind an edge.
  struct ReleasedDepth
  {
    std::uint32_t id;       ///< of the point
    double        due, now; ///< m, at least what it would be, and what it is
  };

  /// What the decision rests on.
  struct ContactScene
  {
    const PointsView      &points;
    const FacetsView      &facets;
    const SurfaceTopology &topology;
    double                 step;               ///< s
    double                 range;              ///< m, the largest offset g
    std::uint64_t          call;               ///< number of this call, one more than that of the last
    bool                   is_first;           ///< penetrations found now become references
    bool                   is_changed = false; ///< facets have come or gone: so do those of points that touched nothing
    double                 nodes_motion = 0.;  ///< m, largest of a node since the last call
  };

  /// Decides which candidates touch, on which side and how deep: signed distance s to the closest point against the
  /// offset g = t/2 + V^(1/3)/2,  d = g - s.
  ///
  /// *Side.* The sign is that of the closest facet's normal; where facets tie at a common edge, that of the facet seen
  /// least edge-on (the angle-weighted pseudo-normal of Baerentzen and Aanaes 2005 decides alike at an edge), of a
  /// second touch too. Distances tie within 1e-9 of the range: round-off of positions 1000 m away is a tenth of it. It
  /// is remembered per point and place of the surface (the facet's nodes; elsewhere on the same piece a side gives no
  /// depth that was not flown) while the point is near: a fast point that has come through the middle surface is pushed
  /// back to where it came from. Beyond a free edge there is no side: from there a point may pass to the other.
  ///
  /// *Edges.* Free edges of shells and ridges of skins bound the offset surface: the blade ends where it ends, not half
  /// a thickness or half a spacing beyond (edge_profile.h, SharpEdges). What comes in from the side keeps its height.
  ///
  /// *The skin of a solid* (one-sided) is the same with the outside as the only side. A point that has come through it
  /// keeps to the facets that look towards where it came from: of an edge thinner than the point, the face behind may
  /// be nearer, and would draw it through. A point that was never seen outside is left alone.
  ///
  /// *Several facets.* A point touches its closest facet, and a second one only where that is a local minimum of the
  /// distance and pushes in another direction (between two shells, in a notch). With the cosine between the two
  /// directions falling from 0.5 to 0.2 the share of the less deep one rises from 0 to 1, U = U(max d) + share U(min
  /// d); so a slightly folded surface never counts twice, and the potential is continuous where nearest and second
  /// change places with different references. Where one of two ends at an edge of the other, its depth goes on there. A
  /// third facet (inner corner of a box) is not seen.
  ///
  /// *Who is looked at.* Points closer than the larger of max g and four steps' flight of their own, but no further
  /// than one step beyond max g. Of one further away there is nothing to remember: it cannot pass the surface before it
  /// is next seen, and so its side is then again the one on which it is. Only one that has already passed is kept awake
  /// wherever it is.
  class NarrowPhase
  {
  public:
    /// Fills touches() for one block, in the order of its points.
    void update(const ContactScene &scene, CandidateBlock &block, PointMemory &memory);

    const std::vector<TouchingPair> &touches() const
    {
      return touching;
    }
    /// Springs held them, and their energy is lost: the depth's change is none of the point's way.
    const std::vector<ReleasedDepth> &released() const
    {
      return released_depths;
    }
    const PairGeometry &geometry() const
    {
      return pairs;
    }
    std::size_t n_active() const ///< points with an awake pair
    {
      return n_active_points;
    }

  private:
    /// Of the size: what a depth may change by besides the way of the point, in a step.
    static constexpr double leap = 1e-3;

    struct Group;
    void          note_release(const ContactScene &scene, std::uint32_t point, const PointRecord &before,
                               const PointRecord &record, double depth);
    void          decide(const ContactScene &scene, const Group &group, PointMemory &memory);
    bool          is_before(std::uint32_t k, std::uint32_t best) const; // as the nearest one, or among equals
    std::uint32_t nearest(const Group &group) const;
    std::uint32_t way_in(const Group &group, const ContactScene &scene, std::uint32_t closest,
                         const PointRecord &before) const;
    std::int64_t  opposed(const Group &group, const ContactScene &scene, std::uint32_t first, double reach) const;
    bool          is_local_minimum(const Group &group, const ContactScene &scene, std::uint32_t place) const;
    bool          touch(const ContactScene &scene, std::uint32_t place, const PointRecord &before, bool is_other_sheet,
                        int &taken, TouchingPair &result, PointRecord::Side &side) const;
    void          keep_passed_awake(const ContactScene &scene, PointMemory &memory);
    double        way_of(const ContactScene &scene, std::uint32_t place) const; // m, of the point against the facet
    void          keep_awake(std::uint32_t near);
    std::uint32_t facet_of(const std::uint32_t place) const // global
    {
      return block->facets.keys()[block->pair_facet[pairs.pair[place]]];
    }

    PairGeometry               pairs;
    std::vector<TouchingPair>  touching;
    std::vector<ReleasedDepth> released_depths;
    std::size_t                n_active_points = 0;
    CandidateBlock            *block           = nullptr; // in work
    double                     tied            = 0.;      // m, difference of equal distances
  };
} // namespace birdstrike
