#pragma once

#include <birdstrike/material/elasticity.h>
#include <birdstrike/material/failure.h>
#include <birdstrike/material/hardening.h>

#include <string>

namespace birdstrike
{
  /// A metal: isotropic elasticity, von Mises yield with isotropic hardening, failure, density. A value type without
  /// behaviour: the laws are pure functions of it (`plane_stress_return`, `radial_return`).
  struct Metal
  {
    std::string name    = "custom";
    double      density = 4430.; ///< kg/m^3
    Elasticity  elasticity;
    Hardening   hardening;
    Failure     failure;         ///< none in the table: constants only
    double      elongation = 0.; ///< engineering strain at break in a tensile test; 0: unknown. No law uses it
  };
} // namespace birdstrike
