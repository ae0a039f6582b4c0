#pragma once

#include <birdstrike/mesh/blade_mesh.h>

#include <array>
#include <vector>

namespace birdstrike
{
  /// (s, c) per node, as nodal_thickness.h defines them. Throws InputError, see there.
  std::vector<std::array<double, 2>> find_stations(const ShellMesh &mesh, const std::vector<unsigned int> &root_ids,
                                                   const std::vector<unsigned int> &tip_ids);
} // namespace birdstrike
