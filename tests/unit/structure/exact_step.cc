#include "exact_step.h"

#include "structure/elements/shell/elements.h"
#include "structure/elements/solid/elements.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace exact_step
{
  namespace
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
  } // namespace

  template <class Elements>
  Eigen::MatrixXd compute_tangent(Elements &elements, std::vector<double> &position, const double dt)
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

  double compute_step(const Eigen::MatrixXd &K, const Eigen::VectorXd &mass)
  {
    const Eigen::VectorXd                     scale = mass.cwiseSqrt().cwiseInverse();
    const Eigen::EigenSolver<Eigen::MatrixXd> modes(scale.asDiagonal() * K * scale.asDiagonal(), false);
    return 2. / std::sqrt(modes.eigenvalues().real().maxCoeff());
  }

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

  template Eigen::MatrixXd compute_tangent(birdstrike::ShellElements &, std::vector<double> &, double);
  template double compute_growth(birdstrike::ShellElements &, std::vector<double>, const Eigen::VectorXd &, double);
  template Eigen::MatrixXd compute_tangent(birdstrike::SolidElements &, std::vector<double> &, double);
  template double compute_growth(birdstrike::SolidElements &, std::vector<double>, const Eigen::VectorXd &, double);
} // namespace exact_step
