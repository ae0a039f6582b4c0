#include <birdstrike/blade/census.h>

#include <algorithm>
#include <limits>

namespace birdstrike
{
  BladeCensus compute_census(const SurfaceMesh &mesh)
  {
    BladeCensus census;
    census.n_elements    = mesh.cells.size();
    census.n_nodes       = mesh.nodes.size();
    census.smallest_edge = std::numeric_limits<double>::infinity();
    double largest       = 0.;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      {
        const double edge = mesh.smallest_edge(cell);
        census.area += mesh.area_vector(cell).norm();
        largest = std::max(largest, edge);
        if (edge < census.smallest_edge)
          {
            const Point3 c       = mesh.centroid(cell);
            census.smallest_edge = edge;
            census.smallest_at   = {{c[0], c[1], c[2]}};
          }
      }
    census.largest_edge_ratio = largest / census.smallest_edge;
    return census;
  }
} // namespace birdstrike
