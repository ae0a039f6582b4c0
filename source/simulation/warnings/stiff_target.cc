#include "simulation/warnings/stiff_target.h"
#include "simulation/projectile/projectile.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/structure/blade.h>
#include <birdstrike/structure/parameters.h>

#include <fmt/format.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// Shares below are stiff. Impulse too large with 10 particles across: 3.7 % on a rigid plate (share 0), 3.5 % on
    /// 16 mm of titanium (0.015), 3 % on 8 mm (0.06); within a percent on 4 mm (0.22).
    constexpr double stiff = 0.1;

    /// Impulse too large times particles across: 5.1, 3.7, 2.6 and 1.3 % with 8, 10, 14 and 20 on a rigid plate.
    constexpr double error_of_one = 0.38;
    constexpr double enough       = 20.; ///< particles across, from which on it is less than two percent

    double compute_plate_modulus(const BladeParameters &parameters)
    {
      if (!parameters.is_laminate())
        return parameters.material.metal().elasticity.plate_modulus();
      const Ply &ply = parameters.laminate.ply;
      return 0.375 * ply.young_1 + 0.625 * ply.young_2; // of plies in all directions (Tsai & Pagano 1968)
    }

    double find_thickness(const BladeParameters &parameters, const Blade &blade, const Point3 &place)
    {
      if (blade.kind() == BladeKind::solid)
        {
          const BladeCensus census = blade.census();
          return 2. * census.mass / (parameters.density() * census.area);
        }
      const FacetsView facets  = blade.facets();
      double           nearest = INFINITY, thickness = 0.;
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        {
          Point3 centre = Point3::Zero();
          for (const std::uint32_t n : facets.nodes[f])
            centre += 0.25 * Point3(facets.position + 3 * n);
          if (const double d = (centre - place).squaredNorm(); d < nearest)
            {
              nearest   = d;
              thickness = 2. * facets.half_thickness[f];
            }
        }
      return thickness;
    }
  } // namespace

  double compute_yielding(const BladeParameters &parameters, const Blade &blade, const Projectile &projectile)
  {
    const double mass = projectile.bird->packing().mass();
    if (!blade.is_deformable())
      return mass / (mass + blade.mass());
    const double t         = find_thickness(parameters, blade, Point3(projectile.aim.point.data()));
    const double D         = compute_plate_modulus(parameters) * t * t * t / 12.;
    const double impedance = 8. * std::sqrt(D * parameters.density() * t);
    return mass / projectile.aim.duration / impedance;
  }

  void check_stiff_target(const BladeParameters &parameters, const Blade &blade, const Projectile &projectile,
                          const double n_particles_across, Warnings &warnings)
  {
    if (n_particles_across >= enough || projectile.parameters.has_strength() || std::isnan(projectile.aim.duration))
      return;
    const double yielding = compute_yielding(parameters, blade, projectile);
    if (!(yielding < stiff))
      return;
    warnings.push_back(
      {"bird/stiff_target",
       fmt::format("The target hardly gives way: at {:.2g} of the normal speed of section '{}'. With {:.0f} particles "
                   "across the bird its impulse is about {:.1f} % too large: particles rebound from a stiff wall, a "
                   "liquid does not. Deflection and root moment are too large by as much, a small plastic work by a "
                   "half and more. Take 20 particles across or more ({}/Particle spacing = {:.2g} m), and check the "
                   "trend with 'birdstrike converge FILE.prm --vary particles'.",
                   yielding, projectile.parameters.section, n_particles_across,
                   100. * error_of_one / n_particles_across, projectile.parameters.section,
                   projectile.parameters.spacing * n_particles_across / enough)});
  }
} // namespace birdstrike
