#pragma once

#include <birdstrike/material/metal.h>
#include <birdstrike/structure/choices.h>

namespace birdstrike
{
  /// What bricks of one section share.
  struct SolidSection
  {
    SolidFormulation formulation = SolidFormulation::one_point;
    Metal            material;
    ThicknessRule    rule                = ThicknessRule::gauss; ///< of solid_shell, as n_points
    unsigned int     n_points            = 5;                    ///< through the thickness: odd, 3 to 15
    double           linear_viscosity    = 0.06;                 ///< b1 of rho l c b1, -
    double           quadratic_viscosity = 1.2;                  ///< b2, in compression only, -

    bool can_fail() const
    {
      return material.failure.can_fail();
    }
  };
} // namespace birdstrike
