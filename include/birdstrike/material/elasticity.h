#pragma once

#include <cmath>

namespace birdstrike
{
  /// Isotropic linear elasticity from Young's modulus (Pa) and Poisson's ratio.
  struct Elasticity
  {
    double young   = 113.8e9; ///< E, Pa
    double poisson = 0.342;   ///< nu, -1 < nu < 1/2

    /// G = E / (2 (1 + nu))
    double shear_modulus() const
    {
      return young / (2. * (1. + poisson));
    }
    /// K = E / (3 (1 - 2 nu))
    double bulk_modulus() const
    {
      return young / (3. * (1. - 2. * poisson));
    }
    /// E / (1 - nu^2), the modulus of a wide plate
    double plate_modulus() const
    {
      return young / (1. - poisson * poisson);
    }
    /// c = sqrt(E / (rho (1 - nu^2))), the longitudinal wave speed of a plate (m/s)
    double plate_wave_speed(const double density) const
    {
      return std::sqrt(plate_modulus() / density);
    }
  };

  /// Plane stress: (sxx, syy, sxy) from (exx, eyy, 2 exy); s_zz = 0.
  template <class Number>
  inline void add_plane_stress(const Elasticity &elasticity, const Number (&strain)[3], Number (&stress)[3])
  {
    const double plate = elasticity.plate_modulus();
    stress[0] += plate * (strain[0] + elasticity.poisson * strain[1]);
    stress[1] += plate * (elasticity.poisson * strain[0] + strain[1]);
    stress[2] += elasticity.shear_modulus() * strain[2];
  }

  /// Elastic energy (J/m^3) of a plane stress state (sxx, syy, sxy).
  template <class Number>
  inline Number plane_stress_energy(const Elasticity &elasticity, const Number (&s)[3])
  {
    const double nu = elasticity.poisson;
    return (s[0] * s[0] + s[1] * s[1] - 2. * nu * s[0] * s[1] + 2. * (1. + nu) * s[2] * s[2]) / (2. * elasticity.young);
  }
} // namespace birdstrike
