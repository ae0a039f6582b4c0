#pragma once

namespace birdstrike
{
  struct CaseParameters;

  /// Refuses, with an InputError that names the entry, what is not its own mirror image at the plane y = 0: bird,
  /// blade, supports, loads, and what is watched where only y >= 0 is computed. Formulas are compared at mirrored
  /// places: nodes, centroids and points of integration of the mesh. A mesh from a file is the blade's own business.
  void require_symmetry(const CaseParameters &parameters);
} // namespace birdstrike
