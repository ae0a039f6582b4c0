#pragma once

#include <birdstrike/contact/surface_patches.h>
#include <birdstrike/contact/surface_topology.h>
#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/contact_views.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// Pairs of a surface's own nodes and facets that may touch before the next look.
  ///
  /// A look takes the boxes of patches (surface_patches.h), and only where those may meet their nodes and facets. It
  /// collects the pairs nearer than the sum of half thicknesses and a margin. Until the nodes have moved relative to
  /// one another by most of the margin, a call costs one comparison a node (0.3 ns).
  ///
  /// A sheet that lies in one plane does not meet itself, but once facets have failed the rims of a hole may.
  ///
  /// A node never meets its own neighbourhood: the facets it belongs to, and those connected with them that are nearer,
  /// undeformed, than twice the sum of half thicknesses (fine meshes, noses, corners). Bent sheets stay apart from
  /// themselves by this: a piece of twice the thickness would have to turn by more than 200 degrees.
  class SelfSearch
  {
  public:
    struct Candidate
    {
      std::uint32_t point, facet;
      unsigned char own = 0; ///< bit k: node k of the facet belongs to a facet of the point's neighbourhood
    };

    /// Makes the list valid for the present positions. `touched` are (point, node of a facet) that touch now: their
    /// patches are looked at in any case. Returns whether the facets are others than in the call before.
    bool update(const FacetsView &facets, const SurfaceTopology &topology, double step,
                const std::vector<std::array<std::uint32_t, 2>> &touched);

    void archive(Archive &archive, const FacetsView &facets);

    const std::vector<Candidate> &candidates() const ///< sorted by point, then facet
    {
      return pairs;
    }
    double reach() const ///< m beyond the half thicknesses: pairs nearer than this are all on the list
    {
      return 0.25 * margin;
    }
    double edge() const ///< m, of a facet
    {
      return patches.smallest_edge();
    }
    std::uint64_t n_looks() const
    {
      return looks;
    }

  private:
    void   set_surface(const FacetsView &facets, const SurfaceTopology &topology);
    void   list_facets_of_nodes(const FacetsView &facets);
    bool   has_to_look(const FacetsView &facets);
    double largest_motion(const FacetsView &facets) const;
    void   look(const FacetsView &facets, const SurfaceTopology &topology, double step,
                const std::vector<std::array<std::uint32_t, 2>> &touched);
    void   set_margin(const FacetsView &facets, double step);
    void   add_candidates(const FacetsView &facets, const SurfaceTopology &topology,
                          const std::vector<SurfacePatches::Pair> &of_patches, bool rims_alone);
    void   add_candidates(const FacetsView &facets, const SurfaceTopology &topology, std::uint32_t patch,
                          bool rims_alone);
    void   mark_neighborhood(const FacetsView &facets, const SurfaceTopology &topology, std::uint32_t point);
    double reference_distance(const FacetsView &facets, std::uint32_t point, std::uint32_t facet) const;

    SurfacePatches             patches;
    std::vector<double>        reference; // [n_nodes][3], m, of the first call
    AlignedVector<double>      seen;      // [n_nodes][3], m, at the last look
    std::vector<std::uint32_t> first_facet, facets_of_node;
    std::uint32_t              anchor = 0; // node that the frame moves with

    std::vector<std::vector<std::uint32_t>> partners; // by patch
    std::vector<std::uint32_t>              near_facets, front, facet_mark, node_mark;
    std::uint32_t                           mark = 0;
    std::vector<Candidate>                  pairs;

    std::uint64_t revision = 0, looks = 0;
    std::size_t   n_facets = 0;
    double        margin = 0., last_motion = 0.;     // m
    bool          is_known = false, is_torn = false; // facets have failed
  };
} // namespace birdstrike
