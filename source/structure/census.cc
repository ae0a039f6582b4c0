#include "structure/census.h"

#include <algorithm>
#include <limits>

namespace birdstrike
{
  namespace
  {
    template <class Mesh>
    BladeCensus count(const Mesh &mesh)
    {
      BladeCensus census;
      census.n_elements    = mesh.n_owned_cells;
      census.n_nodes       = mesh.space.n_owned();
      census.smallest_edge = std::numeric_limits<double>::infinity();
      double largest       = 0.;
      for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        {
          if (!mesh.is_owned(cell))
            continue;
          const double edge = mesh.smallest_edge(cell);
          largest           = std::max(largest, edge);
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

    double area_of(const SurfaceMesh &mesh)
    {
      double area = 0.;
      for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        area += mesh.is_owned(cell) ? mesh.area_vector(cell).norm() : 0.;
      return area;
    }
  } // namespace

  BladeCensus compute_census(const SurfaceMesh &mesh)
  {
    BladeCensus census = count(mesh);
    census.area        = area_of(mesh);
    return census;
  }

  BladeCensus compute_census(const VolumeMesh &mesh)
  {
    BladeCensus census = count(mesh);
    census.area        = area_of(mesh.skin);
    return census;
  }
} // namespace birdstrike
