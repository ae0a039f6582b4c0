#pragma once

#include "solid_harness.h"

namespace solid_harness
{
  /// Displacements under nodal loads (N) by conjugate gradients on the elements' own forces, without a matrix: for
  /// meshes whose factors would be large. Every product is a further increment so small (1e-14 of the size) that the
  /// state stays the stress-free one; the increments are given beside the positions, nothing is lost to cancellation.
  Eigen::VectorXd solve_by_gradients(const Mesh &mesh, const SolidSection &section, const Eigen::VectorXd &load,
                                     const std::vector<bool> &held);
} // namespace solid_harness
