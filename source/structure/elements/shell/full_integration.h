#pragma once

#include "structure/elements/shell/plane_points.h"

namespace birdstrike
{
  /// Fully integrated quadrilateral shell: MITC4 (Dvorkin & Bathe 1984) with 2 x 2 points in its plane; the reference
  /// for the one-point element, with the same surface, directors, rotations and section law (kernel.h).
  ///
  /// With tangents t_1 = (1, 0, eta), t_2 = (0, 1, xi) of a bilinear function in its modes, the covariant curvature is
  ///   k_ab = t_a . K . t_b,   K_ij = sym(a_i . dd_j + d_i . u_j),   i, j = 1, 2, 3,
  /// without approximation; transverse shear is tied at the edge midpoints, g_1 linear in eta, g_2 linear in xi. Both
  /// are taken to the contravariant base of each point.
  ///
  /// The membrane strain, treated likewise, locks: in-plane bending e_11 ~ eta comes with a parasitic 2 e_12 ~ xi.
  /// Assumed instead is (Belytschko & Bindeman 1991, quintessential bending, along a_1 and a_2)
  ///   e = e(centre) + (eta - eta_m) e_1 (s_1 s_1 - nu n_1 n_1) + (xi - xi_m) e_2 (s_2 s_2 - nu n_2 n_2),
  /// s_1, n_1 along and across a_1; e_1, e_2 the linear parts less what a constant strain contributes; eta_m, xi_m the
  /// means over the area, so that constant stress works on the mean gradient alone (patch test). Elastic and on a
  /// constant Jacobian this is the element of Pian & Sumihara (1984).
  ///
  /// Verified: with the bilinear membrane strain this is MITC4 as published: Scordelis-Lo roof 0.9889, pinched cylinder
  /// 0.9285 (16 x 16; Ko, Lee & Bathe 2017: 0.9886, 0.9286). The assumed one gives 0.9975 and 0.9320, and for the first
  /// mode in the plane of the cantilever plate (benchmark A4) on 7 x 2, 14 x 4, 28 x 8 elements 708.2, 710.5, 710.3 Hz
  /// instead of 748.5, 721.3, 713.2.
  ///
  /// No motion is without strain but the six rigid ones and drilling: nothing is stabilised, no energy is hourglass
  /// energy. The lateral strain keeps the elastic nu when the points flow: 9 % too strong where an element yields by
  /// in-plane bending alone (flow rule in plane stress at e_n = -0.34 e_s).
  namespace full_integration
  {
    /// From displacement modes u and director increment modes dd.
    template <class Number>
    [[gnu::always_inline]] inline Amplitudes<Number>
    compute_strains(const ShellGeometry<Number> &g, const ShellModes<Number> &u, const ShellModes<Number> &dd)
    {
      const Vector3<Number> &a1 = g.x.m1, &a2 = g.x.m2, &a3 = g.x.m3, &d1 = g.d.m1, &d2 = g.d.m2, &d3 = g.d.m3;
      Amplitudes<Number>     s;
      physical_shell::compute_membrane(g, u, s.membrane, s.linear_membrane);
      s.curvature[0] = a1.dot(dd.m1) + d1.dot(u.m1);
      s.curvature[1] = a2.dot(dd.m2) + d2.dot(u.m2);
      s.curvature[2] = a1.dot(dd.m2) + a2.dot(dd.m1) + d1.dot(u.m2) + d2.dot(u.m1);
      s.curvature[3] = a1.dot(dd.m3) + a3.dot(dd.m1) + d1.dot(u.m3) + d3.dot(u.m1);
      s.curvature[4] = a2.dot(dd.m3) + a3.dot(dd.m2) + d2.dot(u.m3) + d3.dot(u.m2);
      s.curvature[5] = a3.dot(dd.m3) + d3.dot(u.m3);
      physical_shell::compute_shear(g, u, dd, s.shear, s.linear_shear);
      for (int c = 0; c < 2; ++c)
        {
          s.shear[c] *= 0.25;
          s.linear_shear[c] *= 0.25;
        }
      return s;
    }

    /// The transpose of compute_strains: forces f on the modes of u, and fd on the modes of dd.
    template <class Number>
    [[gnu::always_inline]] inline void compute_mode_forces(const ShellGeometry<Number> &g, const Amplitudes<Number> &r,
                                                           ShellModes<Number> &f, ShellModes<Number> &fd)
    {
      const Vector3<Number>                      &a1 = g.x.m1, &a2 = g.x.m2, &a3 = g.x.m3;
      const Vector3<Number>                      &d0 = g.d.m0, &d1 = g.d.m1, &d2 = g.d.m2, &d3 = g.d.m3;
      const physical_shell::Contravariant<Number> n(PointBase<Number>{Number(1.), g.c1x, g.c1y, g.c2x, g.c2y},
                                                    r.membrane);
      const Number                                h1 = g.l1 * r.linear_membrane[0], h2 = g.l2 * r.linear_membrane[1];
      const Number                                q1 = 0.25 * r.shear[0], q2 = 0.25 * r.shear[1];
      const Number                                r1 = 0.25 * r.linear_shear[0], r2 = 0.25 * r.linear_shear[1];
      const auto                                 &M       = r.curvature;
      const Vector3<Number>                       f_gamma = h1 * a1 + h2 * a2;
      f.m0                                                = Vector3<Number>::Constant(Number(0.));
      f.m1 = n.n11 * a1 + n.n12 * a2 + (h1 * g.warp) * g.e3 - g.alpha * f_gamma + M[0] * d1 + M[2] * d2 + M[3] * d3 +
             q1 * d0 + r1 * d2;
      f.m2 = n.n12 * a1 + n.n22 * a2 + (h2 * g.warp) * g.e3 - g.beta * f_gamma + M[2] * d1 + M[1] * d2 + M[4] * d3 +
             q2 * d0 + r2 * d1;
      f.m3  = f_gamma + M[3] * d1 + M[4] * d2 + M[5] * d3 + q1 * d2 + q2 * d1 + (r1 + r2) * d0;
      fd.m0 = q1 * a1 + q2 * a2 + (r1 + r2) * a3;
      fd.m1 = M[0] * a1 + M[2] * a2 + M[3] * a3 + q2 * a3 + r2 * a2;
      fd.m2 = M[2] * a1 + M[1] * a2 + M[4] * a3 + q1 * a3 + r1 * a1;
      fd.m3 = M[3] * a1 + M[4] * a2 + M[5] * a3;
    }
  } // namespace full_integration
} // namespace birdstrike
