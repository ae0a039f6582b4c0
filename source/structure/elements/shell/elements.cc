#include "structure/elements/shell/elements.h"
#include <birdstrike/core/errors.h>

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    const std::vector<double> &checked_thickness(const std::vector<double> &thickness, const std::size_t n_elements)
    {
      if (thickness.size() != n_elements)
        throw InputError("Shell elements: " + std::to_string(n_elements) + " elements with " +
                         std::to_string(thickness.size()) + " thicknesses; one is needed for each.");
      return thickness;
    }
  } // namespace

  ShellElements::ShellElements(const std::vector<Point3> &nodes, const std::vector<Cell> &cells,
                               const std::vector<double> &thickness, const Sections<ShellSection> &sections,
                               ThreadPool &pool)
    : Elements(nodes, cells, checked_thickness(thickness, cells.size()), sections, pool)
  {
  }

  void ShellElements::add_symmetry_plane(const std::span<const std::uint32_t> plane, const Point3 &plane_normal)
  {
    nodes.add_symmetry_plane(plane, plane_normal);
    for (ShellGroup &group : groups)
      group.update_bounds_at_rest(); // which rest on directors
  }

  std::vector<double> ShellElements::compute_rotary_inertias() const
  {
    std::vector<double> inertia(nodes.n_nodes, 0.);
    for (std::size_t e = 0; e < n_elements(); ++e)
      {
        const auto [group, k] = find(e);
        const double r        = lane(group.batches[k / n_lanes].radius2, k % n_lanes);
        for (const auto n : group.place.cells[k])
          inertia[n] += 0.25 * r * group.mass[k];
      }
    return inertia;
  }

  std::array<double, 4> ShellElements::failed_shares(const std::size_t element) const
  {
    const auto [group, e] = find(element);
    return group.failed_shares(e);
  }

  std::array<double, 2> ShellElements::failed_ply_mass(const std::size_t element) const
  {
    const auto [group, e] = find(element);
    auto shares           = group.failed_ply_shares(e);
    for (double &share : shares)
      share *= group.mass[e];
    return shares;
  }

  double ShellElements::elastic_energy() const
  {
    return stored_energy()[0];
  }

  double ShellElements::hourglass_energy() const
  {
    return sum(&ElementChunk::hourglass);
  }
} // namespace birdstrike
