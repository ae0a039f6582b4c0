#pragma once

#include "structure/elements/shell/kernel.h"

namespace birdstrike
{
  /// The 2 x 2 points in the plane of a fully integrated shell; theory: full_integration.h.
  namespace full_integration
  {
    inline constexpr int    n_points = 4;
    inline constexpr double place    = 0.57735026918962576; ///< 1/sqrt(3)
    /// Points in the order of the corners.
    inline constexpr double xi[n_points]  = {-place, place, place, -place};
    inline constexpr double eta[n_points] = {-place, -place, place, place};

    /// Amplitudes of the strain increments of an element, or the integrals over the area of the resultants that work on
    /// them: their products sum to the power.
    template <class Number>
    struct Amplitudes
    {
      Number membrane[3];        ///< at the centre, xx, yy, 2xy (-; N m)
      Number linear_membrane[2]; ///< along a1 ~ eta, along a2 ~ xi (-; N m)
      Number curvature[6];       ///< K_11, K_22, 2 K_12, 2 K_13, 2 K_23, K_33 (m; N)
      Number shear[2];           ///< g_1, g_2, covariant (m; N)
      Number linear_shear[2];    ///< g_1 ~ eta, g_2 ~ xi
    };

    /// Area and contravariant base at a point, in the frame of the element (a warped element is projected on it).
    template <class Number>
    struct PointBase
    {
      Number area, c1x, c1y, c2x, c2y; ///< m^2, that the point stands for; 1/m
    };

    /// Strains of a uniaxial stress along a1 and along a2, and the four points.
    template <class Number>
    struct PlaneGeometry
    {
      Number            uniaxial[2][3]; ///< xx, yy, 2xy of s s - nu n n
      Number            mean_eta, mean_xi;
      Number            smallest_jacobian; ///< over that at the centre
      PointBase<Number> point[n_points];

      /// Of a metal.
      [[gnu::always_inline]] PlaneGeometry(const ShellGeometry<Number> &g, const double poisson) : PlaneGeometry(g)
      {
        // the base is the inverse of the contravariant one: a1 = |a1 x a2| (c2y, -c2x), a2 = |a1 x a2| (-c1y, c1x)
        const Number nu = poisson, scale = (1. + poisson) * 16. * g.area * g.area;
        const Number s1 = scale * g.l1, s2 = scale * g.l2;
        set(uniaxial[0], s1 * g.c2y * g.c2y - nu, s1 * g.c2x * g.c2x - nu, -2. * s1 * g.c2x * g.c2y);
        set(uniaxial[1], s2 * g.c1y * g.c1y - nu, s2 * g.c1x * g.c1x - nu, -2. * s2 * g.c1x * g.c1y);
      }

      /// Of a laminate: the strains across a1 and a2 and the shear strains there (-) of a uniaxial stress of strain
      /// one.
      [[gnu::always_inline]] PlaneGeometry(const ShellGeometry<Number> &g, const Number (&lateral)[2],
                                           const Number (&skew)[2])
        : PlaneGeometry(g)
      {
        const Number scale = 16. * g.area * g.area;
        const auto   along = [&](const Number &length, const Number &x, const Number &y, const int d) {
          const Number xx = scale * length * x * x, yy = scale * length * y * y, xy = scale * length * x * y;
          set(uniaxial[d], xx + lateral[d] * yy - skew[d] * xy, yy + lateral[d] * xx + skew[d] * xy,
                2. * (Number(1.) - lateral[d]) * xy + skew[d] * (xx - yy));
        };
        along(g.l1, g.c2y, Number(-g.c2x), 0);
        along(g.l2, Number(-g.c1y), g.c1x, 1);
      }

    private:
      [[gnu::always_inline]] explicit PlaneGeometry(const ShellGeometry<Number> &g)
        : mean_eta((1. / 3.) * g.alpha), mean_xi((1. / 3.) * g.beta)
      {
        Number j[n_points];
        for (int k = 0; k < n_points; ++k)
          j[k] = Number(1.) + eta[k] * g.alpha + xi[k] * g.beta;
        smallest_jacobian = min(min(j[0], j[2]), min(j[1], j[3]));
        // four reciprocals with one division
        const Number p02 = j[0] * j[2], p13 = j[1] * j[3], product = Number(1.) / (p02 * p13);
        const Number i02 = product * p13, i13 = product * p02, quarter = 0.25 * g.area;
        const Number inverse[n_points] = {i02 * j[2], i13 * j[3], i02 * j[0], i13 * j[1]};
        for (int k = 0; k < n_points; ++k)
          {
            // a1 + eta a3 and a2 + xi a3, in the plane a3 = alpha a1 + beta a2: the inverse differs by a dyad
            const Number x = inverse[k] * (eta[k] * g.c1x + xi[k] * g.c2x);
            const Number y = inverse[k] * (eta[k] * g.c1y + xi[k] * g.c2y);
            point[k]       = {quarter * j[k], g.c1x - g.alpha * x, g.c1y - g.alpha * y, g.c2x - g.beta * x,
                              g.c2y - g.beta * y};
          }
      }

      static void set(Number (&vector)[3], const Number &xx, const Number &yy, const Number &xy)
      {
        vector[0] = xx;
        vector[1] = yy;
        vector[2] = xy;
      }
    };

    /// Covariant components of a symmetric tensor sym(t_a . K . t_b) at point k, of its amplitudes as of the curvature.
    template <class Number>
    struct AtPoint
    {
      Number k11, k22, two_k12;

