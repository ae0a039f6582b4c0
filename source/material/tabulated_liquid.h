#pragma once

#include "material/pressure_table.h"

#include <string>

namespace birdstrike
{
  /// "mu: pressure; ..." -> table. Throws InputError unless there are 2 to 1000 points, the first 0: 0, mu and pressure
  /// grow, and so does p/eta = rho0 U_s^2, eta = mu/(1 + mu), to a thousandth: where it falls, a stronger shock would
  /// be slower than the weaker one before it, and no single front carries it.
  PressureTable read_pressure_table(const std::string &text);
} // namespace birdstrike
