#pragma once

#include <birdstrike/blade/solid_one_point.h>
#include <birdstrike/material/elasticity.h>

#include <array>

namespace birdstrike
{
  // The law of the stabilisation of the one-point brick: elastic stress, what plastic flow sees of it, work.
  namespace one_point_solid
  {
    /// Adds the elastic stress of a strain: plane stress in each of the skew planes. With A the inverse metric of
    /// (t_i, t_j), s = E nu/(1 - nu^2) (A:e) A + 2 G A e A.
    template <class Number>
    [[gnu::always_inline]] inline void add_stress(const Elasticity &elasticity, const Axes<Number> &axes,
                                                  const Stabilisation<Number> &e, Stabilisation<Number> &s)
    {
      const double lambda = elasticity.plate_modulus() * elasticity.poisson, two_g = 2. * elasticity.shear_modulus();
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        {
          const Number c = axes.cosine[k], c2 = c * c, one = 1.;
          const Number a  = axes.inverse_sine2[k];
          const Number ii = e.linear[k][0], jj = e.linear[k][1], ij = e.linear[k][2]; // ij doubled
          const Number c_ij = c * ij, trace = (lambda * a) * (ii + jj - c_ij), g = two_g * a;
          s.linear[k][0] += a * (trace + g * (ii - c_ij + c2 * jj));
          s.linear[k][1] += a * (trace + g * (jj - c_ij + c2 * ii));
          s.linear[k][2] += a * (g * (0.5 * (one + c2) * ij - c * (ii + jj)) - c * trace);
          s.last[k] += elasticity.young * e.last[k];
        }
    }

    /// Of a plane stress in a skew plane: the square of its trace and s:s (Pa^2).
    template <class Number>
    struct PlaneSquares
    {
      Number trace, all;

      [[gnu::always_inline]] PlaneSquares(const Number &cosine, const Number (&s)[3])
      {
        const Number &c = cosine, &ii = s[0], &jj = s[1], &ij = s[2];
        const Number  direct = ii + jj, cij = c * ij, sum = direct + 2. * cij;
        trace = sum * sum;
        all   = ii * ii + jj * jj + 2. * (ij * ij + cij * (cij + 2. * direct) + c * c * ii * jj);
      }
    };

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
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k)
          {
            const PlaneSquares<Number> plane(axes.cosine[k], s.linear[k]);
            trace += plane.trace;
            shear += 1.5 * plane.all - 0.75 * plane.trace;
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
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        {
          const Number c = axes.cosine[k], trace = s.linear[k][0] + s.linear[k][1] + 2. * c * s.linear[k][2];
          const Number rest = 0.5 * (trace_factor - shear_factor) * trace * axes.inverse_sine2[k];
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
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        {
          linear += s.linear[k][0] * e.linear[k][0] + s.linear[k][1] * e.linear[k][1] + s.linear[k][2] * e.linear[k][2];
          last += s.last[k] * e.last[k];
        }
      return (1. / 3.) * linear + (1. / 9.) * last;
    }

    /// Elastic energy per volume: plane stress in each of the skew planes, uniaxial stress of the last modes.
    template <class Number>
    [[gnu::always_inline]] inline Number compute_energy(const Elasticity &elasticity, const Axes<Number> &axes,
                                                        const Stabilisation<Number> &s)
    {
      Number linear = 0., last = 0.;
      for (int k = 0; k < 3; ++k)
        {
          const PlaneSquares<Number> plane(axes.cosine[k], s.linear[k]);
          linear += (1. + elasticity.poisson) * plane.all - elasticity.poisson * plane.trace;
          last += s.last[k] * s.last[k];
        }
      return (0.5 / elasticity.young) * ((1. / 3.) * linear + (1. / 9.) * last);
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
