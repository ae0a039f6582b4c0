#pragma once

#include <array>
#include <optional>
#include <string>

namespace birdstrike
{
  /// A unit of measurement: one of it is factor * 10^exponent of its SI unit, kg^a m^b s^c K^d rad^e, plus `offset`.
  /// The power of ten is apart so that 4.27 mm is the very number 0.00427. The angle counts as a dimension: a spin is
  /// no frequency.
  struct Unit
  {
    double             factor   = 1.;
    int                exponent = 0;
    std::array<int, 5> dimension{}; ///< of kg, m, s, K, rad
    double             offset = 0.; ///< K, of degC

    /// A value in SI units.
    double to_si(double value) const;
  };

  /// "kg/m^3", "J/(kg K)", "N mm", "65 knots" without the number: names joined by blanks, '*' and '/', which takes the
  /// next factor alone, whole powers by '^', and 1 for nothing. Nothing for a text that is none.
  ///
  /// Values: BIPM, The International System of Units, 9th edition (2019), table 8; NIST Special Publication 811 (2008),
  /// appendix B.8 (inch, foot, pound, pound-force, psi, knot, mile per hour, revolution per minute).
  std::optional<Unit> parse_unit(const std::string &text);

  /// Names of common units of the same dimension as this one, for a message: "m, mm, cm, um, km, in, ft".
  std::string list_units_like(const Unit &unit);
} // namespace birdstrike
