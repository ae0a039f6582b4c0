#include <birdstrike/contact/facet_grid.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  std::array<Point3, 4> facet_nodes(const FacetsView &facets, const std::size_t facet)
  {
    std::array<Point3, 4> x;
    for (unsigned int k = 0; k < 4; ++k)
      x[k] = Eigen::Map<const Point3>(facets.position + 3 * facets.nodes[facet][k]);
    return x;
  }

  void FacetGrid::update(const FacetsView &facets, const double reach, const Box &region)
  {
    all = Box();
    boxes.assign(facets.n_facets, Box());
    chosen.clear();
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      {
        for (const std::uint32_t node : facets.nodes[f])
          boxes[f].add(facets.position + 3 * node, reach);
        if (boxes[f].separation(region) > 0.)
          continue;
        chosen.push_back(static_cast<std::uint32_t>(f));
        all.add(boxes[f]);
      }
    set_cells();

    // counting sort: count, offsets, fill; facets come in ascending order
    first.assign(n_cells[0] * n_cells[1] * n_cells[2] + 1, 0);
    for (const std::uint32_t f : chosen)
      visit_cells(boxes[f], [&](const std::size_t cell) { ++first[cell + 1]; });
    for (std::size_t c = 1; c < first.size(); ++c)
      first[c] += first[c - 1];
    entries.resize(first.back());
    for (const std::uint32_t f : chosen)
      visit_cells(boxes[f], [&](const std::size_t cell) { entries[first[cell]++] = f; });
    for (std::size_t c = first.size() - 1; c > 0; --c)
      first[c] = first[c - 1];
    first[0] = 0;
  }

  void FacetGrid::set_cells()
  {
    n_cells = {1, 1, 1};
    if (chosen.empty())
      return;
    double mean_size = 0.; // of the longest sides of the boxes
    for (const std::uint32_t f : chosen)
      {
        const Box &box = boxes[f];
        mean_size += std::max({box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]});
      }
    double cell = mean_size / static_cast<double>(chosen.size());
    for (std::size_t n_total = std::size_t(-1); n_total > 4 * chosen.size() + 1; cell *= 1.26) // 2 in volume
      {
        n_total = 1;
        for (unsigned int d = 0; d < 3; ++d)
          {
            const double length = all.high[d] - all.low[d];
            n_cells[d]          = std::max<std::size_t>(1, static_cast<std::size_t>(std::min(length / cell, 1e6)));
            cells_per_metre[d]  = length > 0. ? n_cells[d] / length : 0.;
            n_total *= n_cells[d];
          }
      }
  }

  std::array<std::size_t, 3> FacetGrid::cell_of(const double *p) const
  {
    std::array<std::size_t, 3> cell;
    for (unsigned int d = 0; d < 3; ++d)
      cell[d] =
        std::min(n_cells[d] - 1, static_cast<std::size_t>(std::max(0., (p[d] - all.low[d]) * cells_per_metre[d])));
    return cell;
  }

  std::size_t FacetGrid::count_cells(const Box &box) const
  {
    const auto low = cell_of(box.low.data()), high = cell_of(box.high.data());
    return (high[0] - low[0] + 1) * (high[1] - low[1] + 1) * (high[2] - low[2] + 1);
  }
} // namespace birdstrike
