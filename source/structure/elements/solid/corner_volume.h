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
  /// as q vanishes, and the bound on the step knows its stiffness, also of corners that come below q_0 within the next
  /// step at the present rate, and lets no corner lose more than half of its share in it. So only a node that crosses
  /// most of a brick within one step turns a corner, and such a run ends in words.
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

    /// x + s u.
    template <class Number>
    inline SolidModes<Number> move(const SolidModes<Number> &x, const Number &s, const SolidModes<Number> &u)
    {
      SolidModes<Number> moved;
      for (int k = 0; k < 3; ++k)
        {
          moved.linear[k] = x.linear[k] + s * u.linear[k];
          moved.twist[k]  = x.twist[k] + s * u.twist[k];
        }
      moved.last = x.last + s * u.last;
      return moved;
    }

    /// The largest share of what is left at a corner that the displacement `u` (m, modes) has taken of it; of those
    /// that had volume at rest.
    template <class Number>
    inline Number largest_loss(const SolidGeometry<Number> &g, const SolidModes<Number> &u, const Shares<Number> &rest)
    {
      const SolidModes<Number>    before = move(g.x, Number(-1.), u);
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
      Number             energy = Number(0.);

      /// `rest` are the shares at rest, `scale` = K V_0/8 (J).
      Pressure(const SolidGeometry<Number> &g, const Shares<Number> &rest, const Number &scale) : scale(scale)
      {
        const auto none = Vector3<Number>::Constant(Number(0.));
        for (int k = 0; k < 3; ++k)
          force.linear[k] = force.twist[k] = none;
        force.last = none;
        Number sum = 0.;
        for (int c = 0; c < 8; ++c)
          add(Corner(g, c, rest.of[c]), sum);
        // of the volume D: d ln D is the trace of the mean gradient
        const Matrix3<Number> of_mean = Vector3<Number>::Constant(Number(sum * scale * g.inverse_det)).asDiagonal();
        g.add_mean_forces(of_mean, force);
      }

      /// The bound at the displacement `ahead` times `u` (m, modes) from here, which may take half of a corner's share:
      /// what the next step meets is in it before it is met. (A corner that comes below q_0 within a step that does not
      /// know finds all of K at once.)
      Number stiffness(const SolidGeometry<Number> &g, const Number &ahead, const SolidModes<Number> &u,
                       const Shares<Number> &rest) const
      {
        const SolidModes<Number>    x = move(g.x, ahead, u);
        const SolidGeometry<Number> g_next(x);
        const Shares<Number>        next(g_next);
        Number                      sum = 0.;
        for (int c = 0; c < 8; ++c)
          {
            const Corner at(g, c, rest.of[c]);
            const Number share   = min(at.share, max(next.of[c], Number(0.5 * at.share)));
            const auto   is_near = (at.limit > Number(0.)) && (share < at.limit);
            if (!any(is_near))
              continue;
            const Number excess = log(select(is_near, Number(at.limit / share), Number(1.)));
            const Number growth = select(is_near, Number(at.share / share), Number(1.));
            sum += select(is_near, Number(1.5 * scale * (1. + excess) * at.gradient2() * growth * growth), Number(0.));
          }
        return sum;
      }

    private:
      Number scale;

      struct Corner
      {
        Derivative<Number> of;
        Vector3<Number>    area[3];
        Number             det, share, limit;

        Corner(const SolidGeometry<Number> &g, const int corner, const Number &rest)
          : of(g.x, corner)
          , area{of.edge[1].cross(of.edge[2]), of.edge[2].cross(of.edge[0]), of.edge[0].cross(of.edge[1])}
          , det(of.edge[0].dot(area[0]))
          , share(det * g.inverse_det)
          , limit(least_share * rest)
        {
        }
        /// Of ln det A_c in the displacements of the nodes, its square (1/m^2); 16: an edge is a quarter of A_k, and
        /// one end of it moves A_k by four times its way.
        Number gradient2() const
        {
          Vector3<Number> at_corner = Vector3<Number>::Constant(Number(0.));
          Number          squares   = 0.;
          for (int k = 0; k < 3; ++k)
            {
              at_corner += of.xi[k] * area[k];
              squares += area[k].dot(area[k]);
            }
          return 16. * (squares + Number(at_corner.dot(at_corner))) / (det * det);
        }
      };

      /// A corner that had no volume at rest is left alone: its limit is no more than 0.
      void add(const Corner &at, Number &sum)
      {
        const auto is_short = (at.limit > Number(0.)) && (at.share < at.limit);
        if (!any(is_short))
          return;
        const Number excess = log(select(is_short, Number(at.limit / at.share), Number(1.))); // turned: no number
        const Number push   = -scale * excess / select(is_short, at.det, Number(1.));
        energy += 0.5 * scale * excess * excess;
        sum += excess;
        for (int k = 0; k < 3; ++k)
          {
            const auto [i, j]         = following(k);
            const Vector3<Number> one = push * at.area[k];
            force.linear[k] += one;
            force.twist[i] += at.of.xi[j] * one;
            force.twist[j] += at.of.xi[i] * one;
            force.last += Number(at.of.xi[i] * at.of.xi[j]) * one;
          }
      }
    };
  } // namespace corner_volume
} // namespace birdstrike
