#pragma once

#include <birdstrike/core/number.h>

namespace birdstrike
{
  /// The four modes of a quadrilateral with corners (xi, eta) = (-1,-1), (1,-1), (1,1), (-1,1):
  ///   f = f0 + xi f1 + eta f2 + xi eta f3.
  /// The mode vectors (1, xi, eta, xi eta) at the corners are orthogonal with square 4; hence sum_i g_i . f_i of
  /// forces g_i = 1/4 (G0 + xi G1 + eta G2 + xi eta G3) is G0.f0 + ... + G3.f3.
  template <class Number>
  struct ShellModes
  {
    Vector3<Number> m0, m1, m2, m3;

    static ShellModes of_corners(const Vector3<Number> (&f)[4])
    {
      const Number          quarter = 0.25;
      const Vector3<Number> a = f[0] + f[2], b = f[1] + f[3], c = f[2] - f[0], d = f[1] - f[3];
      return {quarter * (a + b), quarter * (c + d), quarter * (c - d), quarter * (a - b)};
    }

    /// 1/4 of the sum of the modes at every corner
    void corner_shares(Vector3<Number> (&f)[4]) const
    {
      const Number          quarter = 0.25;
      const Vector3<Number> a = quarter * (m0 + m3), b = quarter * (m0 - m3), c = quarter * (m1 + m2),
                            d = quarter * (m1 - m2);
      f[0]                    = a - c;
      f[1]                    = b + d;
      f[2]                    = a + c;
      f[3]                    = b - d;
    }
  };

  /// Geometry of a one-point shell element: bilinear surface x(xi, eta), director field d(xi, eta), frame at the
  /// centre.
  ///
  /// x.m1, x.m2 are the covariant base vectors a1, a2 at the centre; a3 = x.m3 = alpha a1 + beta a2 + warp e3. The
  /// frame has e3 normal to a1 and a2, and e1, e2 symmetric about them, so that it turns with the mean of the two
  /// directions. (c1x, c1y), (c2x, c2y) are the contravariant base vectors in (e1, e2). Area = 4 |a1 x a2|, exact for a
  /// plane element.
  template <class Number>
  struct ShellGeometry
  {
    ShellModes<Number> x;           ///< m
    Vector3<Number>    director[4]; ///< -, n/(n.e3) of the averaged nodal normals n
    ShellModes<Number> d;           ///< of the directors
    Vector3<Number>    e1, e2, e3;
    Number             area; ///< m^2
    Number             c1x, c1y, c2x, c2y;
    Number             alpha, beta, warp;
    Vector3<Number>    d_gamma; ///< d3 - alpha d1 - beta d2

    static ShellGeometry of_corners(const Vector3<Number> (&corner)[4], const Vector3<Number> (&normal)[4])
    {
      ShellGeometry g;
      g.x                      = ShellModes<Number>::of_corners(corner);
      const Vector3<Number> a1 = g.x.m1, a2 = g.x.m2, a3 = g.x.m3;
      const Vector3<Number> normal_vector = a1.cross(a2);
      const Number          det           = sqrt(normal_vector.dot(normal_vector));
      g.area                              = 4. * det;
      g.e3                                = normal_vector * (Number(1.) / det);
      // four reciprocals with one division
      const Number least = 0.1;
      const Number h0 = max(Number(normal[0].dot(g.e3)), least), h1 = max(Number(normal[1].dot(g.e3)), least);
      const Number h2 = max(Number(normal[2].dot(g.e3)), least), h3 = max(Number(normal[3].dot(g.e3)), least);
      const Number h01 = h0 * h1, h23 = h2 * h3, product = Number(1.) / (h01 * h23);
      g.director[0]             = normal[0] * (product * h1 * h23);
      g.director[1]             = normal[1] * (product * h0 * h23);
      g.director[2]             = normal[2] * (product * h3 * h01);
      g.director[3]             = normal[3] * (product * h2 * h01);
      g.d                       = ShellModes<Number>::of_corners(g.director);
      const Vector3<Number> s1  = a1 * (Number(1.) / sqrt(a1.dot(a1)));
      const Vector3<Number> s2  = a2 * (Number(1.) / sqrt(a2.dot(a2)));
      const Vector3<Number> sum = s1 + s2, difference = s1 - s2;
      const Vector3<Number> s = sum * (Number(1.) / sqrt(2. * sum.dot(sum)));
      const Vector3<Number> t = difference * (Number(1.) / sqrt(2. * difference.dot(difference)));
      g.e1                    = s + t;
      g.e2                    = s - t;
      const Number inverse    = Number(1.) / det;
      g.c1x                   = a2.dot(g.e2) * inverse;
      g.c1y                   = -a2.dot(g.e1) * inverse;
      g.c2x                   = -a1.dot(g.e2) * inverse;
      g.c2y                   = a1.dot(g.e1) * inverse;
      const Number a3x = a3.dot(g.e1), a3y = a3.dot(g.e2);
      g.alpha   = g.c1x * a3x + g.c1y * a3y;
      g.beta    = g.c2x * a3x + g.c2y * a3y;
      g.warp    = a3.dot(g.e3);
      g.d_gamma = g.d.m3 - g.alpha * g.d.m1 - g.beta * g.d.m2;
      return g;
    }
  };
} // namespace birdstrike
