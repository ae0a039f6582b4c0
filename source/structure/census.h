#pragma once

#include <birdstrike/mesh/cell_mesh.h>
#include <birdstrike/structure/reports.h>

namespace birdstrike
{
  /// Counts, area and edge lengths of what is owned of a surface; mass, held unknowns and bytes are left to its owner.
  BladeCensus compute_census(const SurfaceMesh &mesh);
  /// The same of a solid: the area is that of its skin.
  BladeCensus compute_census(const VolumeMesh &mesh);
} // namespace birdstrike
