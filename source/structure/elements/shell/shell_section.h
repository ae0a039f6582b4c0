#pragma once

#include <birdstrike/material/metal.h>
#include <birdstrike/structure/choices.h>

namespace birdstrike
{
  /// What elements of one section share.
  struct ShellSection
  {
    ShellFormulation formulation = ShellFormulation::one_point_physical;
    ThicknessRule    rule        = ThicknessRule::gauss;
    unsigned int     n_points    = 5; ///< through the thickness: odd, 3 to 15
    Metal            material;
    double           hourglass_coefficient = 0.05;    ///< Belytschko-Tsay: membrane, w and theta alike
    double           shear_factor          = 5. / 6.; ///< Reissner's kappa
    bool             has_thinning          = true;    ///< the thickness follows the plane-stress strain
  };
} // namespace birdstrike
