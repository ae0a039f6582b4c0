#pragma once

#include "structure/nodes/point_share.h"
#include <birdstrike/core/expression.h>
#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/structure/parameters.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// Prescribed loads: a follower pressure p(x, y, z, t) at reference positions, pushing along the present normal of
  /// quadrilaterals,
  ///   f_i = p A n / 4 on each node (A n half the cross product of the diagonals),
  /// dead forces and, on nodes with rotations, moments on single nodes, of a solid forces at the place that is given
  /// (point_share.h), and the rate of mass-proportional damping.
  /// Evaluated serially; nothing is stored or looped over when absent.
  class Loads
  {
  public:
    using Quadrilateral = std::array<std::uint32_t, 4>;

    /// Pressure acts on `pressed`, quadrilaterals of the mesh's nodes. Throws InputError for formulas that cannot be
    /// read, for load points farther than an element from any node of the surface, and for moments on nodes without
    /// rotations.
    template <int dim>
    Loads(const BladeParameters::Loads &parameters, const BladeMesh<dim> &mesh, std::vector<Quadrilateral> pressed);

    bool is_active() const;   ///< anything but damping
    bool has_pressure() const ///< a load that follows the surface
    {
      return !pressure.empty();
    }
    double damping() const; ///< 1/s

    /// From now on nothing presses on this one of the `pressed` (its element has failed).
    void stop_pressing(std::size_t quadrilateral);

    /// Adds to force [n_nodes][n_unknowns] (N, N m) at positions [n_nodes][3] (m) and time (s).
    void add_forces(double time, const double *position, double *force) const;

  private:
    struct PointLoad
    {
      std::vector<NodeShare> nodes;      ///< weights sum up to 1
      std::vector<TimeLaw>   components; ///< fx fy fz, of shells mx my mz too or not
    };

    template <int dim>
    void add_point_loads(const BladeParameters::Loads &parameters, const BladeMesh<dim> &mesh);

    unsigned int                       n_unknowns;
    double                             damping_rate;
    std::vector<Quadrilateral>         pressed;
    std::vector<std::array<double, 3>> centroids;
    std::vector<Expression>            pressure; ///< none or one
    std::vector<PointLoad>             point_loads;
  };
} // namespace birdstrike
