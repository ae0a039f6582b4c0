#pragma once

#include "rules.h"

#include <birdstrike/core/number.h>

namespace birdstrike::studies
{
  /// What is kept of a triquadratic vector field between the sums of its sum-factorised gradient: along the first
  /// direction for one station of points at a time, along the second for one column, along the third at the point. The
  /// same backwards, with `add`, for forces. Where the points are the nodes, values are copies.
  template <class Number, auto &in_plane, auto &across>
  struct QuadraticFields
  {
    using Vector = Vector3<Number>;
    using Nodes  = Vector[27];

    [[gnu::always_inline]] static Vector zero()
    {
      return Vector::Constant(Number(0.));
    }
    [[gnu::always_inline]] static Vector combine(const std::array<double, 3> &c, const Vector &a, const Vector &b,
                                                 const Vector &d)
    {
      return Number(c[0]) * a + Number(c[1]) * b + Number(c[2]) * d;
    }

    /// The field at point q of a rule, of its three nodes in a row.
    template <auto &rule>
    [[gnu::always_inline]] static Vector interpolate(const Vector *f, const int q)
    {
      if constexpr (rule.is_collocated)
        return f[q];
      else
        return combine(rule.value[q], f[0], f[1], f[2]);
    }
    /// The transpose.
    template <auto &rule>
    [[gnu::always_inline]] static void spread(const Vector &a, const int q, Vector *f)
    {
      if constexpr (rule.is_collocated)
        f[q] += a;
      else
        for (int n = 0; n < 3; ++n)
          f[n] += Number(rule.value[q][n]) * a;
    }

    /// The three derivatives of a field by the natural coordinates.
    struct Derivatives
    {
      Vector d[3];
    };

    /// At one station of the first coordinate: the field and its slope there, at the nodes of the others.
    struct Station
    {
      Vector value[9], slope[9];

      [[gnu::always_inline]] Station()
      {
        for (int n = 0; n < 9; ++n)
          value[n] = slope[n] = zero();
      }
      [[gnu::always_inline]] Station(const Nodes &f, const int i)
      {
        for (int n = 0; n < 9; ++n)
          {
            const Vector *g = f + 3 * n;
            value[n]        = interpolate<in_plane>(g, i);
            slope[n]        = combine(in_plane.slope[i], g[0], g[1], g[2]);
          }
      }
      template <class Part>
      [[gnu::always_inline]] void add(const Part &column, const int j)
      {
        for (int c = 0; c < 3; ++c)
          {
            spread<in_plane>(column.value[c], j, value + 3 * c);
            spread<in_plane>(column.first[c], j, slope + 3 * c);
            for (int b = 0; b < 3; ++b)
              value[3 * c + b] += Number(in_plane.slope[j][b]) * column.second[c];
          }
      }
      [[gnu::always_inline]] void add_to_nodes(const int i, Nodes &force) const
      {
        for (int n = 0; n < 9; ++n)
          {
            spread<in_plane>(value[n], i, force + 3 * n);
            for (int a = 0; a < 3; ++a)
              force[3 * n + a] += Number(in_plane.slope[i][a]) * slope[n];
          }
      }
    };

    /// On one line of points: the field and its derivatives by the first two coordinates, at the nodes of the third.
    struct Column
    {
      Vector value[3], first[3], second[3];

      [[gnu::always_inline]] Column()
      {
        for (int c = 0; c < 3; ++c)
          value[c] = first[c] = second[c] = zero();
      }
      [[gnu::always_inline]] Column(const Station &s, const int j)
      {
        for (int c = 0; c < 3; ++c)
          {
            const Vector *v = s.value + 3 * c, *d = s.slope + 3 * c;
            value[c]  = interpolate<in_plane>(v, j);
            first[c]  = interpolate<in_plane>(d, j);
            second[c] = combine(in_plane.slope[j], v[0], v[1], v[2]);
          }
      }
      [[gnu::always_inline]] Derivatives at(const int k) const
      {
        Derivatives g;
        g.d[0] = interpolate<across>(first, k);
        g.d[1] = interpolate<across>(second, k);
        g.d[2] = combine(across.slope[k], value[0], value[1], value[2]);
        return g;
      }
      [[gnu::always_inline]] void add(const Derivatives &g, const int k)
      {
        spread<across>(g.d[0], k, first);
        spread<across>(g.d[1], k, second);
        for (int c = 0; c < 3; ++c)
          value[c] += Number(across.slope[k][c]) * g.d[2];
      }
    };
  };
} // namespace birdstrike::studies
