#pragma once

#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/thread_pool.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// Pairs (point, facet) that may touch before the next search.
  ///
  /// A search collects the pairs within `range` + margin. They serve until the motion of points and nodes since then,
  /// in a frame that moves with the first node, may have used up the margin, max |dx_points| + max |dx_nodes| > margin,
  /// with the last motion once more in reserve: a point is on the list a step before it can touch. While the boxes of
  /// points and facets are further apart than that, their distance is the margin, and there are no pairs.
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
    void update(const PointsView &points, const FacetsView &facets, double range, double margin, ThreadPool &pool);

    /// Forces a search at the next call.
    void forget();

    /// Pairs sorted by point, then facet; the arrays are padded to whole SIMD batches with copies of the last pair.
    std::size_t n_pairs() const
    {
      return n_real_pairs;
    }
    const std::vector<std::uint32_t> &pair_point() const ///< index of the point, not its id
    {
      return point_of_pair;
    }
    const std::vector<std::uint32_t> &pair_facet() const
    {
      return facet_of_pair;
    }

    /// Points that have pairs: the k-th has pairs first_pair()[k] to first_pair()[k + 1].
    std::size_t n_near() const
    {
      return first_pair_of_near.empty() ? 0 : first_pair_of_near.size() - 1;
    }
    const std::vector<std::uint32_t> &first_pair() const
    {
      return first_pair_of_near;
    }
    const Counts &counts() const
    {
      return n_calls;
    }

  private:
    struct Chunk
    {
      std::vector<std::uint32_t> points, facets;
    };

    bool        is_valid(const PointsView &points, const FacetsView &facets, ThreadPool &pool);
    void        find_pairs(const PointsView &points, const FacetsView &facets, double reach, ThreadPool &pool);
    static void keep_close(Chunk &chunk, const PointsView &points, const FacetsView &facets, double reach);
    void        join_chunks();

    FacetGrid                  grid;
    std::vector<Chunk>         chunks; // of points
    std::vector<std::uint32_t> point_of_pair, facet_of_pair, first_pair_of_near;
    std::size_t                n_real_pairs = 0;

    std::array<AlignedVector<double>, 3> old_points; // positions at the last search
    AlignedVector<double>                old_nodes;
    std::uint64_t                        points_revision = 0, facets_revision = 0;
    double                               allowed_motion = -1., last_motion = 0.; // m
    bool                                 is_apart = false;
    Counts                               n_calls;
  };
} // namespace birdstrike
