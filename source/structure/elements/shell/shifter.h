#pragma once

#include "structure/elements/shell/geometry.h"

namespace birdstrike::physical_shell
{
  /// From covariant components, with the contravariant base of `g`.
  template <class Base, class Number>
  [[gnu::always_inline]] inline void compute_tensor(const Base &g, const Number &k11, const Number &k22,
                                                    const Number &two_k12, Number (&k)[3])
  {
    k[0] = k11 * g.c1x * g.c1x + k22 * g.c2x * g.c2x + two_k12 * g.c1x * g.c2x;
    k[1] = k11 * g.c1y * g.c1y + k22 * g.c2y * g.c2y + two_k12 * g.c1y * g.c2y;
    k[2] = 2. * (k11 * g.c1x * g.c1y + k22 * g.c2x * g.c2y) + two_k12 * (g.c1x * g.c2y + g.c1y * g.c2x);
  }

  /// Layers off the middle are 1 + z b times as long, b = sym(x,a . d,b) in the element's frame (the shifter of shell
  /// theory, Naghdi 1972, to first order), so that increments e of the middle's strain bend them by
  ///   k - (e b + b e)
  /// and moments m add -(m b + b m) to the membrane force. That bending strain is the change of b itself, which depends
  /// on the place alone. Without it a closed path of stretching and bending is not one of the stress: the tangent of a
  /// bent shell is unsymmetric, by m t/(E t^3) of itself, and where waves of bending and of the membrane two elements
  /// long are equally fast they grow by flutter. On elements shorter than they are thick that made 2.5 % of all energy
  /// of the frontal strike.
  ///
  /// It takes directors that turn with the nodes' rotations (ShellNodes): with normals of the places waves on exact
  /// squares still grew by 80 (one point, 3.35 mm long, 4.27 thick) and 330 per second (fully integrated, 5 mm).
  template <class Number>
  struct Shifter
  {
    Number b[3]; ///< 1/m: xx, yy, xy, the tensor's own

    /// From covariant components.
    template <class Base>
    [[gnu::always_inline]] Shifter(const Base &g, const Number &b11, const Number &b22, const Number &two_b12)
    {
      compute_tensor(g, b11, b22, two_b12, b);
      b[2] *= 0.5;
    }

    [[gnu::always_inline]] static Shifter at_centre(const ShellGeometry<Number> &g)
    {
      const Vector3<Number> &a1 = g.x.m1, &a2 = g.x.m2, &d1 = g.d.m1, &d2 = g.d.m2;
      return Shifter(g, Number(a1.dot(d1)), Number(a2.dot(d2)), Number(a1.dot(d2) + a2.dot(d1)));
    }

    /// Shear components of e and k are twice the tensor's.
    [[gnu::always_inline]] void shift_curvature(const Number (&e)[3], Number (&k)[3]) const
    {
      k[0] -= 2. * e[0] * b[0] + e[2] * b[2];
      k[1] -= 2. * e[1] * b[1] + e[2] * b[2];
      k[2] -= 2. * (e[0] + e[1]) * b[2] + e[2] * (b[0] + b[1]);
    }

    /// The transpose.
    [[gnu::always_inline]] void shift_force(const Number (&m)[3], Number (&n)[3]) const
    {
      n[0] -= 2. * (m[0] * b[0] + m[2] * b[2]);
      n[1] -= 2. * (m[1] * b[1] + m[2] * b[2]);
      n[2] -= (m[0] + m[1]) * b[2] + m[2] * (b[0] + b[1]);
    }
  };
} // namespace birdstrike::physical_shell
