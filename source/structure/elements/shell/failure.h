#pragma once

#include "structure/elements/erosion.h"
#include "structure/elements/shell/section.h"

/// What failure takes from shells, once `FailingPoints` has found points that have failed.
///
/// Nodal work is trapezoidal, (old + new force)/2 times displacement, and the new force of what fails is zero: of its
/// energy density u at the end of the step all has been paid for but s de/2, half the work of the present stress on the
/// strain of the step; u - s de/2 is what the ledger gets as eroded. u is s.C^-1.s/2 of plane stress, and s^2/(2 M) of
/// transverse shear (M = kappa G) and stabilisation (E, kappa G), of which a third counts, a ninth in bending.
namespace birdstrike
{
  namespace internal
  {
    /// Takes a scalar stress where `fails`; returns its energy u (J/m^3, times share), and `unpaid` gets u's part that
    /// no force has worked for.
    template <class Number, class Mask>
    Number take_stress(const Mask &fails, const double share_over_modulus, const Number &half_share_strain,
                       Number &stress, Number &unpaid)
    {
      const Number zero   = 0.;
      const Number energy = select(fails, Number((0.5 * share_over_modulus) * stress * stress), zero);
      unpaid += select(fails, Number(stress * half_share_strain), zero);
      stress = select(fails, zero, stress);
      return energy;
    }

    /// The same of a plane stress (sxx, syy, sxy) with the strain (exx, eyy, 2 exy) of the step; the energy without
    /// what is unpaid.
    template <class Number, class Mask>
    Number take_plane_stress(const Elasticity &elasticity, const Mask &fails, const Number (&strain)[3],
                             Number (&stress)[3])
    {
      const Number zero = 0., half = 0.5;
      const Number work   = half * (stress[0] * strain[0] + stress[1] * strain[1] + stress[2] * strain[2]);
      const Number energy = select(fails, Number(plane_stress_energy(elasticity, stress) - work), zero);
      for (Number &s : stress)
        s = select(fails, zero, s);
      return energy;
    }
  } // namespace internal

  /// Takes the stress from points with D >= 1, and all stress of a section where `fails`; returns the eroded energy per
  /// area (J/m^2). `points` and `damage` are null while the section is elastic: then the stress in closed form goes,
  /// whose linear part has a third of the energy at the faces.
  template <class Number, class Mask>
  Number release_section(const SectionLaw &law, const Mask &fails, const SectionVector<Number> &e,
                         SectionStress<Number> &s, ShellPoint<Number> *points, Number *damage)
  {
    const Number t = s.thickness, one = 1.;
    Number       eroded = 0., unpaid = 0.; // J/m^3, means over the thickness
    const auto   strain_at = [&](const Number &arm, Number(&strain)[3]) {
      for (int c = 0; c < 3; ++c)
        strain[c] = e.membrane[c] + arm * e.curvature[c];
    };
    Number strain[3];
    if (points == nullptr)
      {
        const Number bend[3] = {0.5 * t * e.curvature[0], 0.5 * t * e.curvature[1], 0.5 * t * e.curvature[2]};
        eroded += internal::take_plane_stress(law.elasticity, fails, e.membrane, s.mean);
        eroded += (1. / 3.) * internal::take_plane_stress(law.elasticity, fails, bend, s.outer);
      }
    else
      {
        for (int c = 0; c < 3; ++c)
          s.mean[c] = s.outer[c] = Number(0.);
        for (unsigned int k = 0; k < law.rule.n; ++k)
          {
            strain_at(Number((0.5 * law.rule.position[k]) * t), strain);
            damage[k] = select(fails, max(damage[k], one), damage[k]);
            eroded += (0.5 * law.rule.weight[k]) *
                      internal::take_plane_stress(law.elasticity, damage[k] >= one, strain, points[k].stress);
            law.add_stress(k, points[k], s);
          }
      }
    for (int c = 0; c < 2; ++c)
      eroded += internal::take_stress(fails, 1. / law.shear_modulus, Number(0.5 * e.shear[c]), s.shear[c], unpaid);
    return t * (eroded - unpaid);
  }

  /// Takes the stabilisation where `fails`; returns its energy per area (J/m^2), which leaves the hourglass energy, and
  /// adds to `eroded` what of it was paid for. What the cap has taken of it before stays hourglass energy.
  template <class Number, class Mask>
  Number release_stabilisation(const ShellSectionLaw &law, const Mask &fails, const ShellVector<Number> &e,
                               ShellStress<Number> &s, Number &eroded)
  {
    const double young = law.elasticity.young, shear = law.shear_modulus;
    Number       energy = 0., unpaid = 0.;
    for (int c = 0; c < 2; ++c)
      {
        energy += internal::take_stress(fails, 1. / (3. * young), Number((1. / 6.) * e.linear_membrane[c]),
                                        s.linear_membrane[c], unpaid);
        energy += internal::take_stress(fails, 1. / (3. * shear), Number((1. / 6.) * e.linear_shear[c]),
                                        s.linear_shear[c], unpaid);
        energy +=
          internal::take_stress(fails, 1. / (9. * young), Number((1. / 36.) * s.thickness * e.linear_curvature[c]),
                                s.linear_curvature[c], unpaid);
      }
    eroded += s.thickness * (energy - unpaid);
    return s.thickness * energy;
  }
} // namespace birdstrike
