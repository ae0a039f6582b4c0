#pragma once

#include <vector>

namespace birdstrike
{
  /// Of (K - s M) x = lambda M x, the lowest lambda: 1/s^2. Where they are to be positive and one was found that is
  /// not: a bound of the lowest alone, from above.
  struct Eigenpairs
  {
    std::vector<double>              values;
    std::vector<std::vector<double>> vectors;
    std::size_t                      n_iterations = 0;

    bool is_positive() const
    {
      return !vectors.empty();
    }
  };
} // namespace birdstrike
