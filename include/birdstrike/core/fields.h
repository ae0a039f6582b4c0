#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace birdstrike
{
  /// One quantity on the nodes or on the cells of a snapshot: 1 component per entity, 3 of a vector, 6 (xx yy zz xy yz
  /// zx) of a symmetric tensor.
  struct Field
  {
    std::string         name; ///< e.g. "equivalent_plastic_strain_layer_1"
    std::string         unit; ///< "m", "Pa", "-"
    bool                on_cells     = false;
    unsigned int        n_components = 1;
    std::vector<double> values;            ///< [n_entities][n_components]
    bool                is_number = false; ///< whole numbers: ids, counts
  };

  /// What a part shows at one instant: geometry and fields, in plain arrays, so that one writer serves every part.
  struct FieldSnapshot
  {
    unsigned int        dim = 0; ///< 0 points, 2 quadrilaterals, 3 hexahedra
    std::vector<double> points;  ///< [n_points][3], m, reference position of a blade (fields hold its displacement),
                                 ///< current position of particles
    std::vector<std::uint32_t> cells; ///< [n_cells][2^dim], deal.II's (lexicographic) vertex order; points: identity
    std::vector<Field>         fields;
    bool                       is_deformed = false; ///< points have been moved by the field displacement
  };
} // namespace birdstrike
