#pragma once

#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/number.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace birdstrike
{
  /// An axis-aligned box; empty until it has been extended.
  struct Box
  {
    std::array<double, 3> low{{1e300, 1e300, 1e300}}, high{{-1e300, -1e300, -1e300}};

    void add(const double *p, double margin = 0.);
    bool contains(const Point3 &p) const
    {
      return p[0] >= low[0] && p[0] <= high[0] && p[1] >= low[1] && p[1] <= high[1] && p[2] >= low[2] &&
             p[2] <= high[2];
    }
    bool is_empty() const
    {
      return low[0] > high[0];
    }

    /// Largest axis-wise distance to another box, m: a lower bound of the distance, negative where they overlap.
    double separation(const Box &other) const;

    void add(const Box &other);

    static Box everything()
    {
      return {{{-1e300, -1e300, -1e300}}, {{1e300, 1e300, 1e300}}};
    }
  };

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

    /// Facets whose widened box meets the cell of p (which must lie in box()), in ascending order.
    std::span<const std::uint32_t> near(const Point3 &p) const;

  private:
    std::array<std::size_t, 3> cell_of(const double *p) const;
    void                       set_cells();
    template <class Visit>
    void visit_cells(const Box &box, const Visit &visit) const;

    Box                        all;
    std::vector<Box>           boxes;
    std::vector<std::uint32_t> chosen; // facets that meet the region
    std::array<std::size_t, 3> n_cells{};
    std::array<double, 3>      cells_per_metre{};
    std::vector<std::uint32_t> first, entries; // facets by cell
  };
} // namespace birdstrike
