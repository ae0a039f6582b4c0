#pragma once

#include <birdstrike/core/fields.h>

#include <array>

namespace birdstrike
{
  /// Adds to the fields of cells "stress" + suffix, a symmetric tensor, and its largest and smallest principal value,
  /// tension positive ("max_principal_stress", "min_principal_stress"). `stresses` of each cell: xx, yy, zz, xy, yz, zx
  /// (Pa).
  void add_stress_fields(const std::string &suffix, const std::vector<std::array<double, 6>> &stresses,
                         std::vector<Field> &fields);
} // namespace birdstrike
