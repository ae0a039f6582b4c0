#pragma once

#include <birdstrike/material/metal.h>

#include <vector>

namespace birdstrike
{
  struct MetalConstant
  {
    std::string key, unit; ///< "yield_stress", "Pa"
    double      value;
  };

  /// The constants that a metal's laws use, those that they do not use left out; and its elongation, if known, which
  /// only a warning uses. What is not listed plays no part.
  std::vector<MetalConstant> constants_in_use(const Metal &metal);

  /// "johnson-cook", as Material/Hardening names it.
  std::string hardening_name(const Metal &metal);

  /// One line: "Ti-6Al-4V: 4430 kg/m^3, E 113.8 GPa, nu 0.342, yield 880 MPa, no hardening, no rate dependence, does
  /// not fail".
  std::string describe(const Metal &metal);
} // namespace birdstrike
