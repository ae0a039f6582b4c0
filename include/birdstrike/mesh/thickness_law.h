#pragma once

#include <birdstrike/mesh/named_ids.h>
#include <birdstrike/mesh/parameters.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace birdstrike
{
  /// Where a thickness is asked for.
  struct SurfacePlace
  {
    const double         *position; ///< m, on the mid-surface
    unsigned int          material_id = 0;
    double                given       = 0.; ///< m, by a table or the file of the mesh; 0: neither
    std::array<double, 2> station{};        ///< (s, c) on a mesh from a file, see nodal_thickness.h
  };

  /// Thickness (m) at a place.
  using ThicknessLaw = std::function<double(const SurfacePlace &place)>;

  /// What a law asks for that is known at nodes; empty: it does not ask.
  struct NodalThickness
  {
    std::vector<double>                given;   ///< m
    std::vector<std::array<double, 2>> station; ///< (s, c)
  };

  /// The law of section "Thickness", the same for shell and solid: a value by material where there is one, else the
  /// profile along the chord (`Maximum`), else what the place has been given, else the formula `Value`. `materials`:
  /// names of a mesh. Throws InputError for text that cannot be read.
  ThicknessLaw make_thickness_law(const GeometryParameters &parameters,
                                  const NamedIds           &materials = NamedIds(NamedIds::Of::materials));

  /// Evaluates a law. Throws InputError, naming its entry and the place, if the thickness is not positive.
  double thickness_at(const ThicknessLaw &law, const SurfacePlace &place, const std::string &entry = "Thickness");
} // namespace birdstrike
