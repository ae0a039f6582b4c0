#pragma once

#include <birdstrike/core/contact_views.h>

namespace birdstrike
{
  /// A surface that is computed by half may be folded where it meets its mirror image: a blade with a point, a keel or
  /// a groove. Contact of the whole knows such places: a ridge of a solid's skin from 30 degrees between the normals on
  /// is a sharp edge (edge_profile.h), and in a fold from 60 degrees on points touch both sheets. That of the half does
  /// not.
  /// @throws InputError with angle and place.
  void refuse_folds_on_plane(const FacetsView &facets);
} // namespace birdstrike
