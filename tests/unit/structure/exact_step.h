#pragma once

#include <birdstrike/core/number.h>

#include <vector>

/// The largest stable step of central differences about any state, from nothing but the elements' own forces; of shells
/// and bricks.
namespace exact_step
{
  /// -df/du by central differences of 1e-7: of steps dt (s) so long that nothing viscous is in it. Stresses return to
  /// 1e-14 of themselves each time, so the state must not flow: unloaded a little.
  template <class Elements>
  Eigen::MatrixXd compute_tangent(Elements &elements, std::vector<double> &position, double dt = 1e6);

  /// 2/omega_max with lumped masses (and inertias) of the unknowns; K need not be symmetric, stresses make it so.
  double compute_step(const Eigen::MatrixXd &K, const Eigen::VectorXd &mass);

  /// How much the velocities of a motion of all modes grow at most within 400 central-difference steps of dt (s), so
  /// small that nothing is non-linear.
  template <class Elements>
  double compute_growth(Elements &elements, std::vector<double> position, const Eigen::VectorXd &mass, double dt);
} // namespace exact_step
