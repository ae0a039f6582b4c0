#pragma once

#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/number.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace birdstrike
{
  /// A surface in connected patches of up to some thirty facets that face nearly one way, and which of them may meet.
  ///
  /// Patches that are not neighbours may meet once their boxes come near. Neighbours (and a patch with itself) may only
  /// when the surface has turned back on itself between them: a piece whose normals lie in a cone of less than a right
  /// angle is a graph over a plane and does not cross itself (Volino and Magnenat-Thalmann, "Efficient self-collision
  /// detection on smoothly discretized surface animations", 1994, section 3). The cone asked for here leaves 30 degrees
  /// for the motion until the next look and for a thickness.
  ///
  /// On a one-sided surface two patches that lie behind one another have the material between them and cannot meet.
  class SurfacePatches
  {
  public:
    using Pair = std::array<std::uint32_t, 2>; ///< first <= second

    /// Groups the facets. Neighbours are patches with a common node, and those connected through patches nearer than
    /// `range` (m) in the reference positions [n_nodes][3].
    void update(const FacetsView &facets, const std::vector<double> &reference, double range);

    /// Takes boxes and normals at the present positions.
    void look(const FacetsView &facets);

    /// Finds the pairs that may come within `reach` (m). Those of `always` are taken whenever their boxes are near.
    void find_close(const FacetsView &facets, double reach, std::vector<Pair> always);

    const std::vector<Pair> &close_pairs() const ///< sorted
    {
      return close;
    }
    /// Neighbours that have not turned back on one another, sorted: graphs over a plane, whose rims alone may meet.
    const std::vector<Pair> &flat_pairs() const
    {
      return flat;
    }

    void archive(Archive &archive, const FacetsView &facets);

    std::size_t size() const
    {
      return patches.size();
    }
    const std::vector<std::uint32_t> &facets_of(const std::uint32_t patch) const
    {
      return patches[patch].facets;
    }
    /// Each node belongs to one patch.
    const std::vector<std::uint32_t> &points_of(const std::uint32_t patch) const
    {
      return patches[patch].points;
    }
    const Box &box(const std::uint32_t patch) const
    {
      return patches[patch].box;
    }
    const Box &facet_box(const std::uint32_t facet) const
    {
      return facet_boxes[facet];
    }
    std::uint32_t patch_of_facet(const std::uint32_t facet) const
    {
      return owner_of_facet[facet];
    }
    static constexpr std::uint32_t no_patch = 0xffffffff;
    std::uint32_t                  patch_of_point(const std::uint32_t node) const ///< no_patch: node without a facet
    {
      return owner_of_point[node];
    }
    double smallest_edge() const ///< m, of the mean of as many of the smallest facets as a patch has
    {
      return edge;
    }
    bool has_loose_nodes() const ///< nodes without a facet
    {
      return has_loose;
    }

  private:
    struct Patch
    {
      std::vector<std::uint32_t> facets, nodes, points, neighbors; // neighbours sorted
      Box                        box;
      Point3                     normal{0., 0., 0.};
      double                     half_angle = 0.; // rad, of the cone of normals
    };

    void   grow(const FacetsView &facets, std::uint32_t seed);
    void   collect_nodes(const FacetsView &facets);
    void   find_neighbors(const FacetsView &facets, const std::vector<double> &reference, double range);
    void   find_edge(const FacetsView &facets);
    bool   may_meet(const FacetsView &facets, std::uint32_t a, std::uint32_t b) const;
    bool   are_neighbors(std::uint32_t a, std::uint32_t b) const;
    bool   is_behind(const FacetsView &facets, const Patch &one, const Patch &other) const;
    double cone_angle(const Patch &one, const Patch &other) const;

    std::vector<Patch>         patches;
    std::vector<std::uint32_t> owner_of_facet, owner_of_point, order;
    std::vector<Point3>        normals; // of facets, unit
    std::vector<Box>           facet_boxes;
    std::vector<Pair>          close, flat;
    double                     edge      = 0.;
    bool                       has_loose = false;
  };
} // namespace birdstrike
