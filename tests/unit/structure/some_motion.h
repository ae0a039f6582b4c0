#pragma once

#include <birdstrike/core/number.h>

/// Increments that repeat nothing, the same in every run: of no symmetry, another for every seed.
Eigen::VectorXd some_motion(std::size_t n_dofs, double size, unsigned int seed);
