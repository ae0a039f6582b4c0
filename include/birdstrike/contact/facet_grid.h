#pragma once

#include <birdstrike/core/box.h>
#include <birdstrike/core/contact_views.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// The four nodes of a facet.
  std::array<Point3, 4> facet_nodes(const FacetsView &facets, std::size_t facet);

  /// A uniform grid over the boxes of the facets that meet a region, each widened by `reach`. The cells are about as
  /// large as one such box and no more than four a facet, so a single large facet has a single cell.
  class FacetGrid
  {
  public:
    void update(const FacetsView &facets, double reach, const Box &region = Box::everything());

    const Box &box() const ///< of all widened facets that meet the region
    {
      return all;
    }
    const Box &box(const std::uint32_t facet) const
    {
      return boxes[facet];
    }
    std::size_t n_facets() const
    {
      return boxes.size();
    }

    /// Facets by the cells that a box meets (which must meet box()): a facet may come several times.
    std::size_t count_cells(const Box &box) const;
    template <class Visit>
    void visit_near(const Box &box, const Visit &visit) const
    {
      visit_cells(box, [&](const std::size_t cell) {
        for (std::uint32_t e = first[cell]; e < first[cell + 1]; ++e)
          visit(entries[e]);
      });
    }

  private:
    std::array<std::size_t, 3> cell_of(const double *p) const;
    void                       set_cells();
    template <class Visit>
    void visit_cells(const Box &box, const Visit &visit) const
    {
      const auto low = cell_of(box.low.data()), high = cell_of(box.high.data());
      for (std::size_t k = low[2]; k <= high[2]; ++k)
        for (std::size_t j = low[1]; j <= high[1]; ++j)
          for (std::size_t i = low[0]; i <= high[0]; ++i)
            visit((k * n_cells[1] + j) * n_cells[0] + i);
    }

    Box                        all;
    std::vector<Box>           boxes;
    std::vector<std::uint32_t> chosen; // facets that meet the region
    std::array<std::size_t, 3> n_cells{};
    std::array<double, 3>      cells_per_metre{};
    std::vector<std::uint32_t> first, entries; // facets by cell
  };
} // namespace birdstrike
