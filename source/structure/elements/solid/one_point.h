#pragma once

#include "structure/elements/solid/geometry.h"

namespace birdstrike
{
  /// One-point brick: mean gradient and physical stabilisation.
  ///
  /// What the mean gradient L does not see are the twist modes w_k and the last mode of the displacement, less what L
  /// moves them by: w_k - L h_k with h of the geometry (Flanagan & Belytschko 1981, gamma projection). They vanish for
  /// fields that are linear in x, hence for rigid motions and in the patch test. Of the natural strains that they make
  /// with the base vectors a_k = x_,k at the centre,
  ///   e_ij = sym(a_i . u_,j),
  /// those are kept that lock nowhere; for every direction k with i, j following it, the membrane strains of the plane
  /// (a_i, a_j), linear in xi_k, are the curvature of a plate with its normal along k:
  ///   e_ii = a_i . w_j,  e_jj = a_j . w_i,  2 e_ij = a_i . w_i + a_j . w_j   (times xi_k),
  /// and of the last mode e_kk = a_k . w_last (times xi_i xi_j). Left out are the shears that a bending brick has for
  /// want of curved edges (assumed natural strain, Dvorkin & Bathe 1984). Each of the three planes is in plane stress,
  /// as if the strain across it, linear in xi_k too, were enhanced (Simo, Armero & Taylor 1993; Puso 2000); the last
  /// three have the modulus E. So a brick of any aspect bends as a plate or as a beam does, without locking in shear,
  /// volume or thickness, and without a coefficient: 6 + 12 strains on 24 displacements leave the six rigid motions.
  ///
  /// Components are physical. Those of plane k stand along the bisectors b_1, b_2 of the unit vectors t_i = a_i/|a_i|
  /// and t_j, orthonormal whatever the angle between those, and turn with the element. Components along t_i and t_j
  /// would be objective too, but with constant moduli they have no potential while the angle changes: a cantilever that
  /// swings and twists at strains of percent made ten times its energy in a hundred periods.
  /// Mean and stabilisation do their work apart: the mean of xi^2 is 1/3, of xi^2 eta^2 1/9.
  namespace one_point_solid
  {
    /// Stresses at xi_k = 1 (first index: the direction k; then 11 + 22, 11 - 22, 12) and at xi_i = xi_j = 1; or the
    /// strains that they work on (half of 11 + 22, half of 11 - 22, 2 12).
    template <class Number>
    struct Stabilisation
    {
      Number linear[3][3]; ///< -, Pa
      Number last[3];
    };

    /// The base vectors and what a skew plane needs.
    template <class Number>
    struct Axes
    {
      Number inverse_length[3]; ///< 1/|a_k|, of the modes (times eight), 1/m
      Number cosine[3];         ///< of the angle between a_i and a_j
      Number inverse_sine[3];

