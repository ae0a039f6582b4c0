#pragma once

#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/function_ref.h>
#include <birdstrike/structure/blade.h>

namespace birdstrike
{
  /// Of the place of a surface that undeformed lies nearest to `place` (m), of nodes that were at `rest` and have gone
  /// by `displacement` (m). Between two faces of a solid, as its mid-surface lies, it moves as the line between them.
  SurfaceMotion compute_surface_motion(const FacetsView &facets, const Point3 &place,
                                       FunctionRef<Point3(std::uint32_t)> rest,
                                       FunctionRef<Point3(std::uint32_t)> displacement);
} // namespace birdstrike
