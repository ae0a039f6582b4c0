#pragma once

#include "structure/elements/solid/law.h"
#include "structure/elements/solid/solid_shell_return.h"

namespace birdstrike
{
  /// Solid-shell: the one-point brick (one_point.h), with points through the thickness once it yields.
  ///
  /// The third axis is the thickness. While nothing has yielded the element is the one-point brick: mean stress and
  /// stabilisation, whose plane k = 3 is the bending of the section in plane stress. When the bound q_mean + q_bending
  /// of the stress at a face meets the yield stress, the element gets points: at zeta the stress is mean + zeta bending
  /// (no approximation), later with what flow leaves behind at the points, the residual stress, which has neither mean
  /// nor moment. So an elastic step changes no point, and mean and moment of the section are those of its points.
  ///
  /// A point flows by its own stress (SolidShellReturn): layer by layer, as in a shell, with full thickness stress and
  /// transverse shear (Hauptmann & Schweizerhof 1998; Cardoso et al. 2008 and Schwarze & Reese 2009 have the same
  /// points in elements that lock nowhere for other reasons). What varies in the plane of the element (planes k = 1, 2
  /// and the last modes) has no points: it counts in every layer's yield surface as in Ilyushin's (see SolidFlow) and
  /// decays with the layers, by the mean of their factors, what is linear in zeta too by their share in the moment.
  /// So a hinge is not stiffened by it, and a core that stays elastic still carries it.
  namespace solid_shell
  {
    /// State of one point through the thickness, in the frame below.
    template <class Number>
    struct LayerPoint
    {
      Number residual[5];    ///< Pa: 11 + 22, 11 - 22, 12, 31, 32
      Number plastic_strain; ///< equivalent, -
      Number yield;          ///< Pa, static flow stress there
      Number plastic_work;   ///< J/m^3
    };

    /// Orthonormal frame of the layers: the bisectors of the unit vectors t_1, t_2 in the plane, which turn with the
    /// material on the mean, and the normal.
    template <class Number>
    struct Frame
    {
      Vector3<Number> axis[3];

      [[gnu::always_inline]] Frame(const SolidModes<Number> &x, const one_point_solid::Axes<Number> &axes)
      {
        const Vector3<Number> t1 = axes.inverse_length[0] * x.linear[0], t2 = axes.inverse_length[1] * x.linear[1];
        const Number          cosine = axes.cosine[2], a = inverse_root(Number(2. + 2. * cosine)),
                     b = inverse_root(Number(2. - 2. * cosine));
        axis[0]        = a * (t1 + t2);
        axis[1]        = b * (t2 - t1);
        axis[2]        = axis[0].cross(axis[1]);
      }

      /// Of a stress in global axes relative to the one across the section, which is returned: 11 + 22, 11 - 22, 12,
      /// 31, 32.
      [[gnu::always_inline]] Number turn_in(const Number (&stress)[6], Number (&s)[5]) const
      {
        Vector3<Number> on[3]; // traction on the planes of the axes
        for (int k = 0; k < 3; ++k)
          {
            const Vector3<Number> &n = axis[k];
            on[k] << stress[0] * n[0] + stress[3] * n[1] + stress[5] * n[2],
              stress[3] * n[0] + stress[1] * n[1] + stress[4] * n[2],
              stress[5] * n[0] + stress[4] * n[1] + stress[2] * n[2];
          }
        const Number across = axis[2].dot(on[2]), s11 = axis[0].dot(on[0]), s22 = axis[1].dot(on[1]);
        s[0] = s11 + s22 - 2. * across;
        s[1] = s11 - s22;
        s[2] = axis[0].dot(on[1]);
        s[3] = axis[0].dot(on[2]);
        s[4] = axis[1].dot(on[2]);
        return across;
      }

      /// Adds changes of these five and of the stress across to a stress in global axes.
      [[gnu::always_inline]] void add_to(const Number (&s)[5], const Number &across, Number (&stress)[6]) const
      {
        const Number          s11 = across + 0.5 * (s[0] + s[1]), s22 = across + 0.5 * (s[0] - s[1]);
        const Vector3<Number> a           = s11 * axis[0] + s[2] * axis[1] + s[3] * axis[2];
        const Vector3<Number> b           = s[2] * axis[0] + s22 * axis[1] + s[4] * axis[2];
        const Vector3<Number> c           = s[3] * axis[0] + s[4] * axis[1] + across * axis[2];
        constexpr int         pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};
        for (int k = 0; k < 6; ++k)
          {
            const auto [i, j] = pairs[k];
            stress[k] += axis[0][i] * a[j] + axis[1][i] * b[j] + axis[2][i] * c[j];
          }
      }
    };

    /// Von Mises' squares of the stabilisation (Pa^2): of the bending at a face; of what varies in the plane, as z^2 of
    /// SolidShellReturn, `varying` + zeta^2 `bent`.
    template <class Number>
    struct Squares
    {
      Number bending, varying, bent;

      [[gnu::always_inline]] explicit Squares(const one_point_solid::Stabilisation<Number> &s)
      {
        const auto of_plane = [&](const int k) __attribute__((always_inline))
        {
          const one_point_solid::PlaneSquares<Number> plane(s.linear[k]);
          return Number(1.5 * plane.all - 0.5 * plane.trace);
        };
        bending = of_plane(2);
        varying = (4. / 9.) * (of_plane(0) + of_plane(1)) + (16. / 81.) * (s.last[2] * s.last[2]);
        bent    = (4. / 9.) * (s.last[0] * s.last[0] + s.last[1] * s.last[1]);
      }

      /// Of the largest stress that a point may have.
      [[gnu::always_inline]] Number compute_bound(const Number &mean) const
      {
        return mean + bending + 2. * sqrt(mean * bending) + varying + bent;
      }
    };

    /// What all but the trace make of von Mises' square of a stress in the frame, relative to the one across: r^2 of
    /// SolidShellReturn.
    template <class Number>
    [[gnu::always_inline]] inline Number compute_rest(const Number (&t)[5])
    {
      return 0.75 * t[1] * t[1] + 3. * (t[2] * t[2] + t[3] * t[3] + t[4] * t[4]);
    }

    /// Work per volume of what varies in the plane on its strains.
    template <class Number>
    [[gnu::always_inline]] inline Number compute_varying_work(const one_point_solid::Stabilisation<Number> &s,
                                                              const one_point_solid::Stabilisation<Number> &e)
    {
      Number linear = 0.;
#pragma GCC unroll 2
      for (int k = 0; k < 2; ++k)
        linear += s.linear[k][0] * e.linear[k][0] + s.linear[k][1] * e.linear[k][1] + s.linear[k][2] * e.linear[k][2];
      return (1. / 3.) * linear + (1. / 9.) * (s.last[0] * e.last[0] + s.last[1] * e.last[1] + s.last[2] * e.last[2]);
    }

    /// Elastic energy per volume of the same.
    template <class Number>
    [[gnu::always_inline]] inline Number compute_varying_energy(const Elasticity &elasticity,
                                                                const one_point_solid::Stabilisation<Number> &s)
    {
      Number linear = 0.;
      for (int k = 0; k < 2; ++k)
        {
          const one_point_solid::PlaneSquares<Number> plane(s.linear[k]);
          linear += (1. + elasticity.poisson) * plane.all - elasticity.poisson * plane.trace;
        }
      const Number last = s.last[0] * s.last[0] + s.last[1] * s.last[1] + s.last[2] * s.last[2];
      return (0.5 / elasticity.young) * ((1. / 3.) * linear + (1. / 9.) * last);
    }
  } // namespace solid_shell
} // namespace birdstrike
