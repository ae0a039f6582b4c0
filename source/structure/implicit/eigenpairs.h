#pragma once

#include <vector>

namespace birdstrike
{
  /// Of (K - s M) x = lambda M x, the lowest lambda: 1/s^2.
  struct Eigenpairs
  {
    std::vector<double>              values;
    std::vector<std::vector<double>> vectors;
    std::size_t                      n_iterations = 0;
  };
} // namespace birdstrike
