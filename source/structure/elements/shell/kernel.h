#pragma once

#include "structure/elements/shell/shifter.h"
#include "structure/elements/shell/vector.h"

namespace birdstrike
{
  /// One-point quadrilateral shell, default formulation.
  ///
  /// Surface x and directors d (those of the nodes, d.e3 = 1) are bilinear; a node has displacement u and rotation
  /// theta, its director moves by delta d = theta x d. Covariant increments (Dvorkin & Bathe 1984, eqs 6-10)
  ///   e_ab = sym(x,a . u,b),  k_ab = sym(x,a . delta d,b + d,a . u,b),  g_a = x,a . delta d + d . u,a,
  /// vanish for every rigid motion, of a warped element too, and do not contain the rotation about d: no drilling. What
  /// bends layers off the middle is k less what Shifter says.
  /// Warping enters through d,a and the warp of x (the z_gamma terms of Belytschko, Wong & Chiang 1992).
  ///
  /// Kept are the values at the centre, and of the rest what the stabilisation needs, so that nothing locks:
  /// - e_11 linear in eta and e_22 linear in xi, less what a constant strain contributes, with the uncoupled modulus E
  /// of
  ///   Pian & Sumihara (1984), which is their element in closed form on a constant Jacobian; the same for k;
  /// - g_1 linear in eta, g_2 linear in xi, tied at the edge midpoints as in MITC4 (Dvorkin & Bathe 1984).
  /// This is physical stabilisation in the sense of Belytschko & Leviathan (1994) and Zeng & Combescure (1998): no
  /// coefficient. The strain is 14-dimensional on 20 displacements (drilling apart): 6 rigid modes, no other.
  namespace physical_shell
  {
    /// At the centre, and the linear parts less what a constant strain contributes.
    template <class Number>
    [[gnu::always_inline]] inline void compute_membrane(const ShellGeometry<Number> &g, const ShellModes<Number> &u,
                                                        Number (&centre)[3], Number (&linear)[2])
    {
      const Vector3<Number> &a1 = g.x.m1, &a2 = g.x.m2;
      compute_tensor(g, Number(a1.dot(u.m1)), Number(a2.dot(u.m2)), Number(a1.dot(u.m2) + a2.dot(u.m1)), centre);
      const Vector3<Number> u_gamma = u.m3 - g.alpha * u.m1 - g.beta * u.m2;
      linear[0]                     = g.l1 * (a1.dot(u_gamma) + g.warp * g.e3.dot(u.m1));
      linear[1]                     = g.l2 * (a2.dot(u_gamma) + g.warp * g.e3.dot(u.m2));
    }

    /// Four times the covariant components that MITC4 ties at the edge midpoints: at the centre, and g_1 ~ eta,
    /// g_2 ~ xi. (Four: the directors are of the true surface, see ShellModes.)
    template <class Number>
    [[gnu::always_inline]] inline void compute_shear(const ShellGeometry<Number> &g, const ShellModes<Number> &u,
                                                     const ShellModes<Number> &dd, Number (&centre)[2],
                                                     Number (&linear)[2])
    {
      const Vector3<Number> &a1 = g.x.m1, &a2 = g.x.m2, &a3 = g.x.m3;
      const Vector3<Number> &d0 = g.d.m0, &d1 = g.d.m1, &d2 = g.d.m2;
      const Number           common = a3.dot(dd.m0) + d0.dot(u.m3);
      centre[0]                     = a1.dot(dd.m0) + a3.dot(dd.m2) + d0.dot(u.m1) + d2.dot(u.m3);
      centre[1]                     = a2.dot(dd.m0) + a3.dot(dd.m1) + d0.dot(u.m2) + d1.dot(u.m3);
      linear[0]                     = a1.dot(dd.m2) + d2.dot(u.m1) + common;
      linear[1]                     = a2.dot(dd.m1) + d1.dot(u.m2) + common;
    }

    /// From displacement modes u and director increment modes dd.
    template <class Number>
    [[gnu::always_inline]] inline ShellVector<Number>
    compute_strains(const ShellGeometry<Number> &g, const ShellModes<Number> &u, const ShellModes<Number> &dd)
    {
      const Vector3<Number> &a1 = g.x.m1, &a2 = g.x.m2, &d1 = g.d.m1, &d2 = g.d.m2;
      const Number           quarter = 0.25;
      ShellVector<Number>    s;
      compute_membrane(g, u, s.membrane, s.linear_membrane);
      compute_tensor(g, Number(a1.dot(dd.m1) + d1.dot(u.m1)), Number(a2.dot(dd.m2) + d2.dot(u.m2)),
                     Number(a1.dot(dd.m2) + a2.dot(dd.m1) + d1.dot(u.m2) + d2.dot(u.m1)), s.curvature);
      Shifter<Number>::at_centre(g).shift_curvature(s.membrane, s.curvature);
      const Vector3<Number> u_gamma  = u.m3 - g.alpha * u.m1 - g.beta * u.m2;
      const Vector3<Number> dd_gamma = dd.m3 - g.alpha * dd.m1 - g.beta * dd.m2;
      s.linear_curvature[0] =
        g.l1 * (a1.dot(dd_gamma) + g.warp * g.e3.dot(dd.m1) + d1.dot(u_gamma) + g.d_gamma.dot(u.m1));
      s.linear_curvature[1] =
        g.l2 * (a2.dot(dd_gamma) + g.warp * g.e3.dot(dd.m2) + d2.dot(u_gamma) + g.d_gamma.dot(u.m2));
      Number shear[2], linear[2];
      compute_shear(g, u, dd, shear, linear);
      s.shear[0]        = quarter * (shear[0] * g.c1x + shear[1] * g.c2x);
      s.shear[1]        = quarter * (shear[0] * g.c1y + shear[1] * g.c2y);
      s.linear_shear[0] = quarter * g.g1 * linear[0];
      s.linear_shear[1] = quarter * g.g2 * linear[1];
      return s;
    }

