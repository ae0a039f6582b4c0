#include "structure/surface/contact_surface.h"

namespace birdstrike
{
  ContactSurface::ContactSurface(const SurfaceMesh &whole, std::vector<double> half_thickness)
    : whole(whole), whole_half_thickness(std::move(half_thickness))
  {
  }

  void ContactSurface::remove(const FunctionRef<bool(std::size_t)> is_gone)
  {
    std::vector<std::int32_t> number(whole.cells.size(), FacetsView::free_edge);
    cells.clear();
    half_thickness.clear();
    for (std::size_t f = 0; f < whole.cells.size(); ++f)
      if (!is_gone(f))
        {
          number[f] = static_cast<std::int32_t>(cells.size());
          cells.push_back(whole.cells[f]);
          half_thickness.push_back(whole_half_thickness[f]);
        }
    neighbors.clear();
    for (std::size_t f = 0; f < whole.cells.size(); ++f)
      if (number[f] >= 0)
        {
          auto &left = neighbors.emplace_back(whole.neighbors[f]);
          for (std::int32_t &neighbor : left)
            if (neighbor >= 0)
              neighbor = number[static_cast<std::size_t>(neighbor)];
        }
    ++revision;
  }

  void ContactSurface::offer(FacetsView &view) const
  {
    const bool is_whole = revision == 0;
    view.n_facets       = (is_whole ? whole.cells : cells).size();
    view.nodes          = (is_whole ? whole.cells : cells).data();
    view.neighbor       = (is_whole ? whole.neighbors : neighbors).data();
    view.half_thickness = (is_whole ? whole_half_thickness : half_thickness).data();
    view.revision       = revision;
  }
} // namespace birdstrike
