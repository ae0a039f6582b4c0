#include "solid_statics.h"

#include <stdexcept>

namespace solid_harness
{
  Eigen::VectorXd solve_by_gradients(const Mesh &mesh, const SolidSection &section, const Eigen::VectorXd &load,
                                     const std::vector<bool> &held)
  {
    Model           model(mesh, section);
    const double    size = 1e-14 * (mesh.nodes.back() - mesh.nodes.front()).norm();
    Eigen::VectorXd last = Eigen::VectorXd::Zero(model.n_dofs());
    const auto      free = [&held](Eigen::VectorXd v) {
      for (Eigen::Index d = 0; d < v.size(); ++d)
        v[d] = held[d] ? 0. : v[d];
      return v;
    };
    const auto apply = [&](const Eigen::VectorXd &p) {
      const double          scale = size / p.cwiseAbs().maxCoeff();
      const Eigen::VectorXd force = model.move(scale * p), result = free((last - force) / scale);
      last = force;
      return result;
    };
    Eigen::VectorXd u = Eigen::VectorXd::Zero(model.n_dofs()), r = free(load), p = r;
    double          square = r.squaredNorm();
    const double    enough = 1e-20 * square;
    for (std::size_t i = 0; square > enough; ++i)
      {
        if (i > 3 * model.n_dofs())
          throw std::runtime_error("conjugate gradients do not converge");
        const Eigen::VectorXd Kp   = apply(p);
        const double          step = square / p.dot(Kp);
        u += step * p;
        r -= step * Kp;
        const double now = r.squaredNorm();
        p                = r + now / square * p;
        square           = now;
      }
    return u;
  }
} // namespace solid_harness
