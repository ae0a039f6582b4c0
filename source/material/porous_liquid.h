#pragma once

#include "material/pressure_table.h"

namespace birdstrike
{
  /// Liquid with pores full of air, one pressure p (gauge) in both (Wilbeck 1978, "Impact behavior of low strength
  /// projectiles", AFML-TR-77-134):
  ///
  ///   rho0/rho = (1 - z) (1 + p/A)^(-1/B) + z (1 + p/p0)^(-1/gamma),   B = 4 k - 1,   A = rho_l c_l^2/B
  ///
  /// z is the share of the pores in the undeformed volume, rho_l, c_l and k density, sound speed and shock slope of the
  /// liquid, whose Murnaghan law A, B follows U_s = c_l + k u to second order in u; p0 is the ambient pressure and
  /// gamma = 1.4 that of air.
  struct PorousLiquid
  {
    static constexpr double gamma = 1.4;

    double porosity, liquid_modulus, liquid_exponent, ambient_pressure; ///< -, Pa (A), - (B), Pa

    /// mu and dp/dmu (Pa) at a pressure >= 0.
    PressureTable::Point at(double pressure) const;

    /// p(mu) to threefold compression, within 1e-6 of the law (tested): points are added until cubics agree with it to
    /// 1e-7 half way between them.
    PressureTable tabulate() const;
  };
} // namespace birdstrike
