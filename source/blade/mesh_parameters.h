#pragma once

#include <birdstrike/blade/parameters.h>

namespace birdstrike
{
  /// Subsections "Mesh" (with "Profile") and "Thickness" of section "Blade".
  void declare_mesh(dealii::ParameterHandler &prm, BladeParameters::Mesh &parameters);
  void declare_thickness(dealii::ParameterHandler &prm, BladeParameters::Thickness &parameters);

  /// Rules between their entries, for a blade of finite elements. Throws InputError.
  void check_mesh(const BladeParameters &parameters);
} // namespace birdstrike
