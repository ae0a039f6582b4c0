#pragma once

#include "structure/elements/shell/kernel.h"

namespace birdstrike
{
  /// Belytschko, Lin & Tsay (1984): plane kinematics at the centre, director e3, perturbation hourglass control with
  /// one coefficient r for membrane, w and theta modes. Stiffnesses of the five modes q = gamma_I v_I (their eq. 27):
  ///   r/8 E t A B.B (membrane),  r/12 kappa G t^3 B.B (w),  r/192 E t^3 A B.B (theta),
  /// written as strain-like amplitudes so that the section treats them as it treats physical stabilisation.
  /// The rotation about the director n of a node is replaced by the spin of the element about n, and the moment
  /// about n becomes the forces that work on this spin: free drilling makes curved shells converge to a wrong value.
  ///
  /// The membrane modes of a warped element leave out what its tilt gives them, q + warp n . u_,a, so that it turns
  /// without hourglass forces, and these keep angular momentum. The paper's, projected to the plane, do neither, which
  /// is what makes its element fail the twisted beam (Belytschko, Wong & Chiang 1992): below 0.5 of the deflection,
  /// 0.996 with the term.
  ///
  /// Known limit: fails the bending patch test on irregular meshes.
  template <class Number>
  struct BelytschkoTsay
  {
    const ShellGeometry<Number> &g;
    Number                       membrane, w, theta;

    BelytschkoTsay(const ShellGeometry<Number> &g, const Number &thickness, const double coefficient) : g(g)
    {
      // B.B = sum_I (b_xI^2 + b_yI^2); 4: q = h_I v_I - ... = 4 u_gamma
      const Number bb = 0.25 * (g.g11 + g.g22), scale = 4. * bb * inverse_root(bb); // 4 sqrt(bb)
      membrane = std::sqrt(3. / 8. * coefficient) * scale;
      theta    = std::sqrt(3. / 16. * coefficient) * scale;
      w        = std::sqrt(0.25 * coefficient) * thickness * scale * inverse_root(g.area);
    }

    /// Spin of the element from the displacement modes, with the contravariant base vectors b1 x n = -a2/|a1 x a2| and
    /// b2 x n = a1/|a1 x a2|.
    Vector3<Number> compute_spin(const ShellModes<Number> &u) const
    {
      const Vector3<Number> &a1 = g.x.m1, &a2 = g.x.m2, &n = g.e3;
      const Number           j = g.inverse_det, half = 0.5;
      return (j * n.dot(u.m2)) * a1 - (j * n.dot(u.m1)) * a2 + (half * j * (a2.dot(u.m1) - a1.dot(u.m2))) * n;
    }

    ShellVector<Number> compute_strains(const Vector3<Number> (&displacement)[4], const Vector3<Number> (&rotation)[4],
                                        const Vector3<Number> (&normal)[4]) const
    {
      const auto            u    = ShellModes<Number>::of_corners(displacement);
      const Vector3<Number> spin = compute_spin(u);
      Vector3<Number>       director[4];
      for (int i = 0; i < 4; ++i)
        {
          const Vector3<Number> relative  = rotation[i] - spin;
          const Vector3<Number> projected = rotation[i] - normal[i].dot(relative) * normal[i];
          director[i]                     = projected.cross(g.e3);
        }
      const auto             dd = ShellModes<Number>::of_corners(director);
      const Vector3<Number> &a1 = g.x.m1, &a2 = g.x.m2;
      ShellVector<Number>    s;
      physical_shell::compute_tensor(g, Number(a1.dot(u.m1)), Number(a2.dot(u.m2)), Number(a1.dot(u.m2) + a2.dot(u.m1)),
                                     s.membrane);
      physical_shell::compute_tensor(g, Number(a1.dot(dd.m1)), Number(a2.dot(dd.m2)),
                                     Number(a1.dot(dd.m2) + a2.dot(dd.m1)), s.curvature);
      const Number quarter = 0.25; // a mean, see ShellModes
      const Number tilt_1 = g.e3.dot(u.m1), tilt_2 = g.e3.dot(u.m2);
      const Number shear_1 = quarter * a1.dot(dd.m0) + tilt_1, shear_2 = quarter * a2.dot(dd.m0) + tilt_2;
      s.shear[0]                     = shear_1 * g.c1x + shear_2 * g.c2x;
      s.shear[1]                     = shear_1 * g.c1y + shear_2 * g.c2y;
      const Vector3<Number> u_gamma  = u.m3 - g.alpha * u.m1 - g.beta * u.m2;
      const Vector3<Number> dd_gamma = dd.m3 - g.alpha * dd.m1 - g.beta * dd.m2;
      set_components(a1.dot(u_gamma) + g.warp * tilt_1, a2.dot(u_gamma) + g.warp * tilt_2, membrane, s.linear_membrane);
      set_components(a1.dot(dd_gamma), a2.dot(dd_gamma), theta, s.linear_curvature);
      s.linear_shear[0] = w * g.e3.dot(u_gamma);
      s.linear_shear[1] = Number(0.);
      return s;
    }