      [[gnu::always_inline]] explicit Axes(const SolidModes<Number> &x)
      {
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k)
          inverse_length[k] = inverse_root(Number(x.linear[k].dot(x.linear[k])));
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k)
          {
            const auto [i, j] = following(k);
            cosine[k]         = x.linear[i].dot(x.linear[j]) * (inverse_length[i] * inverse_length[j]);
            inverse_sine[k]   = inverse_root(Number(Number(1.) - cosine[k] * cosine[k]));
          }
      }
    };

    /// Stresses of plane k along the bisectors as what works on ii, jj and 2 ij along t_i, t_j.
    template <class Number>
    [[gnu::always_inline]] inline void turn_out(const Axes<Number> &axes, const int k, const Number (&s)[3],
                                                Number (&skew)[3])
    {
      const Number c = axes.cosine[k], r = axes.inverse_sine[k], half = 0.5 * r * r;
      const Number direct = half * (s[0] - c * s[1]), shear = r * s[2];
      skew[0] = direct - shear;
      skew[1] = direct + shear;
      skew[2] = half * (s[1] - c * s[0]);
    }

    template <class Number>
    [[gnu::always_inline]] inline Vector3<Number> project(const Vector3<Number> &u, const Matrix3<Number> &gradient,
                                                          const Vector3<Number> &h)
    {
      Vector3<Number> w;
#pragma GCC unroll 3
      for (int r = 0; r < 3; ++r)
        w[r] = u[r] - gradient(r, 0) * h[0] - gradient(r, 1) * h[1] - gradient(r, 2) * h[2];
      return w;
    }

    template <class Number>
    [[gnu::always_inline]] inline Stabilisation<Number>
    compute_strains(const SolidModes<Number> &x, const Axes<Number> &axes, const Matrix3<Number> &gradient,
                    const SolidModes<Number> &u)
    {
      Vector3<Number> w[3];
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        w[k] = project(u.twist[k], gradient, x.twist[k]);
      const Vector3<Number> last = project(u.last, gradient, x.last);
      Number                shear[3];
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        shear[k] = x.linear[k].dot(w[k]);
      Stabilisation<Number> e;
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        {
          const auto [i, j] = following(k);
          const Number ri = axes.inverse_length[i], rj = axes.inverse_length[j], rk = axes.inverse_length[k];
          const Number ii = x.linear[i].dot(w[j]) * (ri * ri), jj = x.linear[j].dot(w[i]) * (rj * rj);
          const Number ij = (shear[i] + shear[j]) * (ri * rj), sum = ii + jj; // ij doubled
          const Number c = axes.cosine[k], r = axes.inverse_sine[k], half = 0.5 * r * r;
          e.linear[k][0] = half * (sum - c * ij);
          e.linear[k][1] = half * (ij - c * sum);
          e.linear[k][2] = r * (jj - ii);
          e.last[k]      = x.linear[k].dot(last) * (rk * rk);
        }
      return e;
    }

    /// The transpose of mean gradient and compute_strains: forces on the modes that do the work V (mean : L) and that
    /// of the stabilisation V_0 (s : e). Mean stress (Pa), Cauchy's: xx, yy, zz, xy, yz, zx; `s` Kirchhoff's, and
    /// `rest_det` = 64 V_0 of the undeformed brick (m^3).
    template <class Number>
    [[gnu::always_inline]] inline SolidModes<Number>
    compute_mode_forces(const SolidGeometry<Number> &g, const Number &rest_det, const Number (&mean)[6],
                        const Stabilisation<Number> &s)
    {
      const SolidModes<Number> &x = g.x;
      const Axes<Number>        axes(x);
      const Number              third_volume = (1. / 192.) * rest_det;
      SolidModes<Number>        f;
      Vector3<Number>           direct[3]; // V_0/3 a_k/|a_k|^2
      Number                    skew[3][3], shear[3];
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        {
          const auto [i, j] = following(k);
          turn_out(axes, k, s.linear[k], skew[k]);
          shear[k]  = third_volume * (axes.inverse_length[i] * axes.inverse_length[j]) * skew[k][2];
          direct[k] = third_volume * (axes.inverse_length[k] * axes.inverse_length[k]) * x.linear[k];
        }
      f.last = Number(1. / 3.) * (s.last[0] * direct[0] + s.last[1] * direct[1] + s.last[2] * direct[2]);
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        {
          // w_k is in plane i (whose axes are j, k) as its jj, in plane j (axes k, i) as its ii, in both shears
          const auto [i, j] = following(k);
          f.linear[k]       = Vector3<Number>::Constant(Number(0.));
          f.twist[k]        = skew[i][0] * direct[j] + skew[j][1] * direct[i] + (shear[i] + shear[j]) * x.linear[k];
        }
      const Number    scale = 1. / 64.;
      Matrix3<Number> sum;
#pragma GCC unroll 3
      for (int r = 0; r < 3; ++r)
#pragma GCC unroll 3
        for (int c = 0; c < 3; ++c)
          {
            constexpr int index[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
            sum(r, c)                 = scale * mean[index[r][c]] -
                        g.inverse_det * (f.twist[0][r] * x.twist[0][c] + f.twist[1][r] * x.twist[1][c] +
                                         f.twist[2][r] * x.twist[2][c] + f.last[r] * x.last[c]);
          }
      g.add_mean_forces(sum, f);
      return f;
    }
  } // namespace one_point_solid
} // namespace birdstrike