    /// Area times the contravariant components, with the contravariant base of `g`.
    template <class Number>
    struct Contravariant
    {
      Number n11, n22, n12;
      template <class Base>
      Contravariant(const Base &g, const Number (&n)[3])
        : n11(g.area * (n[0] * g.c1x * g.c1x + n[1] * g.c1y * g.c1y + 2. * n[2] * g.c1x * g.c1y))
        , n22(g.area * (n[0] * g.c2x * g.c2x + n[1] * g.c2y * g.c2y + 2. * n[2] * g.c2x * g.c2y))
        , n12(g.area * (n[0] * g.c1x * g.c2x + n[1] * g.c1y * g.c2y + n[2] * (g.c1x * g.c2y + g.c1y * g.c2x)))
      {
      }
    };

    /// The transpose of compute_strains, times the area: forces f on the modes of u, and fd on the modes of dd.
    template <class Number>
    [[gnu::always_inline]] inline void compute_mode_forces(const ShellGeometry<Number> &g, const ShellVector<Number> &r,
                                                           ShellModes<Number> &f, ShellModes<Number> &fd)
    {
      const Vector3<Number> &a1 = g.x.m1, &a2 = g.x.m2, &a3 = g.x.m3;
      const Vector3<Number> &d0 = g.d.m0, &d1 = g.d.m1, &d2 = g.d.m2;
      Number                 membrane[3] = {r.membrane[0], r.membrane[1], r.membrane[2]};
      Shifter<Number>::at_centre(g).shift_force(r.curvature, membrane);
      const Contravariant<Number> n(g, membrane), m(g, r.curvature);
      const Number                third = (1. / 3.) * g.area, quarter_area = 0.25 * g.area;
      const Number                l1 = third * g.l1, l2 = third * g.l2;
      const Number                h1 = l1 * r.linear_membrane[0], h2 = l2 * r.linear_membrane[1];
      const Number                b1 = l1 * r.linear_curvature[0], b2 = l2 * r.linear_curvature[1];
      const Number                q1 = quarter_area * (r.shear[0] * g.c1x + r.shear[1] * g.c1y);
      const Number                q2 = quarter_area * (r.shear[0] * g.c2x + r.shear[1] * g.c2y);
      const Number                r1 = (1. / 3.) * quarter_area * g.g1 * r.linear_shear[0];
      const Number                r2 = (1. / 3.) * quarter_area * g.g2 * r.linear_shear[1];

      const Vector3<Number> f_gamma  = h1 * a1 + h2 * a2 + b1 * d1 + b2 * d2;
      const Vector3<Number> fd_gamma = b1 * a1 + b2 * a2;
      f.m0                           = Vector3<Number>::Constant(Number(0.));
      f.m1 = n.n11 * a1 + n.n12 * a2 + m.n11 * d1 + m.n12 * d2 + (h1 * g.warp) * g.e3 + b1 * g.d_gamma + q1 * d0 +
             r1 * d2 - g.alpha * f_gamma;
      f.m2 = n.n12 * a1 + n.n22 * a2 + m.n12 * d1 + m.n22 * d2 + (h2 * g.warp) * g.e3 + b2 * g.d_gamma + q2 * d0 +
             r2 * d1 - g.beta * f_gamma;
      f.m3  = q1 * d2 + q2 * d1 + (r1 + r2) * d0 + f_gamma;
      fd.m0 = q1 * a1 + q2 * a2 + (r1 + r2) * a3;
      fd.m1 = m.n11 * a1 + m.n12 * a2 + (b1 * g.warp) * g.e3 + q2 * a3 + r2 * a2 - g.alpha * fd_gamma;
      fd.m2 = m.n12 * a1 + m.n22 * a2 + (b2 * g.warp) * g.e3 + q1 * a3 + r1 * a1 - g.beta * fd_gamma;
      fd.m3 = fd_gamma;
    }
  } // namespace physical_shell
} // namespace birdstrike
