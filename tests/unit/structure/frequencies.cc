#include "frequencies.h"

#include "matrices.h"

#include "structure/deformable_blade.h"

#include <gtest/gtest.h>

#include <cmath>

namespace birdstrike::test
{
  std::vector<double> natural_frequencies(const BladeParameters &parameters)
  {
    ThreadPool               pool;
    ShellBlade               blade(parameters, pool);
    const auto               nodes = blade.nodes();
    std::vector<std::size_t> dofs; // uz, rx, ry; membrane and drilling do not couple to them in a flat plate
    for (std::size_t i = 0; i < 6 * nodes.n; ++i)
      if (nodes.inverse_mass[i] > 0. && i % 6 >= 2 && i % 6 <= 4)
        dofs.push_back(i);

    const double    step = 1e-7;
    Eigen::MatrixXd matrix(dofs.size(), dofs.size());
    const auto      move = [&](const std::size_t i, const double velocity) {
      nodes.velocity[i] = velocity;
      blade.drift(step);
      blade.compute_internal_forces();
      nodes.velocity[i] = 0.;
    };
    for (std::size_t c = 0; c < dofs.size(); ++c)
      {
        move(dofs[c], 1.);
        for (std::size_t r = 0; r < dofs.size(); ++r)
          matrix(r, c) = -nodes.force[dofs[r]] / step / std::sqrt(nodes.mass[dofs[r]] * nodes.mass[dofs[c]]);
        move(dofs[c], -1.);
      }
    EXPECT_LT((matrix - matrix.transpose()).norm(), 1e-6 * matrix.norm());
    const Eigen::VectorXd values = symmetric_eigenvalues(symmetric_part(matrix));
    std::vector<double>   frequencies;
    for (unsigned int k = 0; k < 8; ++k)
      frequencies.push_back(std::sqrt(values[k]) / (2. * M_PI));
    return frequencies;
  }
} // namespace birdstrike::test
