#pragma once

#include <birdstrike/core/number.h>

#include <cmath>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  /// A disc on the struck surface over which the contact pressure is averaged.
  struct PressurePatch
  {
    std::string name;
    Point3      centre;                  ///< m; goes with the surface (moving_patches.h)
    double      radius;                  ///< m
    double      area;                    ///< m^2: the disc's, as far as the surface covers it (moving_patches.h)
    Point3      normal = Point3::Zero(); ///< unit, of the surface there; zero: nothing holds it

    /// Whether a place of the surface is counted: in a cylinder as high either way as its radius, so that a centre in
    /// the middle of a body means the same disc as one on its face. Of a patch that nothing holds, in a ball.
    bool holds(const Point3 &place) const
    {
      const Point3 way    = place - centre;
      const double height = way.dot(normal);
      return std::abs(height) <= radius && way.squaredNorm() - height * height <= radius * radius;
    }
  };

  /// How points and facets push one another. Section `Contact`. Raises InputError from check() and pressure_patches().
  struct ContactParameters
  {
    bool        is_enabled          = true;
    bool        self_contact        = true;
    double      stiffness_scale     = 1.;  ///< -, on rho0 c0^2 V^(1/3)
    double      damping_scale       = 1.;  ///< -, on A rho c
    double      stability_share     = 0.4; ///< -, N dt^2 of a full layer on a light blade (contact.h)
    double      friction            = 0.;  ///< -, Coulomb
    double      search_margin       = 1.;  ///< -, in initial particle spacings
    double      largest_penetration = 1.;  ///< -, in initial particle spacings: a particle deeper ends the run
    std::string patches;                   ///< "name: x y z radius; name: ..."

    void declare(dealii::ParameterHandler &prm);
    void check() const;

    std::vector<PressurePatch> pressure_patches() const;
  };
} // namespace birdstrike
