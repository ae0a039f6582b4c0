#pragma once

#include <birdstrike/core/archive.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/function_ref.h>
#include <birdstrike/mesh/cell_mesh.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// The facets of a solid that contact meets: its skin, and after failures the skin of the cells that are left, with
  /// the faces that failed neighbours have bared. Every edge of it has two facets of the same material: they are found
  /// by going round the edge from cell to cell, so that cells that touch at an edge only stay apart. Faces in the plane
  /// of symmetry are never facets; an edge there is a symmetry edge. Nothing is made before the first failure.
  class ErodingSkin
  {
  public:
    /// The mesh must outlive this.
    explicit ErodingSkin(const VolumeMesh &mesh);

    /// Makes the skin of the cells for which `is_gone` says no.
    void remove(FunctionRef<bool(std::size_t)> is_gone);

    /// Sets the facets of a view, one-sided and without thickness; its nodes are the owner's.
    void offer(FacetsView &view) const;

    /// How often facets have gone; which, follows from the elements.
    void archive(Archive &archive)
    {
      archive("surface revision", revision);
    }

  private:
    using Quadrilateral = std::array<std::uint32_t, 4>;

    std::int32_t facet_across(std::size_t cell, unsigned int face, std::uint32_t a, std::uint32_t b) const;

    const VolumeMesh                        &mesh;
    std::vector<std::array<std::int32_t, 6>> number; ///< [cells][faces], of the facet, or -1
    std::vector<Quadrilateral>               facets;
    std::vector<std::array<std::int32_t, 4>> neighbors;
    std::vector<double>                      half_thickness;
    std::uint64_t                            revision = 0;
  };
} // namespace birdstrike
