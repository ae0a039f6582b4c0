#pragma once

#include <birdstrike/material/radial_return.h>

namespace birdstrike
{
  /// State of one point of a brick.
  template <class Number>
  struct SolidPoint
  {
    Number stress[6];      ///< Kirchhoff's, J sigma: xx, yy, zz, xy, yz, zx, Pa, global axes
    Number plastic_strain; ///< equivalent, -
    Number yield;          ///< Pa, static flow stress there
    Number plastic_work;   ///< J/m^3, what heats

    [[gnu::always_inline]] void rotate_and_strain(const Elasticity &elasticity, const Matrix3<Number> &gradient)
    {
      const Vector3<Number> spin = compute_half_spin(gradient);
      Number                strain[6];
      compute_turned_strain(gradient, spin, strain);
      rotate_hughes_winget(spin, stress);
      add_elastic_stress(elasticity, strain, stress);
    }
  };
} // namespace birdstrike
