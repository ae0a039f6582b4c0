#pragma once

#include <birdstrike/mesh/cell_mesh.h>
#include <birdstrike/structure/parameters.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// Which unknowns are held at zero velocity: by boundary id (clamped, hub, named components), by coordinate boxes,
  /// and on a plane of symmetry. A node of a shell has six unknowns, one of a solid three: "clamped" holds all of them.
  /// Throws InputError for a boundary id that the mesh does not have, a box without nodes, an unknown component, or
  /// single rotations of a solid.
  struct Supports
  {
    Supports(const BladeParameters::Supports &parameters, const SurfaceMesh &mesh);
    Supports(const BladeParameters::Supports &parameters, const VolumeMesh &mesh);

    std::vector<std::uint32_t> held_dofs; ///< sorted, n_unknowns node + component
    std::vector<unsigned int>  root_ids;  ///< hub if given, else clamped
    std::vector<unsigned int>  tip_ids;   ///< those of the tip list that the mesh has

  private:
    template <class Mesh>
    void find_roles(const BladeParameters::Supports &parameters, const Mesh &mesh);
    template <unsigned int n_unknowns, class Mesh>
    void find_held(const BladeParameters::Supports &parameters, const Mesh &mesh);
  };
} // namespace birdstrike
