#pragma once

#include "structure/elements/section_law.h"
#include "structure/elements/shell/geometry.h"
#include "structure/elements/shell/laminate/laminate.h"

namespace birdstrike
{
  /// A section's strains since the start and its Kirchhoff stresses, in the laminate's axes. Stress is a function of
  /// strain and of what has failed: energy and what failure takes of it are exact.
  template <class Number>
  struct LaminateState
  {
    Number strain[n_laminate_strains], stress[n_laminate_strains];
  };

  /// What an element of plies keeps of its shape at rest: the reference direction and its normal in the plane as
  /// numbers on a1 and a2, which go with the material; the moduli of its stabilisation along a1 and a2.
  template <class Number>
  struct LaminateElement
  {
    Number first[2], second[2];
    Number membrane[2], coupling[2], bending[2]; ///< Pa, Laminate::Beam; of the strain at z = t/2
    Number shear[2];                             ///< Pa, along the contravariant base
    Number lateral[2], skew[2];                  ///< -, Laminate::Uniaxial, of the assumed membrane strain
  };

  /// Calls f(one, other) for each pair of numbers that two of these, of any number type, hold.
  template <class One, class Other, class Function>
  void for_pairs(One &one, Other &other, const Function &f)
  {
    for (int d = 0; d < 2; ++d)
      {
        f(one.first[d], other.first[d]);
        f(one.second[d], other.second[d]);
        f(one.membrane[d], other.membrane[d]);
        f(one.coupling[d], other.coupling[d]);
        f(one.bending[d], other.bending[d]);
        f(one.shear[d], other.shear[d]);
        f(one.lateral[d], other.lateral[d]);
        f(one.skew[d], other.skew[d]);
      }
  }

  /// The laminate's axes in the frame of an element: turned with the material by the rotation of the polar
  /// decomposition of its deformation at the centre, so that neither the numbering of nodes nor an element's shape
  /// matters and no fibre's turning goes before another's. They stay orthogonal; fibres are off by half the shear
  /// strain at most.
  template <class Number>
  struct LaminateAxes
  {
    Number c, s; ///< first axis = c e1 + s e2

    [[gnu::always_inline]] LaminateAxes(const ShellGeometry<Number> &g, const LaminateElement<Number> &e)
    {
      // a1 ~ (c2y, -c2x), a2 ~ (-c1y, c1x)
      const Number cosine  = e.first[0] * g.c2y - e.first[1] * g.c1y - e.second[0] * g.c2x + e.second[1] * g.c1x;
      const Number sine    = e.first[1] * g.c1x - e.first[0] * g.c2x - e.second[0] * g.c2y + e.second[1] * g.c1y;
      const Number inverse = inverse_root(Number(cosine * cosine + sine * sine));
      c                    = inverse * cosine;
      s                    = inverse * sine;
    }

    /// Adds a strain increment of the element's frame.
    [[gnu::always_inline]] void add(const SectionVector<Number> &e, const Number &half_thickness,
                                    Number (&strain)[n_laminate_strains]) const
    {
      const Number cc = c * c, ss = s * s, cs = c * s;
      const auto   turn = [&](const Number(&in)[3], const Number &scale, Number *out) {
        out[0] += scale * (cc * in[0] + ss * in[1] + cs * in[2]);
        out[1] += scale * (ss * in[0] + cc * in[1] - cs * in[2]);
        out[2] += scale * (2. * cs * (in[1] - in[0]) + (cc - ss) * in[2]);
      };
      turn(e.membrane, Number(1.), strain);
      turn(e.curvature, half_thickness, strain + 3);
      strain[6] += c * e.shear[0] + s * e.shear[1];
      strain[7] += c * e.shear[1] - s * e.shear[0];
    }

    /// A plane stress of the laminate's axes in the element's frame, times `scale`.
    [[gnu::always_inline]] void turn_stress(const Number *in, const double scale, Number (&out)[3]) const
    {
      const Number cc = c * c, ss = s * s, cs = c * s, twice = 2. * cs * in[2];
      out[0] = scale * (cc * in[0] + ss * in[1] - twice);
      out[1] = scale * (ss * in[0] + cc * in[1] + twice);
      out[2] = scale * (cs * (in[0] - in[1]) + (cc - ss) * in[2]);
    }

    /// Mean, linear and shear stress as elements and reports take them.
    [[gnu::always_inline]] void set(const LaminateState<Number> &state, SectionStress<Number> &section) const
    {
      turn_stress(state.stress, 1., section.mean);
      turn_stress(state.stress + 3, 3., section.outer);
      section.shear[0] = c * state.stress[6] - s * state.stress[7];
      section.shear[1] = s * state.stress[6] + c * state.stress[7];
    }
  };

  /// Volume at rest over that with the strain: the thickness of a laminate stays.
  template <class Number>
  [[gnu::always_inline]] inline Number laminate_contraction(const LaminateState<Number> &state)
  {
    return fourth_power_of_exp_minus(Number(0.25 * (state.strain[0] + state.strain[1])));
  }

  /// J/m^3
  template <class Number>
  Number laminate_energy(const LaminateState<Number> &state)
  {
    Number sum = 0.;
    for (int i = 0; i < n_laminate_strains; ++i)
      sum += state.strain[i] * state.stress[i];
    return 0.5 * sum;
  }

  /// Transverse shear stress, which plies keep until the element fails.
  template <class Number>
  [[gnu::always_inline]] inline void update_laminate_shear(const Laminate &law, LaminateState<Number> &state)
  {
    state.stress[6] = law.shear[0] * state.strain[6] + law.shear[2] * state.strain[7];
    state.stress[7] = law.shear[2] * state.strain[6] + law.shear[1] * state.strain[7];
  }

  /// Stress of the whole laminate, no ply of which has failed.
  template <class Number>
  [[gnu::always_inline]] inline void update_laminate_stress(const Laminate &law, LaminateState<Number> &state)
  {
    for (int i = 0; i < 6; ++i)
      {
        Number sum = law.stiffness[i][0] * state.strain[0];
        for (int j = 1; j < 6; ++j)
          sum += law.stiffness[i][j] * state.strain[j];
        state.stress[i] = sum;
      }
    update_laminate_shear(law, state);
  }

  /// (e_11, e_22, 2 e_12) in a layer's own axes at the height h.
  template <class Number>
  [[gnu::always_inline]] inline void compute_ply_strain(const Laminate::Layer &layer, const double h,
                                                        const Number (&strain)[n_laminate_strains], Number (&e)[3])
  {
    const double cc = layer.cos * layer.cos, ss = layer.sin * layer.sin, cs = layer.cos * layer.sin;
    const Number x = strain[0] + h * strain[3], y = strain[1] + h * strain[4], xy = strain[2] + h * strain[5];
    e[0] = cc * x + ss * y + cs * xy;
    e[1] = ss * x + cc * y - cs * xy;
    e[2] = 2. * cs * (y - x) + (cc - ss) * xy;
  }
} // namespace birdstrike
