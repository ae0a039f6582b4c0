#pragma once

#include "structure/elements/solid/one_point.h"
#include <birdstrike/material/elasticity.h>

#include <array>

namespace birdstrike
{
  // The law of the stabilisation of the one-point brick: elastic stress, what plastic flow sees of it, work.
  namespace one_point_solid
  {
    /// Adds the elastic stress of a strain: plane stress in each of the planes.
    template <class Number>
    [[gnu::always_inline]] inline void add_stress(const Elasticity &elasticity, const Stabilisation<Number> &e,
                                                  Stabilisation<Number> &s)
    {
      const double young = elasticity.young, g = elasticity.shear_modulus(),
                   two_area = 2. * young / (1. - elasticity.poisson);
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        {
          s.linear[k][0] += two_area * e.linear[k][0];
          s.linear[k][1] += (4. * g) * e.linear[k][1];
          s.linear[k][2] += g * e.linear[k][2];
          s.last[k] += young * e.last[k];
        }
    }

    /// Of a plane stress: the square of its trace and s:s (Pa^2).
    template <class Number>
    struct PlaneSquares
    {
      Number trace, all;

      [[gnu::always_inline]] PlaneSquares(const Number (&s)[3])
        : trace(s[0] * s[0]), all(0.5 * (trace + s[1] * s[1]) + 2. * (s[2] * s[2]))
      {
      }
    };

    /// Squares of what the stresses are to plastic flow (Pa^2): von Mises stresses, each over what it becomes when the
    /// whole section flows, 3/2 of the yield stress for what is linear (a plastic moment) and 9/4 for the last ones. Of
    /// a plane stress the trace and the rest, which return at different rates.
    template <class Number>
    struct FlowSquares
    {
      Number trace, shear, last;

      [[gnu::always_inline]] explicit FlowSquares(const Stabilisation<Number> &s)
        : trace(Number(0.)), shear(Number(0.)), last(Number(0.))
      {
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k)
          {
            trace += s.linear[k][0] * s.linear[k][0];
            shear += 0.75 * (s.linear[k][1] * s.linear[k][1]) + 3. * (s.linear[k][2] * s.linear[k][2]);
            last += s.last[k] * s.last[k];
          }
        trace *= 1. / 9.;
        shear *= 4. / 9.;
        last *= 16. / 81.;
      }
    };

    /// Multiplies trace and rest of the plane stresses, and the last ones, by factors.
    template <class Number>
    [[gnu::always_inline]] inline void scale_back(const Number &trace_factor, const Number &shear_factor,
                                                  const Number &last_factor, Stabilisation<Number> &s)
    {
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        {
          s.linear[k][0] *= trace_factor;
          s.linear[k][1] *= shear_factor;
          s.linear[k][2] *= shear_factor;
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

    /// Elastic energy per volume: plane stress in each of the planes, uniaxial stress of the last modes.
    template <class Number>
    [[gnu::always_inline]] inline Number compute_energy(const Elasticity &elasticity, const Stabilisation<Number> &s)
    {
      Number linear = 0., last = 0.;
      for (int k = 0; k < 3; ++k)
        {
          const PlaneSquares<Number> plane(s.linear[k]);
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
      const Axes<Number> axes(x);
      Vector3<Number>    t[3];
      for (int k = 0; k < 3; ++k)
        t[k] = x.linear[k] * axes.inverse_length[k];
      Matrix3<Number> stress = Matrix3<Number>::Zero();
      for (int k = 0; k < 3; ++k)
        {
          const auto [i, j]           = following(k);
          const Matrix3<Number> cross = t[i] * t[j].transpose();
          Number                skew[3];
          turn_out(axes, k, s.linear[k], skew);
          stress += xi[k] * (skew[0] * t[i] * t[i].transpose() + skew[1] * t[j] * t[j].transpose() +
                             skew[2] * (cross + cross.transpose()));
          stress += (xi[i] * xi[j] * s.last[k]) * t[k] * t[k].transpose();
        }
      return stress;
    }
  } // namespace one_point_solid
} // namespace birdstrike
