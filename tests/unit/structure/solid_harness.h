#pragma once

#include "some_motion.h"

#include "structure/elements/solid/elements.h"

#include <cmath>
#include <functional>
#include <memory>

/// Solid elements without the blade around them: structured meshes, the tangent by finite increments, linear statics
/// and frequencies, central differences.
namespace solid_harness
{
  using namespace birdstrike;

  struct Mesh
  {
    std::vector<Point3>                       nodes;
    std::vector<std::array<std::uint32_t, 8>> cells;
  };

  /// nx x ny x nz bricks of (0,1)^3, mapped; node (i, j, k) is i + (nx + 1) (j + (ny + 1) k).
  Mesh make_grid(const std::array<unsigned int, 3> &n, const std::function<Point3(double, double, double)> &map);
  Mesh make_box(const std::array<unsigned int, 3> &n, const Point3 &size);
  /// MacNeal & Harder (1985): unit cube with eight inner nodes, seven irregular bricks. Nodes 0-7 are the corners.
  Mesh make_patch();

  SolidSection make_section(double young, double poisson, SolidFormulation formulation = SolidFormulation::one_point);

  struct Model
  {
    Mesh                mesh;
    SolidSection        section;
    ThreadPool          pool;
    SolidElements       elements;
    std::vector<double> position;

    Model(const Mesh &mesh, const SolidSection &section, std::size_t n_threads = 1);
    ~Model();

    std::size_t n_dofs() const
    {
      return 3 * mesh.nodes.size();
    }

    /// Moves the nodes by an increment of 3 components each; returns the force of the elements on the nodes.
    Eigen::VectorXd move(const Eigen::VectorXd &increment, double dt = 1.);

    /// Stiffness of the stress-free state: increments so small (1e-14 of the size) that nothing non-linear is left;
    /// they are given beside the positions, so nothing is lost to cancellation. Nodes that share no element are moved
    /// together.
    Eigen::MatrixXd compute_stiffness();

    /// Displacements under nodal loads; held dofs keep the given values, or none.
    Eigen::VectorXd solve(const Eigen::VectorXd &load, const std::vector<bool> &held, const Eigen::VectorXd &given);
    Eigen::VectorXd solve(const Eigen::VectorXd &load, const std::vector<bool> &held);

    /// Lowest natural frequencies (Hz) with lumped masses, by subspace iteration.
    std::vector<double> compute_frequencies(const std::vector<bool> &held, int n);
  };

  /// Largest omega^2 (1/s^2) of the assembled elements with lumped masses, all nodes free.
  double exact_eigenvalue(Model &model);

  /// Central differences with lumped masses, velocities at half steps; some components held.
  struct Motion
  {
    Model              &model;
    std::vector<double> mass;
    std::vector<bool>   held;
    Eigen::VectorXd     velocity, force, increment;
    double              last_dt = 0., initial_energy = 0.;

    explicit Motion(Model &model);

    void   step(double dt);
    double kinetic_energy() const; ///< at the whole step
    double total_energy() const;
  };
} // namespace solid_harness
