#pragma once

#include <birdstrike/contact/candidate_block.h>
#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/contact/sharp_edges.h>
#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/thread_pool.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// Pairs (point, facet) that may touch before the next search, by blocks of points.
  ///
  /// A search collects the pairs whose boxes are within `range` + margin. They serve until the path travelled since,
  /// the sum over calls of max |dx_points| + max |dx_nodes| in a frame that moves with the first node, has used up the
  /// margin, with the last step once more in reserve: a point is on the list a step before it can touch.
  ///
  /// Nodes without a facet (whose elements have failed) count for nothing.
  ///
  /// A block whose box is away from the surface's box has no pairs and no share in that path: its points cost the three
  /// loads of their box. A search is due when one comes within range + margin/2, and takes up all within range + 3/2
  /// margin. While all blocks are away nothing else is done.
  class CandidateSearch
  {
  public:
    struct Counts
    {
      std::uint64_t searches = 0; ///< lists built
      std::uint64_t reused   = 0; ///< calls served by the last list
      std::uint64_t apart    = 0; ///< calls with boxes apart: nothing searched, nothing computed
    };

    /// Makes the pairs valid for the present positions. `range` is the largest distance at which a pair can touch, m.
    /// Blocks know the facets at `edges` near their own too.
    void update(const PointsView &points, const FacetsView &facets, double range, double margin, ThreadPool &pool,
                const SharpEdges *edges = nullptr);

    /// Lists that views of others have outdated are not written: the next call makes new ones.
    void archive(Archive &archive, const PointsView &points, const FacetsView &facets);

    /// Forces a search at the next call.
    void forget();

    std::vector<CandidateBlock> &blocks()
    {
      return all_blocks;
    }
    const std::vector<CandidateBlock> &blocks() const
    {
      return all_blocks;
    }

    std::size_t n_near() const ///< points on the list
    {
      return n_near_points;
    }
    std::size_t n_pairs() const;

    double nodes_motion() const ///< m, largest since the last call, relative to the first node
    {
      return largest_node_motion;
    }
    const Counts &counts() const
    {
      return n_calls;
    }

  private:
    struct NodePart
    {
      Box    box;
      double motion_squared = 0.;    // largest, m^2
      bool   has_loose      = false; // nodes without a facet
    };

    bool   is_of(const PointsView &points, const FacetsView &facets) const; ///< the lists
    void   set_blocks(const PointsView &points, const FacetsView &facets);
    void   set_node_parts(const FacetsView &facets);
    void   watch(const PointsView &points, const FacetsView &facets, ThreadPool &pool);
    void   watch_points(const PointsView &points, const Point3 &shift, CandidateBlock &block);
    void   watch_nodes(const FacetsView &facets, const Point3 &shift, std::size_t part);
    void   watch_facet_nodes(const FacetsView &facets, const Point3 &shift, std::size_t part);
    void   watch_node(const FacetsView &facets, const Point3 &shift, std::size_t node, NodePart &seen);
    double closest_away() const;
    void   find_pairs(const PointsView &points, const FacetsView &facets, double reach, ThreadPool &pool,
                      const SharpEdges *edges);
    void   count_near();

    FacetGrid                   grid;
    std::vector<CandidateBlock> all_blocks;
    std::vector<NodePart>       node_parts;
    std::size_t                 n_near_points = 0;

    std::array<AlignedVector<double>, 3> old_points; // positions at the last call, of tracked blocks
    AlignedVector<double>                old_nodes;
    std::vector<unsigned char>           is_loose; // [n_nodes], without a facet
    std::uint64_t                        points_revision = 0, facets_revision = 0;
    std::size_t                          n_facets = 0;
    Box                                  surface;                     // of all nodes, now
    double                               path = 0., last_motion = 0.; // m, of all blocks
    double                               largest_node_motion = 0.;
    bool                                 is_known = false, is_tracking = false;
    Counts                               n_calls;
  };
} // namespace birdstrike