      [[gnu::always_inline]] AtPoint(const Number (&K)[6], const int k)
      {
        const Number both = (1. / 3.) * K[5]; // eta^2 = xi^2 = 1/3
        k11               = K[0] + both + eta[k] * K[3];
        k22               = K[1] + both + xi[k] * K[4];
        two_k12           = K[2] + xi[k] * K[3] + eta[k] * K[4] + (2. * xi[k] * eta[k]) * K[5];
      }
    };

    /// The gradient of the directors at every point.
    template <class Number>
    struct DirectorGradient
    {
      Number B[6];

      [[gnu::always_inline]] explicit DirectorGradient(const ShellGeometry<Number> &g)
      {
        const Vector3<Number> &a1 = g.x.m1, &a2 = g.x.m2, &a3 = g.x.m3, &d1 = g.d.m1, &d2 = g.d.m2, &d3 = g.d.m3;
        B[0] = a1.dot(d1);
        B[1] = a2.dot(d2);
        B[2] = a1.dot(d2) + a2.dot(d1);
        B[3] = a1.dot(d3) + a3.dot(d1);
        B[4] = a2.dot(d3) + a3.dot(d2);
        B[5] = a3.dot(d3);
      }
      [[gnu::always_inline]] physical_shell::Shifter<Number> at(const PlaneGeometry<Number> &plane, const int k) const
      {
        const AtPoint<Number> b(B, k);
        return {plane.point[k], b.k11, b.k22, b.two_k12};
      }
    };

    template <class Number>
    [[gnu::always_inline]] inline void
    compute_point_strains(const PlaneGeometry<Number> &plane, const DirectorGradient<Number> &gradient,
                          const Amplitudes<Number> &s, SectionVector<Number> (&strain)[n_points])
    {
      Number mean[3], along_1[3], along_2[3];
      for (int c = 0; c < 3; ++c)
        {
          along_1[c] = s.linear_membrane[0] * plane.uniaxial[0][c];
          along_2[c] = s.linear_membrane[1] * plane.uniaxial[1][c];
          mean[c]    = s.membrane[c] - plane.mean_eta * along_1[c] - plane.mean_xi * along_2[c];
        }
      for (int k = 0; k < n_points; ++k)
        {
          const PointBase<Number> &p = plane.point[k];
          for (int c = 0; c < 3; ++c)
            strain[k].membrane[c] = mean[c] + eta[k] * along_1[c] + xi[k] * along_2[c];
          const AtPoint<Number> curvature(s.curvature, k);
          physical_shell::compute_tensor(p, curvature.k11, curvature.k22, curvature.two_k12, strain[k].curvature);
          gradient.at(plane, k).shift_curvature(strain[k].membrane, strain[k].curvature);
          const Number g1 = s.shear[0] + eta[k] * s.linear_shear[0], g2 = s.shear[1] + xi[k] * s.linear_shear[1];
          strain[k].shear[0] = g1 * p.c1x + g2 * p.c2x;
          strain[k].shear[1] = g1 * p.c1y + g2 * p.c2y;
        }
    }

    /// The transpose of compute_point_strains, integrated over the area.
    template <class Number>
    [[gnu::always_inline]] inline Amplitudes<Number>
    integrate_resultants(const PlaneGeometry<Number> &plane, const DirectorGradient<Number> &gradient,
                         const SectionVector<Number> (&resultants)[n_points])
    {
      Amplitudes<Number> r{};
      Number             by_eta[3]{}, by_xi[3]{};
      auto              &M = r.curvature;
      for (int k = 0; k < n_points; ++k)
        {
          const PointBase<Number>     &p           = plane.point[k];
          const SectionVector<Number> &n           = resultants[k];
          Number                       membrane[3] = {n.membrane[0], n.membrane[1], n.membrane[2]};
          gradient.at(plane, k).shift_force(n.curvature, membrane);
          for (int c = 0; c < 3; ++c)
            {
              const Number force = p.area * membrane[c];
              r.membrane[c] += force;
              by_eta[c] += eta[k] * force;
              by_xi[c] += xi[k] * force;
            }
          const physical_shell::Contravariant<Number> m(p, n.curvature);
          M[0] += m.n11;
          M[1] += m.n22;
          M[2] += m.n12;
          M[3] += eta[k] * m.n11 + xi[k] * m.n12;
          M[4] += xi[k] * m.n22 + eta[k] * m.n12;
          M[5] += (1. / 3.) * (m.n11 + m.n22) + (2. * xi[k] * eta[k]) * m.n12;
          const Number q1 = p.area * (n.shear[0] * p.c1x + n.shear[1] * p.c1y);
          const Number q2 = p.area * (n.shear[0] * p.c2x + n.shear[1] * p.c2y);
          r.shear[0] += q1;
          r.shear[1] += q2;
          r.linear_shear[0] += eta[k] * q1;
          r.linear_shear[1] += xi[k] * q2;
        }
      r.linear_membrane[0] = r.linear_membrane[1] = Number(0.);
      for (int c = 0; c < 3; ++c)
        {
          r.linear_membrane[0] += plane.uniaxial[0][c] * (by_eta[c] - plane.mean_eta * r.membrane[c]);
          r.linear_membrane[1] += plane.uniaxial[1][c] * (by_xi[c] - plane.mean_xi * r.membrane[c]);
        }
      return r;
    }
  } // namespace full_integration
} // namespace birdstrike
