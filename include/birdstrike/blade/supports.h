#pragma once

#include <birdstrike/blade/parameters.h>
#include <birdstrike/blade/surface_mesh.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// Which unknowns are held at zero velocity: by boundary id (clamped, hub, named components), by coordinate boxes,
  /// and on a plane of symmetry.
  /// Throws InputError for a boundary id that the mesh does not have, a box without nodes, or an unknown component.
  struct Supports
  {
    Supports(const BladeParameters::Supports &parameters, const SurfaceMesh &mesh);

    std::vector<std::uint32_t> held_dofs; ///< sorted, 6 node + component
    std::vector<unsigned int>  root_ids;  ///< hub if given, else clamped
    std::vector<unsigned int>  tip_ids;   ///< those of the tip list that the mesh has
  };
} // namespace birdstrike
