#pragma once

#include <birdstrike/core/archive.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/function_ref.h>
#include <birdstrike/mesh/cell_mesh.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// The facets that contact meets: all of a surface, and after failures those that are left, in the same order. Edges
  /// towards facets that have gone are free ones. As long as nothing has failed nothing is copied.
  class ContactSurface
  {
  public:
    /// `half_thickness` (m) per facet. The surface must outlive this.
    ContactSurface(const SurfaceMesh &whole, std::vector<double> half_thickness);

    /// Takes away the facets of the whole surface for which `is_gone` says so (those gone before among them).
    void remove(FunctionRef<bool(std::size_t)> is_gone);

    /// Sets the facets of a view; its nodes are the owner's.
    void offer(FacetsView &view) const;

    /// How often facets have gone; which, follows from the elements.
    void archive(Archive &archive)
    {
      archive("surface revision", revision);
    }

  private:
    const SurfaceMesh                        &whole;
    std::vector<double>                       whole_half_thickness;
    std::vector<std::array<std::uint32_t, 4>> cells;
    std::vector<std::array<std::int32_t, 4>>  neighbors;
    std::vector<double>                       half_thickness;
    std::uint64_t                             revision = 0;
  };
} // namespace birdstrike
