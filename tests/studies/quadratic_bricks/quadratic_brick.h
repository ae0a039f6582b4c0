#pragma once

#include "quadratic_fields.h"

namespace birdstrike::studies
{
  /// Triquadratic brick of 27 nodes (-1, 0, 1)^3, the first coordinate running fastest: sum-factorised gradients at the
  /// points of a product rule (Orszag 1980), with `in_plane` along the first two directions and `across` along the
  /// third.
  ///
  /// As in the bricks of the program strains are taken on the midpoint geometry x - u/2 and forces on the end geometry
  /// x. Fields are contracted along the first direction for one station at a time, along the second for one column of
  /// points, along the third at the point: what is kept between fits the first-level cache (27 kB with 8 lanes).
  template <class Number, auto &in_plane, auto &across>
  class QuadraticBrick
  {
  public:
    using Fields                  = QuadraticFields<Number, in_plane, across>;
    using Station                 = typename Fields::Station;
    using Column                  = typename Fields::Column;
    using Derivatives             = typename Fields::Derivatives;
    using Vector                  = Vector3<Number>;
    static constexpr int n_points = in_plane.n * in_plane.n * across.n;
    using Nodes                   = Vector3<Number>[27];

    /// Adds -f_int to `force`. `law(gradient, q, weight)` returns the stress (xx, yy, zz, xy, yz, zx) at point q after
    /// the increment whose midpoint gradient is given; `weight` is the volume there at midpoint. Returns the smallest
    /// Jacobian determinant.
    template <class Law>
    [[gnu::always_inline]] static Number add_forces(const Nodes &x, const Nodes &u, const Law &law, Nodes &force)
    {
      Number smallest = 1e300;
      for (int i = 0; i < in_plane.n; ++i)
        {
          Station xs(x, i), us(u, i), fs;
          for (int j = 0; j < in_plane.n; ++j)
            {
              const Column xc(xs, j), uc(us, j);
              Column       fc;
              const double weight = in_plane.weight[i] * in_plane.weight[j];
              for (int k = 0; k < across.n; ++k)
                {
                  const int    q  = (i * in_plane.n + j) * across.n + k;
                  const Number at = add_point(xc.at(k), uc.at(k), weight * across.weight[k], q, law, k, fc);
                  smallest        = min(smallest, at);
                }
              fs.add(fc, j);
            }
          fs.add_to_nodes(i, force);
        }
      return smallest;
    }

    /// Two points a direction in the plane see nothing of (xi^2 - 1/3)(eta^2 - 1/3), a motion that neighbours share.
    /// This adds the forces of springs on it at the three stations across, `stiffness` on the sum q over its nodes of
    /// (1, -2, 1) (1, -2, 1) u, that is on four times the coefficient of xi^2 eta^2 in the displacement: zero in any
    /// rigid motion for a brick that was a parallelepiped with nodes midway; others would have to turn a q of their
    /// own. The complete quadratic fields lack this term and feel nothing: the element becomes one of Serendipity, or
    /// in bending Hughes & Cohen's (1978) heterosis element, as the springs get stiff. `q` is updated.
    [[gnu::always_inline]] static void add_stabilisation(const Nodes &u, const Number   &stiffness,
                                                         Vector3<Number> (&q)[3], Nodes &force)
    {
      constexpr double gamma[3] = {1., -2., 1.};
      for (int c = 0; c < 3; ++c)
        {
          for (int n = 0; n < 9; ++n)
            q[c] += Number(gamma[n % 3] * gamma[n / 3]) * u[9 * c + n];
          const Vector f = Number(c == 1 ? -2. / 3. : -1. / 6.) * stiffness * q[c];
          for (int n = 0; n < 9; ++n)
            force[9 * c + n] += Number(gamma[n % 3] * gamma[n / 3]) * f;
        }
    }

  private:
    /// Inverse transpose of the Jacobian, times the determinant.
    struct Cofactors
    {
      Vector row[3];
      Number det;

      [[gnu::always_inline]] explicit Cofactors(const Derivatives &x)
      {
        for (int k = 0; k < 3; ++k)
          row[k] = x.d[(k + 1) % 3].cross(x.d[(k + 2) % 3]);
        det = x.d[0].dot(row[0]);
      }
    };

    template <class Law>
    [[gnu::always_inline]] static Number add_point(const Derivatives &x, const Derivatives &u, const double weight,
                                                   const int q, const Law &law, const int k, Column &force)
    {
      Derivatives middle;
      for (int d = 0; d < 3; ++d)
        middle.d[d] = x.d[d] - Number(0.5) * u.d[d];
      const Cofactors end(x), m(middle);
      const Number    inverse = Number(1.) / m.det;
      Matrix3<Number> gradient;
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
          gradient(r, c) = inverse * (u.d[0][r] * m.row[0][c] + u.d[1][r] * m.row[1][c] + u.d[2][r] * m.row[2][c]);
      const auto  s = law(gradient, q, Number(weight * m.det));
      Derivatives f;
      for (int d = 0; d < 3; ++d)
        {
          const Vector n = Number(-weight) * end.row[d];
          f.d[d] << s[0] * n[0] + s[3] * n[1] + s[5] * n[2], s[3] * n[0] + s[1] * n[1] + s[4] * n[2],
            s[5] * n[0] + s[4] * n[1] + s[2] * n[2];
        }
      force.add(f, k);
      return end.det;
    }
  };
} // namespace birdstrike::studies
