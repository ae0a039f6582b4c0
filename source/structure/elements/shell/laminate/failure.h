#pragma once

#include "structure/elements/shell/laminate/law.h"

#include <cmath>

namespace birdstrike
{
  /// Whether a mode of some ply, none of which has failed, begins.
  template <class Number>
  bool begins_to_fail(const Laminate &law, const LaminateState<Number> &state)
  {
    Number largest = 0.;
    for (const Laminate::Layer &layer : law.layers)
      {
        Number e[3], s[3], index[PlyDamage<Number>::n_modes];
        compute_ply_strain(layer, layer.middle(), state.strain, e);
        const Laminate::Material &material = law.of(layer);
        material.intact.compute_stress(e, s);
        compute_failure_indices(material.criteria, s, index);
        largest = max(largest, max(max(index[0], index[1]), max(index[2], index[3])));
      }
    return any(largest >= Number(1.));
  }

  /// What happens to the plies of a section in one step.
  template <class Number>
  struct PlyStep
  {
    Number growth;  ///< of damage, summed: 0 where nothing has failed further
    Number carries; ///< mean over the thickness of the smaller of what is left of fibres and matrix
    Number broken;  ///< share of the thickness: fibres failed, or the matrix gone and the ply opened or sheared too far
  };

  /// Whether a ply that has the strains e in its own axes is a gap: its matrix is gone, and the strain across its
  /// fibres or the shear along them has passed the limit (LS-DYNA's *MAT_054: DFAILM, DFAILS). Without it such an
  /// element would be strained without end and without a force.
  template <class Number>
  [[gnu::always_inline]] inline auto is_gap(const Number &matrix, const Number (&e)[3], const double limit)
  {
    return matrix >= Number(1.) && max(Number(abs(e[1])), Number(abs(e[2]))) > Number(limit);
  }

  /// Stress of a section with failing plies at the present strain: a mode begins by the stress that its ply has left,
  /// decided in the middle of its layer, and goes on by `growth` a step until nothing is left.
  template <class Number>
  PlyStep<Number> update_failing_plies(const Laminate &law, const double growth, LaminateState<Number> &state,
                                       PlyDamage<Number> *damage)
  {
    const Number    zero = 0., one = 1.;
    PlyStep<Number> step{zero, zero, zero};
    const double    limit = law.matrix_failure_strain > 0. ? law.matrix_failure_strain : INFINITY;
    for (int i = 0; i < 6; ++i)
      state.stress[i] = zero;
    for (std::size_t k = 0; k < law.layers.size(); ++k)
      {
        const Laminate::Layer    &layer    = law.layers[k];
        const Laminate::Material &material = law.of(layer);
        PlyDamage<Number>        &d        = damage[k];
        const double              h = layer.middle(), share = layer.share(), second = share * share / 3.;
        Number                    e[3], s[3], index[PlyDamage<Number>::n_modes];
        compute_ply_strain(layer, h, state.strain, e);
        PlyStiffness<Number>(material.ply, one - d.fibre(), one - d.matrix()).compute_stress(e, s);
        compute_failure_indices(material.criteria, s, index);
        for (int m = 0; m < PlyDamage<Number>::n_modes; ++m)
          {
            const Number old = d.mode[m];
            d.mode[m]        = select(old > zero || index[m] >= one, Number(min(Number(old + growth), one)), old);
            step.growth += d.mode[m] - old;
          }
        const Number               fibre = one - d.fibre(), matrix = one - d.matrix();
        const PlyStiffness<Number> left(material.ply, fibre, matrix);
        step.carries += share * min(fibre, matrix);
        step.broken += select(d.fibre() >= one || is_gap(d.matrix(), e, limit), Number(share), zero);
        left.compute_stress(e, s);
        // what grows with h: its mean over the layer is none
        Number bend[3], slope[3];
        compute_ply_strain(
          layer, 1.,
          LaminateState<Number>{{zero, zero, zero, state.strain[3], state.strain[4], state.strain[5], zero, zero}, {}}
            .strain,
          bend);
        left.compute_stress(bend, slope);
        const double cc = layer.cos * layer.cos, ss = layer.sin * layer.sin, cs = layer.cos * layer.sin;
        const auto   add = [&](const Number(&in)[3], const double scale, Number *out) {
          out[0] += scale * (cc * in[0] + ss * in[1] - 2. * cs * in[2]);
          out[1] += scale * (ss * in[0] + cc * in[1] + 2. * cs * in[2]);
          out[2] += scale * (cs * (in[0] - in[1]) + (cc - ss) * in[2]);
        };
        add(s, share, state.stress);
        add(s, share * h, state.stress + 3);
        add(slope, share * second, state.stress + 3);
      }
    update_laminate_shear(law, state);
    return step;
  }

  /// What a step has dissipated (J/m^3), of states before and after it. Nodal work is trapezoidal, so that of
  /// (s_0 + s_1)/2 (e_1 - e_0) what is not stored is, with symmetric stiffnesses C_0 and C_1, e_0 (C_0 - C_1) e_1 / 2.
  template <class Number>
  Number released_energy(const LaminateState<Number> &before, const LaminateState<Number> &after)
  {
    Number sum = 0.;
    for (int i = 0; i < n_laminate_strains; ++i)
      sum += before.stress[i] * after.strain[i] - after.stress[i] * before.strain[i];
    return 0.5 * sum;
  }
} // namespace birdstrike
