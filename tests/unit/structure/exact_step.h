#pragma once

#include <birdstrike/core/number.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <vector>

/// The largest stable step of central differences about any state, from nothing but the elements' own forces.
namespace exact_step
{
  /// Moves the nodes by an increment [n_nodes][n_unknowns]; returns the force of the elements on the nodes.
  template <class Elements>
  Eigen::VectorXd move(Elements &elements, std::vector<double> &position, const Eigen::VectorXd &increment,
                       const double dt)
  {
    for (std::size_t d = 0; d < position.size(); ++d)
      position[d] += increment[d / 3 * Elements::n_unknowns + d % 3];
    Eigen::VectorXd force(increment.size());
    elements.compute_internal_forces(position.data(), increment.data(), dt, force.data());
    return force;
  }

  /// -df/du by central differences of 1e-7: of steps dt (s) so long that nothing viscous is in it. Stresses return to
  /// 1e-14 of themselves each time, so the state must not flow: unloaded a little.
  template <class Elements>
  Eigen::MatrixXd compute_tangent(Elements &elements, std::vector<double> &position, const double dt = 1e6)
  {
    const double       small = 1e-7;
    const Eigen::Index n     = position.size() / 3 * Elements::n_unknowns;
    Eigen::MatrixXd    K(n, n);
    for (Eigen::Index d = 0; d < n; ++d)
      {
        const Eigen::VectorXd u    = Eigen::VectorXd::Unit(n, d) * small;
        const Eigen::VectorXd plus = move(elements, position, u, dt);
        move(elements, position, -u, dt);
        const Eigen::VectorXd minus = move(elements, position, -u, dt);
        move(elements, position, u, dt);
        K.col(d) = (minus - plus) / (2. * small);
      }
    return K;
  }

  /// 2/omega_max with lumped masses (and inertias) of the unknowns; K need not be symmetric, stresses make it so.
  inline double compute_step(const Eigen::MatrixXd &K, const Eigen::VectorXd &mass)
  {
    const Eigen::VectorXd                     scale = mass.cwiseSqrt().cwiseInverse();
    const Eigen::EigenSolver<Eigen::MatrixXd> modes(scale.asDiagonal() * K * scale.asDiagonal(), false);
    return 2. / std::sqrt(modes.eigenvalues().real().maxCoeff());
  }

  /// How much the velocities of a motion of all modes grow at most within 400 central-difference steps of dt (s), so
  /// small that nothing is non-linear.
  template <class Elements>
  double compute_growth(Elements &elements, std::vector<double> position, const Eigen::VectorXd &mass, const double dt)
  {
    Eigen::VectorXd velocity(mass.size()), force = Eigen::VectorXd::Zero(mass.size());
    for (Eigen::Index d = 0; d < velocity.size(); ++d)
      velocity[d] = 1e-9 * std::sin(1. + 3. * double(d));
    const double before = velocity.norm();
    double       growth = 1.;
    for (int step = 0; step < 400 && growth < 1e12; ++step)
      {
        velocity += dt * force.cwiseQuotient(mass);
        force  = move(elements, position, dt * velocity, dt);
        growth = std::max(growth, velocity.norm() / before);
      }
    return growth;
  }
} // namespace exact_step
