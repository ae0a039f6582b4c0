#pragma once

#include "structure/elements/solid/geometry.h"

namespace birdstrike
{
  /// Volume at the corners of a brick.
  ///
  /// On its way to no volume a corner meets a finite energy of the stabilisation, or of the nearest integration points,
  /// and next to none once the brick flows. Metal has its bulk modulus K there, whether it flows or not: what varies of
  /// the volume within the element is left out of bricks so that they do not lock. Without it corners turned inside
  /// out in silence, and with them the facets that contact sees. So a corner that has lost most of its share of the
  /// volume has a pressure of its own, as the subzones of Caramana & Shashkov (J. Comput. Phys. 142, 521, 1998):
  ///   W = V_0/8 K sum_c <ln(q_0/q_c)>^2/2,   q_c = (det A_c/D)/(the same at rest),
  /// over the corners with q_c < q_0; A_c is the derivative of the position there, A_k = linear_k + xi_j twist_i + xi_i
  /// twist_j + xi_i xi_j last (times eight), D that of SolidGeometry. It is a potential of the present shape: forces
  /// are its derivative, what it takes it gives back, they have neither sum nor moment. Rigid motions, any uniform
  /// deformation and all that bends or twists a corner less than to the share q_0 meet nothing. It grows without bound
  /// as q vanishes, and the bound on the step knows its stiffness and lets no corner lose more than half of its share
  /// in the next step at the present rate. So only a node that crosses most of a brick within one step turns a corner,
  /// and such a run ends in words.
  namespace corner_volume
  {
    constexpr double least_share = 0.2; ///< q_0: a strain of -0.8 along one axis between the middle and the corner

    /// At a corner, whose coordinates -1, 1 are the bits of its number; times eight.
    template <class Number>
    struct Derivative
    {
      Number          xi[3];
      Vector3<Number> edge[3];

      [[gnu::always_inline]] Derivative(const SolidModes<Number> &x, const int corner)
      {
        for (int k = 0; k < 3; ++k)
          xi[k] = Number((corner >> k & 1) != 0 ? 1. : -1.);
        for (int k = 0; k < 3; ++k)
          {
            const auto [i, j] = following(k);
            edge[k]           = x.linear[k] + xi[j] * x.twist[i] + xi[i] * x.twist[j] + Number(xi[i] * xi[j]) * x.last;
          }
      }

      [[gnu::always_inline]] Number determinant() const
      {
        return edge[0].dot(edge[1].cross(edge[2]));
      }
    };

    /// det A_c/D of all corners.
    template <class Number>
    struct Shares
    {
      Number of[8];

      explicit Shares(const SolidGeometry<Number> &g)
      {
        for (int c = 0; c < 8; ++c)
          of[c] = Derivative<Number>(g.x, c).determinant() * g.inverse_det;
      }
      Number largest() const
      {
        Number most = of[0];
        for (const Number &share : of)
          most = max(most, share);
        return most;
      }
      Number smallest() const
      {
        Number least = of[0];
        for (const Number &share : of)
          least = min(least, share);
        return least;
      }
    };

    /// The largest share of what is left at a corner that the displacement `u` (m, modes) has taken of it; of those
    /// that had volume at rest.
    template <class Number>
    inline Number largest_loss(const SolidGeometry<Number> &g, const SolidModes<Number> &u, const Shares<Number> &rest)
    {
      SolidModes<Number> before;
      for (int k = 0; k < 3; ++k)
        {
          before.linear[k] = g.x.linear[k] - u.linear[k];
          before.twist[k]  = g.x.twist[k] - u.twist[k];
        }
      before.last = g.x.last - u.last;
      const SolidGeometry<Number> g_before(before);
      const Shares<Number>        now(g), then(g_before);
      Number                      most = Number(0.);
      for (int c = 0; c < 8; ++c)
        most = max(most, select(rest.of[c] > Number(0.), Number(then.of[c] / now.of[c] - 1.), Number(0.)));
      return most;
    }

    /// The distortion (compute_frequency_bound) up to which no corner of a brick has less than q_0 of its share.
    ///
    /// In the frame of the linear modes A_c is 1 + E, and with the components n_m of twist and last modes there the
    /// square of Frobenius' norm is
    ///   e^2 = sum_k |n_i + n_j + n_last|^2 <= 9 sum_m n_m^2 = 9 distortion,
    /// but for terms of higher order, for which the result is halved; det(1 + E) >= (1 - e/sqrt(3))^3 for e < sqrt(3).
    /// `largest` of the shares at rest.
    inline double undistorted(const double largest)
    {
      const double root = std::cbrt(least_share * largest);
      return root < 1. ? (1. - root) * (1. - root) / 6. : 0.;
    }

    /// Forces on the modes whose power is the rate of W, W itself (J) and a bound on the eigenvalues of its Hessian in
    /// the displacements of the nodes (N/m).
    template <class Number>
    struct Pressure
    {
      SolidModes<Number> force;
      Number             energy = Number(0.), stiffness = Number(0.);

      /// `rest` are the shares at rest, `scale` = K V_0/8 (J).
      Pressure(const SolidGeometry<Number> &g, const Shares<Number> &rest, const Number &scale)
      {
        const auto none = Vector3<Number>::Constant(Number(0.));
        for (int k = 0; k < 3; ++k)
          force.linear[k] = force.twist[k] = none;
        force.last = none;
        Number sum = 0.;
        for (int c = 0; c < 8; ++c)
          add(Derivative<Number>(g.x, c), g, rest.of[c], scale, sum);
        // of the volume D: d ln D is the trace of the mean gradient
        const Matrix3<Number> of_mean = Vector3<Number>::Constant(Number(sum * scale * g.inverse_det)).asDiagonal();
        g.add_mean_forces(of_mean, force);
      }

    private:
      /// A corner that had no volume at rest is left alone.
      void add(const Derivative<Number> &at, const SolidGeometry<Number> &g, const Number &rest, const Number &scale,
               Number &sum)
      {
        const Vector3<Number> area[3] = {at.edge[1].cross(at.edge[2]), at.edge[2].cross(at.edge[0]),
                                         at.edge[0].cross(at.edge[1])};
        const Number          det = at.edge[0].dot(area[0]), share = det * g.inverse_det, limit = least_share * rest;
        const auto            is_short = (rest > Number(0.)) && (share < limit);
        if (!any(is_short))
          return;
        const Number excess  = log(select(is_short, Number(limit / share), Number(1.))); // turned inside out: no number
        const Number inverse = Number(1.) / select(is_short, det, Number(1.)), push = -scale * excess * inverse;
        energy += 0.5 * scale * excess * excess;
        sum += excess;
        Vector3<Number> at_corner = Vector3<Number>::Constant(Number(0.));
        Number          squares   = 0.;
        for (int k = 0; k < 3; ++k)
          {
            const auto [i, j]         = following(k);
            const Vector3<Number> one = push * area[k];
            force.linear[k] += one;
            force.twist[i] += at.xi[j] * one;
            force.twist[j] += at.xi[i] * one;
            force.last += Number(at.xi[i] * at.xi[j]) * one;
            at_corner += at.xi[k] * area[k];
            squares += area[k].dot(area[k]);
          }
        // 16: an edge is a quarter of A_k, and one end of it moves A_k by four times its way
        const Number gradient2 = 16. * (squares + Number(at_corner.dot(at_corner))) * inverse * inverse;
        stiffness += select(is_short, 1.5 * scale * (1. + excess) * gradient2, Number(0.));
      }
    };
  } // namespace corner_volume
} // namespace birdstrike
