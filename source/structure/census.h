#pragma once

#include <birdstrike/mesh/cell_mesh.h>
#include <birdstrike/structure/reports.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// Counts, area and edge lengths of what is owned of a surface; mass, held unknowns and bytes are left to its owner.
  BladeCensus compute_census(const SurfaceMesh &mesh);
  /// The same of a solid: the area is that of its skin.
  BladeCensus compute_census(const VolumeMesh &mesh);

  /// Of sorted unknowns, `n_unknowns` a node, and those of them that are driven.
  std::vector<SupportCensus> compute_support_census(const std::vector<std::array<double, 3>> &nodes,
                                                    unsigned int                              n_unknowns,
                                                    const std::vector<std::uint32_t>         &held_dofs,
                                                    const std::vector<std::uint32_t>         &driven_dofs);
} // namespace birdstrike
