#pragma once

#include "shell_harness.h"

/// Shell elements in motion, without the blade around them.
namespace shell_harness
{
  inline const double pi = std::acos(-1.);

  /// Central differences with the lumped masses of the elements; `load` may depend on the state.
  struct Motion
  {
    Model           model;
    Eigen::VectorXd mass, velocity, force;
    double          dt;

    Motion(const Mesh &mesh, double thickness, const ShellSection &section);

    /// One step of velocity-Verlet; rate is the mass-proportional damping (1/s).
    void   step(const Eigen::VectorXd &load, double rate, const std::vector<bool> &held);
    double kinetic_energy() const; ///< 1/2 m v^{n-1/2}.v^{n+1/2}
  };
} // namespace shell_harness
