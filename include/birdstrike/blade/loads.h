#pragma once

#include <birdstrike/blade/expression.h>
#include <birdstrike/blade/parameters.h>
#include <birdstrike/blade/surface_mesh.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// Prescribed loads: a follower pressure p(x, y, z, t) at reference positions, pushing along the present element
  /// normal,
  ///   f_i = p A n / 4 on each node (A n half the cross product of the diagonals),
  /// and dead forces and moments on single nodes. Evaluated serially; nothing is stored or looped over when absent.
  class Loads
  {
  public:
    /// Throws InputError for formulas that cannot be read and for load points farther than an element from any node.
    Loads(const BladeParameters::Loads &parameters, const SurfaceMesh &mesh);

    bool is_active() const;

    /// Adds to force [n_nodes][6] (N, N m) at positions [n_nodes][3] (m) and time (s).
    void add_forces(double time, const double *position, double *force) const;

  private:
    struct PointLoad
    {
      std::uint32_t node;
      Expression    components; ///< fx fy fz mx my mz in t
    };

    std::vector<std::array<std::uint32_t, 4>> cells;
    std::vector<std::array<double, 3>>        centroids;
    std::vector<Expression>                   pressure; ///< none or one
    std::vector<PointLoad>                    point_loads;
  };
} // namespace birdstrike
