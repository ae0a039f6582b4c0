#pragma once

#include <birdstrike/core/number.h>

namespace birdstrike
{
  /// Strengths of a ply (Pa, positive). Zero throughout: it never fails.
  struct PlyStrength
  {
    double longitudinal_tension = 0., longitudinal_compression = 0.; ///< X_t, X_c
    double transverse_tension = 0., transverse_compression = 0.;     ///< Y_t, Y_c
    double shear        = 0.;                                        ///< S_c, in the plane
    double shear_weight = 0.; ///< beta of the shear in fibre tension: 0 none, 1 Hashin's, -

    bool operator==(const PlyStrength &) const = default;

    bool can_fail() const
    {
      return longitudinal_tension > 0.;
    }
  };

  /// A unidirectional ply, orthotropic and elastic until it fails: 1 along the fibres, 2 across them in its plane, 3
  /// its normal.
  struct Ply
  {
    double      density = 0.;                                ///< kg/m^3
    double      young_1 = 0., young_2 = 0.;                  ///< Pa
    double      poisson_12 = 0.;                             ///< -e_22/e_11 of a stress along 1
    double      shear_12 = 0., shear_13 = 0., shear_23 = 0.; ///< Pa
    PlyStrength strength;

    bool operator==(const Ply &) const = default;
  };

  /// How far each mode of failure has taken a ply: 0 not begun, 1 nothing left of what it carries.
  template <class Number>
  struct PlyDamage
  {
    static constexpr int n_modes = 4;

    Number mode[n_modes]; ///< fibre tension, fibre compression, matrix tension, matrix compression

    Number fibre() const
    {
      return max(mode[0], mode[1]);
    }
    Number matrix() const ///< a ply whose fibres are torn carries nothing; crushed ones leave the matrix
    {
      return max(mode[0], max(mode[2], mode[3]));
    }
  };

  /// Plane stress of a ply in its own axes: s_11 = q11 e_11 + q12 e_22, s_22 = q12 e_11 + q22 e_22, s_12 = q66 2e_12.
  template <class Number>
  struct PlyStiffness
  {
    Number q11, q12, q22, q66; ///< Pa

    /// With what is left, from 0 to 1, of the fibres' and of the matrix' moduli: E_1 and E_2, G_12, their compliances
    /// S_12 kept (Matzenmiller, Lubliner & Taylor 1995), so that the stiffness falls in every direction as they do; at
    /// nothing these are the constants of Chang & Chang (1987), E_2 = G_12 = nu = 0 or E_1 = nu = 0.
    PlyStiffness(const Ply &ply, const Number &fibre, const Number &matrix)
    {
      const double nu_21 = ply.poisson_12 * ply.young_2 / ply.young_1;
      const Number d     = Number(1.) / (Number(1.) - (ply.poisson_12 * nu_21) * fibre * matrix);
      q11                = ply.young_1 * fibre * d;
      q22                = ply.young_2 * matrix * d;
      q12                = ply.poisson_12 * fibre * q22;
      q66                = ply.shear_12 * matrix;
    }

    template <class Strain>
    void compute_stress(const Strain (&strain)[3], Strain (&stress)[3]) const
    {
      stress[0] = q11 * strain[0] + q12 * strain[1];
      stress[1] = q12 * strain[0] + q22 * strain[1];
      stress[2] = q66 * strain[2];
    }
  };

  /// What compute_failure_indices() takes of strengths; all zero of a ply that never fails: its indices are zero.
  struct PlyCriteria
  {
    double tension = 0., compression = 0., opening = 0., shear = 0.; ///< 1/Pa, of X_t, X_c, Y_t and S_c
    double closing = 0., linear = 0.;                                ///< 1/Pa, of s_22 < 0: squared, and by itself
    double shear_weight = 0.;                                        ///< -

    explicit PlyCriteria(const PlyStrength &s)
    {
      if (!s.can_fail())
        return;
      tension            = 1. / s.longitudinal_tension;
      compression        = 1. / s.longitudinal_compression;
      opening            = 1. / s.transverse_tension;
      shear              = 1. / s.shear;
      closing            = 0.5 / s.shear;
      const double ratio = 0.5 * s.transverse_compression / s.shear;
      linear             = (ratio * ratio - 1.) / s.transverse_compression;
      shear_weight       = s.shear_weight;
    }
  };

  /// Chang & Chang (1987) without their non-linear shear, as LS-DYNA's *MAT_054: a mode begins where its index reaches
  /// 1, from a plane stress (s_11, s_22, s_12) in the ply's axes:
  ///   fibre tension       s_11 > 0:   (s_11/X_t)^2 + beta (s_12/S_c)^2
  ///   fibre compression   s_11 < 0:   (s_11/X_c)^2
  ///   matrix tension      s_22 >= 0:  (s_22/Y_t)^2 + (s_12/S_c)^2
  ///   matrix compression  s_22 < 0:   (s_22/(2 S_c))^2 + ((Y_c/(2 S_c))^2 - 1) s_22/Y_c + (s_12/S_c)^2
  template <class Number>
  inline void compute_failure_indices(const PlyCriteria &of, const Number (&s)[3],
                                      Number (&index)[PlyDamage<Number>::n_modes])
  {
    const Number zero = 0., tension = of.tension * s[0], compression = of.compression * s[0],
                 opening = of.opening * s[1], shear = of.shear * s[2], closing = of.closing * s[1];
    const auto is_along = s[0] > zero, is_open = s[1] >= zero;
    index[0] = select(is_along, Number(tension * tension + of.shear_weight * shear * shear), zero);
    index[1] = select(is_along, zero, Number(compression * compression));
    index[2] = select(is_open, Number(opening * opening + shear * shear), zero);
    index[3] = select(is_open, zero, Number(closing * closing + of.linear * s[1] + shear * shear));
  }
} // namespace birdstrike
