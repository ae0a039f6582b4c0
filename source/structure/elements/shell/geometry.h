#pragma once

#include <birdstrike/core/simd/inverse_root.h>

namespace birdstrike
{
  /// The four modes of a quadrilateral with corners (xi, eta) = (-1,-1), (1,-1), (1,1), (-1,1), times four:
  ///   4 f = f0 + xi f1 + eta f2 + xi eta f3.
  /// The mode vectors (1, xi, eta, xi eta) at the corners are orthogonal with square 4; hence sum_i g_i . f_i of
  /// forces g_i = G0 + xi G1 + eta G2 + xi eta G3 is G0.f0 + ... + G3.f3. Without the quarter neither way takes a
  /// multiplication.
  template <class Number>
  struct ShellModes
  {
    Vector3<Number> m0, m1, m2, m3;

    [[gnu::always_inline]] static ShellModes of_corners(const Vector3<Number> (&f)[4])
    {
      const Vector3<Number> a = f[0] + f[2], b = f[1] + f[3], c = f[2] - f[0], d = f[1] - f[3];
      return {a + b, c + d, c - d, a - b};
    }

    /// The sum of the modes at every corner.
    [[gnu::always_inline]] void sum_at_corners(Vector3<Number> (&f)[4]) const
    {
      const Vector3<Number> a = m0 + m3, b = m0 - m3, c = m1 + m2, d = m1 - m2;
      f[0] = a - c;
      f[1] = b + d;
      f[2] = a + c;
      f[3] = b - d;
    }
  };

  /// Geometry of a one-point shell element: bilinear surface x(xi, eta), director field d(xi, eta), frame at the
  /// centre.
  ///
  /// x.m1, x.m2 are the covariant base vectors a1, a2 at the centre, of coordinates in [-1/4, 1/4]; a3 = x.m3 = alpha
  /// a1 + beta a2 + warp e3. The frame has e3 normal to a1 and a2, and e1, e2 symmetric about them, so that it turns
  /// with the mean of the two directions: a1 = |a1| (C, S), a2 = |a2| (S, C), 2 C S = c the cosine between them, C^2 -
  /// S^2 its sine. With the contravariant base vectors (c1x, c1y), (c2x, c2y) in (e1, e2) four inverse roots and one
  /// division are all that this takes; e1 = c1x a1 + c2x a2 and e2 = c1y a1 + c2y a2 are made only where they are
  /// needed. Area = |a1 x a2|/4, exact for a plane element.
  template <class Number>
  struct ShellGeometry
  {
    ShellModes<Number> x;           ///< m
    Vector3<Number>    director[4]; ///< -, n/(n.e3) of the nodes' unit directors n
    ShellModes<Number> d;           ///< of the directors
    Vector3<Number>    e3;
    Number             area;          ///< m^2
    Number             inverse_det;   ///< 1/|a1 x a2| = 1/(4 area), 1/m^2
    Number             a11, a22, a12; ///< covariant metric, m^2
    Number             g11, g22;      ///< contravariant metric, 1/m^2
    Number             g1, g2;        ///< lengths of the contravariant base vectors, 1/m
    Number             l1, l2;        ///< 1/a11, 1/a22
    Number             c1x, c1y, c2x, c2y;
    Number             alpha, beta, warp;
    Vector3<Number>    d_gamma; ///< d3 - alpha d1 - beta d2

    static ShellGeometry of_corners(const Vector3<Number> (&corner)[4], const Vector3<Number> (&normal)[4])
    {
      return of_modes(ShellModes<Number>::of_corners(corner), normal);
    }

    [[gnu::always_inline]] static ShellGeometry of_modes(const ShellModes<Number> &x,
                                                         const Vector3<Number> (&normal)[4])
    {
      ShellGeometry g;
      g.x                       = x;
      const Vector3<Number> &a1 = g.x.m1, &a2 = g.x.m2, &a3 = g.x.m3;
      const Vector3<Number>  normal_vector = a1.cross(a2);
      const Number           square        = normal_vector.dot(normal_vector);
      const Number           inverse       = inverse_root(square); // 1/|a1 x a2|
      const Number           det           = square * inverse;
      g.area                               = 0.25 * det;
      g.inverse_det                        = inverse;
      g.e3                                 = normal_vector * inverse;
      g.a11                                = a1.dot(a1);
      g.a22                                = a2.dot(a2);
      g.a12                                = a1.dot(a2);
      const Number r1 = inverse_root(g.a11), r2 = inverse_root(g.a22), r12 = r1 * r2;
      const Number half = 0.5, one_c = Number(1.) + g.a12 * r12, root = inverse_root(one_c);
      const Number p = half * one_c * root, q = half * (det * r12) * root; // half sqrt(1 + c), half sqrt(1 - c)
      g.l1             = r1 * r1;
      g.l2             = r2 * r2;
      g.g1             = g.a22 * r2 * inverse;
      g.g2             = g.a11 * r1 * inverse;
      g.g11            = g.g1 * g.g1;
      g.g22            = g.g2 * g.g2;
      g.c1x            = g.g1 * (p + q);
      g.c1y            = g.g1 * (q - p);
      g.c2x            = g.g2 * (q - p);
      g.c2y            = g.g2 * (p + q);
      const Number g12 = -(inverse * inverse) * g.a12;
      const Number a31 = a3.dot(a1), a32 = a3.dot(a2);
      g.alpha = g.g11 * a31 + g12 * a32;
      g.beta  = g12 * a31 + g.g22 * a32;
      g.warp  = a3.dot(g.e3);
      g.set_directors(normal);
      return g;
    }

    Vector3<Number> compute_e1() const
    {
      return c1x * x.m1 + c2x * x.m2;
    }
    Vector3<Number> compute_e2() const
    {
      return c1y * x.m1 + c2y * x.m2;
    }

  private:
    [[gnu::always_inline]] void set_directors(const Vector3<Number> (&normal)[4])
    {
      // four reciprocals with one division
      const Number least = 0.1;
      const Number h0 = max(Number(normal[0].dot(e3)), least), h1 = max(Number(normal[1].dot(e3)), least);
      const Number h2 = max(Number(normal[2].dot(e3)), least), h3 = max(Number(normal[3].dot(e3)), least);
      const Number h01 = h0 * h1, h23 = h2 * h3, product = Number(1.) / (h01 * h23);
      const Number p01 = product * h23, p23 = product * h01;
      director[0] = normal[0] * (p01 * h1);
      director[1] = normal[1] * (p01 * h0);
      director[2] = normal[2] * (p23 * h3);
      director[3] = normal[3] * (p23 * h2);
      d           = ShellModes<Number>::of_corners(director);
      d_gamma     = d.m3 - alpha * d.m1 - beta * d.m2;
    }
  };

  /// Whether an element looks the way its nodes' directors, averaged normals at rest, do on the mean. One that is
  /// turned inside out in its plane, amid others, does not, while its area, of a normal of its own, is positive again.
  template <class Number>
  [[gnu::always_inline]] inline auto looks_along(const Vector3<Number> (&normal)[4], const Vector3<Number> &e3)
  {
    const Vector3<Number> sum = (normal[0] + normal[1]) + (normal[2] + normal[3]);
    return sum.dot(e3) > Number(0.);
  }
} // namespace birdstrike
