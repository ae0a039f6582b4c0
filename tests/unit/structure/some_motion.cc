#include "some_motion.h"

#include <cmath>

Eigen::VectorXd some_motion(const std::size_t n_dofs, const double size, const unsigned int seed)
{
  Eigen::VectorXd u(n_dofs);
  for (Eigen::Index d = 0; d < u.size(); ++d)
    u[d] = size * std::sin(1. + 1.7 * d * (1 + seed) + seed);
  return u;
}
