#pragma once

#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/contact/local_numbers.h>
#include <birdstrike/core/aligned_vector.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// A fixed number of consecutive points, those of them that are near the surface, and their pairs with facets. Facets
  /// and nodes near a block have numbers of its own: its work stays in the first-level cache and writes nowhere else.
  struct CandidateBlock
  {
    std::size_t begin = 0, end = 0; ///< range of points

    Box    box;                 ///< of its points, now
    double motion_squared = 0.; ///< m^2, largest of its points since the last call, relative to the first node
    AlignedVector<double> point_motions_squared; ///< [end - begin], m^2, likewise, of each; 0 where it is not tracked
    /// m, bounds of how far its points and any node have moved relative to each other, since the last search and since
    /// the last call.
    double path = 0., step_motion = 0.;
    bool   is_tracked = false; ///< it may have pairs
    bool   is_new     = false; ///< its list has not been used yet

    std::vector<std::uint32_t> points;     ///< near ones, ascending
    std::vector<unsigned char> has_passed; ///< [points], whether the point is beyond the surface that it touches
    std::vector<std::uint32_t> pair_near;  ///< [pair], place in `points`, ascending
    std::vector<std::uint32_t> pair_facet; ///< [pair], number in `facets`

    /// [pair], m, from number_surface() on padded to whole registers: a lower bound of the distance plus `path` when it
    /// was found. While this less the present path exceeds the reach, the pair sleeps.
    AlignedVector<double> pair_bound;

    LocalNumbers                              facets, nodes;
    std::size_t                               n_paired_facets = 0; ///< the first of them; those beside follow
    std::vector<std::array<std::uint32_t, 4>> facet_nodes;         ///< [facets], numbers in `nodes`
    double                                    speed      = 0.;     ///< m/s, bound of near point against facet
    std::size_t                               first_node = 0;      ///< sum of nodes of all blocks before
    std::size_t                               n_awake    = 0;      ///< pairs in the last call: its cost

    void clear();

    /// Gives the facets of the pairs, so far by their global index, those `beside` them, which have no pairs, and the
    /// nodes of all the block's own numbers.
    void number_surface(const FacetsView &facets, const std::vector<std::uint32_t> &beside = {});

    void find_speed(const PointsView &points, const FacetsView &facets);

    std::size_t n_pairs() const
    {
      return pair_near.size();
    }
  };
} // namespace birdstrike
