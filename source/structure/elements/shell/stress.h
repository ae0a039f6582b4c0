#pragma once

#include "structure/elements/shell/kernel.h"

namespace birdstrike
{
  /// Stress state (Kirchhoff's) of a section, in the corotational frame of its element (or of a batch of elements).
  template <class Number>
  struct SectionStress
  {
    Number thickness; ///< m
    Number mean[3];   ///< Pa, through the thickness: N = t mean
    Number outer[3];  ///< Pa, linear part at z = +t/2: M = t^2/6 outer
    Number shear[2];  ///< Pa, mean transverse shear stress: Q = t shear
  };

  /// Of a one-point element: its section and its stabilisation.
  template <class Number>
  struct ShellStress : SectionStress<Number>
  {
    Number linear_membrane[2];  ///< Pa, stabilisation, see ShellVector
    Number linear_curvature[2]; ///< Pa, at z = +t/2
    Number linear_shear[2];     ///< Pa
  };

  /// State of one point through the thickness, kept once an outer fibre has met the yield stress.
  template <class Number>
  struct ShellPoint
  {
    Number stress[3];      ///< Pa
    Number plastic_strain; ///< equivalent, -
    Number yield;          ///< Pa, static flow stress there
    Number plastic_work;   ///< J/m^3
  };

  /// Work per area (J/m^2) of one step.
  template <class Number>
  struct ShellWork
  {
    Number plastic, hourglass;
  };

  /// Resultants of a section (N/m, N). `contraction` as of SectionLaw.
  template <class Number>
  inline SectionVector<Number> compute_resultants(const SectionStress<Number> &s, const Number &contraction)
  {
    SectionVector<Number> r;
    const Number          t = s.thickness * contraction, t2 = t * s.thickness / Number(6.);
    for (int c = 0; c < 3; ++c)
      {
        r.membrane[c]  = t * s.mean[c];
        r.curvature[c] = t2 * s.outer[c];
      }
    for (int c = 0; c < 2; ++c)
      r.shear[c] = t * s.shear[c];
    return r;
  }

  /// The same and those of the stabilisation.
  template <class Number>
  inline ShellVector<Number> compute_resultants(const ShellStress<Number> &s, const Number &contraction)
  {
    const SectionStress<Number> &section = s;
    const Number                 t = s.thickness * contraction, t2 = t * s.thickness / Number(6.);
    ShellVector<Number>          r{compute_resultants(section, contraction), {}, {}, {}};
    for (int c = 0; c < 2; ++c)
      {
        r.linear_membrane[c]  = t * s.linear_membrane[c];
        r.linear_curvature[c] = t2 * s.linear_curvature[c];
        r.linear_shear[c]     = t * s.linear_shear[c];
      }
    return r;
  }
} // namespace birdstrike
