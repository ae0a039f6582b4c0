#include "shell_motion.h"

namespace shell_harness
{
  Motion::Motion(const Mesh &mesh, const double thickness, const ShellSection &section)
    : model(mesh, thickness, section)
    , mass(model.n_dofs())
    , velocity(Eigen::VectorXd::Zero(model.n_dofs()))
    , force(Eigen::VectorXd::Zero(model.n_dofs()))
    , dt(0.9 * model.elements.step_limit().value)
  {
    const auto m = model.elements.compute_nodal_masses(), inertia = model.elements.compute_rotary_inertias();
    for (std::size_t d = 0; d < model.n_dofs(); ++d)
      mass[d] = d % 6 < 3 ? m[d / 6] : inertia[d / 6];
  }

  void Motion::step(const Eigen::VectorXd &load, const double rate, const std::vector<bool> &held)
  {
    const double          a      = 0.5 * rate * dt;
    const Eigen::VectorXd before = velocity;
    velocity                     = ((1. - a) * before + dt * (force + load).cwiseQuotient(mass)) / (1. + a);
    for (std::size_t d = 0; d < held.size(); ++d)
      if (held[d])
        velocity[d] = 0.;
    force = model.move(dt * velocity, dt);
  }

  double Motion::kinetic_energy() const
  {
    const Eigen::VectorXd next = velocity + dt * force.cwiseQuotient(mass);
    return 0.5 * velocity.dot(mass.cwiseProduct(next));
  }
} // namespace shell_harness
