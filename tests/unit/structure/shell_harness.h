#pragma once

#include "some_motion.h"

#include "structure/elements/shell/elements.h"

#include <cmath>
#include <functional>
#include <memory>

/// Shell elements without the blade around them: structured meshes, the tangent by finite increments, linear statics.
namespace shell_harness
{
  using namespace birdstrike;

  /// Those that hold for warped elements and any mesh, and all.
  inline constexpr ShellFormulation covariant_formulations[] = {ShellFormulation::one_point_physical,
                                                                ShellFormulation::fully_integrated};
  inline constexpr ShellFormulation all_formulations[]       = {
          ShellFormulation::one_point_physical, ShellFormulation::belytschko_tsay, ShellFormulation::fully_integrated};

  const char *name_of(ShellFormulation formulation);

  struct Mesh
  {
    std::vector<Point3>                       nodes;
    std::vector<std::array<std::uint32_t, 4>> cells;
  };

  /// nx x ny quadrilaterals of (0,1)^2, mapped; node (i, j) is i + (nx + 1) j, normals along dx x dy.
  Mesh make_grid(unsigned int nx, unsigned int ny, const std::function<Point3(double, double)> &map);
  /// MacNeal & Harder (1985): plate 0.24 x 0.12 with four inner nodes, five irregular elements. Nodes 0-3 are corners.
  Mesh make_patch();
  Mesh warped_mesh(unsigned int nx, unsigned int ny);

  ShellSection make_section(double young, double poisson,
                            ShellFormulation formulation = ShellFormulation::one_point_physical);
  ShellSection titanium(HardeningLaw law, double hardening = 0.,
                        ShellFormulation formulation = ShellFormulation::one_point_physical);

  struct Model
  {
    Mesh                mesh;
    ShellSection        section;
    double              thickness;
    ThreadPool          pool;
    ShellElements       elements;
    std::vector<double> position;

    Model(const Mesh &mesh, double thickness, const ShellSection &section, std::size_t n_threads = 1);
    ~Model();

    std::size_t n_dofs() const
    {
      return 6 * mesh.nodes.size();
    }

    /// Moves the nodes by an increment of 6 components each; returns the force of the elements on the nodes.
    Eigen::VectorXd move(const Eigen::VectorXd &increment, double dt = 1.);

    /// Stiffness of the stress-free state: increments so small (1e-14 of the size) that nothing non-linear is left;
    /// they are given beside the positions, so nothing is lost to cancellation.
    Eigen::MatrixXd compute_stiffness();

    /// Displacements under nodal loads; held dofs keep the given values, or none. Free drilling gets a stiffness that
    /// nothing feels, since drilling neither takes nor makes force.
    Eigen::VectorXd solve(const Eigen::VectorXd &load, const std::vector<bool> &held, const Eigen::VectorXd &given);
    Eigen::VectorXd solve(const Eigen::VectorXd &load, const std::vector<bool> &held);
  };

  /// Largest omega^2 (1/s^2) of the assembled elements with lumped masses, all nodes free.
  double exact_eigenvalue(Model &model);
} // namespace shell_harness