    void compute_corner_forces(const ShellVector<Number> &r, const Vector3<Number> (&normal)[4],
                               Vector3<Number> (&force)[4], Vector3<Number> (&moment)[4]) const
    {
      const Vector3<Number>                      &a1 = g.x.m1, &a2 = g.x.m2, &n = g.e3;
      const physical_shell::Contravariant<Number> N(g, r.membrane), M(g, r.curvature);
      const Number                                q1    = g.area * (r.shear[0] * g.c1x + r.shear[1] * g.c1y);
      const Number                                q2    = g.area * (r.shear[0] * g.c2x + r.shear[1] * g.c2y);
      const Number                                third = (1. / 3.) * g.area;
      const Along                                 membrane_modes(g, third * membrane, r.linear_membrane);
      const Along                                 theta_modes(g, third * theta, r.linear_curvature);
      const Vector3<Number>                       f_gamma =
        membrane_modes.along_1 * a1 + membrane_modes.along_2 * a2 + (third * w * r.linear_shear[0]) * n;
      const Vector3<Number> fd_gamma = theta_modes.along_1 * a1 + theta_modes.along_2 * a2;
      ShellModes<Number>    f, fd;
      fd.m0 = (0.25 * q1) * a1 + (0.25 * q2) * a2;
      fd.m1 = M.n11 * a1 + M.n12 * a2 - g.alpha * fd_gamma;
      fd.m2 = M.n12 * a1 + M.n22 * a2 - g.beta * fd_gamma;
      fd.m3 = fd_gamma;
      fd.sum_at_corners(moment);
      Vector3<Number> about_normals = Vector3<Number>::Constant(Number(0.));
      for (int i = 0; i < 4; ++i)
        {
          const Vector3<Number> m = n.cross(moment[i]);
          const Vector3<Number> c = normal[i].dot(m) * normal[i];
          moment[i]               = m - c;
          about_normals += c;
        }
      const Number j = g.inverse_det, half = 0.5 * j * about_normals.dot(n);
      f.m0 = Vector3<Number>::Constant(Number(0.));
      f.m1 = N.n11 * a1 + (N.n12 + half) * a2 - g.alpha * f_gamma +
             (q1 + g.warp * membrane_modes.along_1 - j * about_normals.dot(a2)) * n;
      f.m2 = (N.n12 - half) * a1 + N.n22 * a2 - g.beta * f_gamma +
             (q2 + g.warp * membrane_modes.along_2 + j * about_normals.dot(a1)) * n;
      f.m3 = f_gamma;
      f.sum_at_corners(force);
    }

  private:
    /// factor (e1.v, e2.v), of a vector v by its products with a1 and a2.
    void set_components(const Number &v1, const Number &v2, const Number &factor, Number (&components)[2]) const
    {
      components[0] = factor * (v1 * g.c1x + v2 * g.c2x);
      components[1] = factor * (v1 * g.c1y + v2 * g.c2y);
    }

    /// factor (c_x e1 + c_y e2) = along_1 a1 + along_2 a2
    struct Along
    {
      Number along_1, along_2;

      Along(const ShellGeometry<Number> &g, const Number &factor, const Number (&c)[2])
        : along_1(factor * (c[0] * g.c1x + c[1] * g.c1y)), along_2(factor * (c[0] * g.c2x + c[1] * g.c2y))
      {
      }
    };
  };
} // namespace birdstrike
