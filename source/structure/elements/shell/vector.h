#pragma once

namespace birdstrike
{
  /// Strain increments of a section, or the resultants that work on them: power per area is
  ///   N.membrane + M.curvature + Q.shear.
  template <class Number>
  struct SectionVector
  {
    Number membrane[3];  ///< xx, yy, 2xy (strain, -); N_xx, N_yy, N_xy (N/m)
    Number curvature[3]; ///< 1/m; M, N
    Number shear[2];     ///< x, y; Q, N/m
  };

  /// The same of a one-point element with its linear parts, as physical components along a1 and a2; a third of their
  /// products adds to the power (the mean of xi^2 and of eta^2).
  template <class Number>
  struct ShellVector : SectionVector<Number>
  {
    Number linear_membrane[2]; ///< e_11 ~ eta, e_22 ~ xi
    Number linear_curvature[2];
    Number linear_shear[2]; ///< g_1 ~ eta, g_2 ~ xi
  };
} // namespace birdstrike
