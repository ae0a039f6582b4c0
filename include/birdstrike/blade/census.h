#pragma once

#include <birdstrike/blade/reports.h>
#include <birdstrike/blade/surface_mesh.h>

namespace birdstrike
{
  /// Counts, area and edge lengths of a surface; mass, held unknowns and bytes are left to its owner.
  BladeCensus compute_census(const SurfaceMesh &mesh);
} // namespace birdstrike
