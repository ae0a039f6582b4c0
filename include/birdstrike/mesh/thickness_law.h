#pragma once

#include <birdstrike/mesh/named_ids.h>
#include <birdstrike/mesh/parameters.h>

#include <functional>

namespace birdstrike
{
  /// Thickness (m) at a position (m) on the mid-surface, of a cell with a material id.
  using ThicknessLaw = std::function<double(const double *position, unsigned int material_id)>;

  /// The law of section "Thickness", the same for shell and solid: a value by material where there is one, else the
  /// profile along the chord of a built-in part (`Maximum`), else the formula `Value`. `materials`: names of a mesh.
  /// Throws InputError for text that cannot be read.
  ThicknessLaw make_thickness_law(const GeometryParameters &parameters,
                                  const NamedIds           &materials = NamedIds(NamedIds::Of::materials));

  /// Evaluates a law. Throws InputError, naming its entry and the place, if the thickness is not positive.
  double thickness_at(const ThicknessLaw &law, const double *position, unsigned int material_id,
                      const std::string &entry = "Thickness");
} // namespace birdstrike
