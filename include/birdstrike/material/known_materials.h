#pragma once

#include <string>

namespace birdstrike
{
  /// The metals that Material/Name knows, a line each with its constants and one with their source.
  std::string list_metals();

  /// The laws of Equation of state/Type at their default constants, of a liquid of this density (kg/m^3): law,
  /// constants, speed of sound, and the Hugoniot pressure of a strike at 200 m/s.
  std::string list_liquids(double density);
} // namespace birdstrike
