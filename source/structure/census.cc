#include "structure/census.h"

#include <algorithm>
#include <limits>
#include <map>

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
      census.seams         = mesh.open_seams;
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
      census.file_notes         = mesh.file_notes;
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

  std::vector<SupportCensus> compute_support_census(const std::vector<std::array<double, 3>> &nodes,
                                                    const unsigned int                        n_unknowns,
                                                    const std::vector<std::uint32_t>         &held_dofs,
                                                    const std::vector<std::uint32_t>         &driven_dofs)
  {
    using Components = std::array<bool, 6>;
    std::map<std::uint32_t, std::pair<Components, Components>> of_node;
    for (const std::uint32_t dof : held_dofs)
      of_node[dof / n_unknowns].first[dof % n_unknowns] = true;
    for (const std::uint32_t dof : driven_dofs)
      {
        auto &[held, driven]     = of_node[dof / n_unknowns];
        held[dof % n_unknowns]   = false;
        driven[dof % n_unknowns] = true;
      }
    std::map<std::pair<Components, Components>, SupportCensus> supports;
    for (const auto &[node, components] : of_node)
      {
        SupportCensus &support = supports[components];
        const auto    &x       = nodes[node];
        if (support.n_nodes++ == 0)
          support = {components.first, components.second, 1, x, x};
        for (unsigned int d = 0; d < 3; ++d)
          {
            support.low[d]  = std::min(support.low[d], x[d]);
            support.high[d] = std::max(support.high[d], x[d]);
          }
      }
    std::vector<SupportCensus> result;
    for (const auto &[components, support] : supports)
      result.push_back(support);
    return result;
  }
} // namespace birdstrike
