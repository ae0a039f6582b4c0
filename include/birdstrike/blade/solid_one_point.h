#pragma once

#include <birdstrike/blade/solid_geometry.h>
#include <birdstrike/material/elasticity.h>

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
  /// Components are physical, along the unit vectors t_i = a_i/|a_i|, which turn with the element: the stabilisation is
  /// objective without a frame. Mean and stabilisation do their work apart: the mean of xi^2 is 1/3, of xi^2 eta^2 1/9.
  namespace one_point_solid
  {
    /// Strains at xi_k = 1 (first index: the direction k; then ii, jj, 2 ij) and at xi_i = xi_j = 1, or their stresses.
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

      [[gnu::always_inline]] explicit Axes(const SolidModes<Number> &x)
      {
        for (int k = 0; k < 3; ++k)
          inverse_length[k] = inverse_root(Number(x.linear[k].dot(x.linear[k])));
        for (int k = 0; k < 3; ++k)
          {
            const auto [i, j] = following(k);
            cosine[k]         = x.linear[i].dot(x.linear[j]) * (inverse_length[i] * inverse_length[j]);
          }
      }
    };

    template <class Number>
    [[gnu::always_inline]] inline Vector3<Number> project(const Vector3<Number> &u, const Matrix3<Number> &gradient,
                                                          const Vector3<Number> &h)
    {
      Vector3<Number> w;
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
      for (int k = 0; k < 3; ++k)
        w[k] = project(u.twist[k], gradient, x.twist[k]);
      const Vector3<Number> last = project(u.last, gradient, x.last);
      Number                shear[3];
      for (int k = 0; k < 3; ++k)
        shear[k] = x.linear[k].dot(w[k]);
      Stabilisation<Number> e;
      for (int k = 0; k < 3; ++k)
        {
          const auto [i, j] = following(k);
          const Number ri = axes.inverse_length[i], rj = axes.inverse_length[j], rk = axes.inverse_length[k];
          e.linear[k][0] = x.linear[i].dot(w[j]) * (ri * ri);
          e.linear[k][1] = x.linear[j].dot(w[i]) * (rj * rj);
          e.linear[k][2] = (shear[i] + shear[j]) * (ri * rj);
          e.last[k]      = x.linear[k].dot(last) * (rk * rk);
        }
      return e;
    }

    /// Adds the elastic stress of a strain: plane stress in each of the skew planes. With A the inverse metric of
    /// (t_i, t_j), s = E nu/(1 - nu^2) (A:e) A + 2 G A e A.
    template <class Number>
    [[gnu::always_inline]] inline void add_stress(const Elasticity &elasticity, const Axes<Number> &axes,
                                                  const Stabilisation<Number> &e, Stabilisation<Number> &s)
    {
      const double lambda = elasticity.plate_modulus() * elasticity.poisson, two_g = 2. * elasticity.shear_modulus();
      for (int k = 0; k < 3; ++k)
        {
          const Number c = axes.cosine[k], c2 = c * c, one = 1.;
          const Number a  = one / (one - c2);
          const Number ii = e.linear[k][0], jj = e.linear[k][1], ij = e.linear[k][2]; // ij doubled
          const Number c_ij = c * ij, trace = (lambda * a) * (ii + jj - c_ij), g = two_g * a;
          s.linear[k][0] += a * (trace + g * (ii - c_ij + c2 * jj));
          s.linear[k][1] += a * (trace + g * (jj - c_ij + c2 * ii));
          s.linear[k][2] += a * (g * (0.5 * (one + c2) * ij - c * (ii + jj)) - c * trace);
          s.last[k] += elasticity.young * e.last[k];
        }
    }

    /// Squares of what the stresses are to plastic flow (Pa^2): von Mises stresses, each over what it becomes when the
    /// whole section flows, 3/2 of the yield stress for what is linear (a plastic moment) and 9/4 for the last ones. Of
    /// a plane stress the trace and the rest, which return at different rates.
    template <class Number>
    struct FlowSquares
    {
      Number trace, shear, last;

      [[gnu::always_inline]] FlowSquares(const Axes<Number> &axes, const Stabilisation<Number> &s)
        : trace(Number(0.)), shear(Number(0.)), last(Number(0.))
      {
        for (int k = 0; k < 3; ++k)
          {
            const Number c = axes.cosine[k], ii = s.linear[k][0], jj = s.linear[k][1], ij = s.linear[k][2];
            const Number direct = ii + jj, cij = c * ij, sum = direct + 2. * cij, sum2 = sum * sum;
            const Number square = ii * ii + jj * jj + 2. * (ij * ij + cij * (cij + 2. * direct) + c * c * ii * jj);
            trace += sum2;
            shear += 1.5 * square - 0.75 * sum2;
            last += s.last[k] * s.last[k];
          }
        trace *= 1. / 9.;
        shear *= 4. / 9.;
        last *= 16. / 81.;
      }
    };

    /// Multiplies trace and rest of the plane stresses, and the last ones, by factors.
    template <class Number>
    [[gnu::always_inline]] inline void scale_back(const Axes<Number> &axes, const Number &trace_factor,
                                                  const Number &shear_factor, const Number &last_factor,
                                                  Stabilisation<Number> &s)
    {
      for (int k = 0; k < 3; ++k)
        {
          const Number c = axes.cosine[k], trace = s.linear[k][0] + s.linear[k][1] + 2. * c * s.linear[k][2];
          const Number rest = 0.5 * (trace_factor - shear_factor) * trace / (Number(1.) - c * c);
          s.linear[k][0]    = shear_factor * s.linear[k][0] + rest;
          s.linear[k][1]    = shear_factor * s.linear[k][1] + rest;
          s.linear[k][2]    = shear_factor * s.linear[k][2] - c * rest;
          s.last[k] *= last_factor;
        }
    }

    /// Work per volume of stresses on strains.
    template <class Number>
    [[gnu::always_inline]] inline Number compute_work(const Stabilisation<Number> &s, const Stabilisation<Number> &e)
    {
      Number linear = 0., last = 0.;
      for (int k = 0; k < 3; ++k)
        {
          linear += s.linear[k][0] * e.linear[k][0] + s.linear[k][1] * e.linear[k][1] + s.linear[k][2] * e.linear[k][2];
          last += s.last[k] * e.last[k];
        }
      return (1. / 3.) * linear + (1. / 9.) * last;
    }

    /// The transpose of mean gradient and compute_strains: forces on the modes that do the work V (mean : L) and that
    /// of the stabilisation. Mean stress (Pa): xx, yy, zz, xy, yz, zx.
    template <class Number>
    [[gnu::always_inline]] inline SolidModes<Number>
    compute_mode_forces(const SolidGeometry<Number> &g, const Number (&mean)[6], const Stabilisation<Number> &s)
    {
      const SolidModes<Number> &x = g.x;
      const Axes<Number>        axes(x);
      const Number              third_volume = (1. / 192.) * g.det;
      SolidModes<Number>        f;
      Vector3<Number>           direct[3]; // V/3 a_k/|a_k|^2
      Number                    shear[3];
      for (int k = 0; k < 3; ++k)
        {
          const auto [i, j] = following(k);
          shear[k]          = third_volume * (axes.inverse_length[i] * axes.inverse_length[j]) * s.linear[k][2];
          direct[k]         = third_volume * (axes.inverse_length[k] * axes.inverse_length[k]) * x.linear[k];
        }
      f.last = Number(1. / 3.) * (s.last[0] * direct[0] + s.last[1] * direct[1] + s.last[2] * direct[2]);
      for (int k = 0; k < 3; ++k)
        {
          // w_k is in plane i (whose axes are j, k) as its jj, in plane j (axes k, i) as its ii, in both shears
          const auto [i, j] = following(k);
          f.linear[k]       = Vector3<Number>::Constant(Number(0.));
          f.twist[k] = s.linear[i][0] * direct[j] + s.linear[j][1] * direct[i] + (shear[i] + shear[j]) * x.linear[k];
        }
      const Number    scale = 1. / 64.;
      Matrix3<Number> sum;
      for (int r = 0; r < 3; ++r)
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

    /// The stress that the stabilisation adds at a point, in global axes.
    template <class Number>
    inline Matrix3<Number> compute_stress_at(const SolidModes<Number> &x, const Stabilisation<Number> &s,
                                             const std::array<double, 3> &xi)
    {
      Vector3<Number> t[3];
      for (int k = 0; k < 3; ++k)
        t[k] = x.linear[k] * inverse_root(Number(x.linear[k].dot(x.linear[k])));
      Matrix3<Number> stress = Matrix3<Number>::Zero();
      for (int k = 0; k < 3; ++k)
        {
          const auto [i, j]           = following(k);
          const Matrix3<Number> cross = t[i] * t[j].transpose();
          stress += xi[k] * (s.linear[k][0] * t[i] * t[i].transpose() + s.linear[k][1] * t[j] * t[j].transpose() +
                             s.linear[k][2] * (cross + cross.transpose()));
          stress += (xi[i] * xi[j] * s.last[k]) * t[k] * t[k].transpose();
        }
      return stress;
    }
  } // namespace one_point_solid
} // namespace birdstrike
