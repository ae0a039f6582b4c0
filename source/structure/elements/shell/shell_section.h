#pragma once

#include "structure/elements/shell/laminate/laminate.h"
#include <birdstrike/material/metal.h>
#include <birdstrike/structure/choices.h>

#include <memory>

namespace birdstrike
{
  /// What elements of one section share.
  struct ShellSection
  {
    ShellFormulation                formulation = ShellFormulation::one_point_physical;
    ThicknessRule                   rule        = ThicknessRule::gauss;
    unsigned int                    n_points    = 5; ///< through the thickness: odd, 3 to 15
    Metal                           material;
    std::shared_ptr<const Laminate> laminate;                        ///< instead of the metal; null: none
    double                          hourglass_coefficient = 0.05;    ///< Belytschko-Tsay: membrane, w and theta alike
    double                          shear_factor          = 5. / 6.; ///< Reissner's kappa, of metals
    bool                            has_thinning = true; ///< the thickness follows the plane-stress strain, of metals

    bool can_fail() const
    {
      return laminate ? laminate->can_fail() : material.failure.can_fail();
    }
    double density() const ///< kg/m^3
    {
      return laminate ? laminate->density : material.density;
    }
    double failed_share() const ///< as of Failure, with smallest_step()
    {
      return laminate ? laminate->failed_share : material.failure.failed_share;
    }
    double smallest_step() const
    {
      return laminate ? laminate->smallest_step : material.failure.smallest_step;
    }
  };
} // namespace birdstrike
