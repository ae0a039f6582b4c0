#pragma once

#include <birdstrike/core/number.h>

#include <array>

namespace birdstrike
{
  /// Symmetric 3 x 3 tensor: xx yy zz xy xz yz. The functions below take anything so ordered whose first six entries
  /// count.
  using SymmetricTensor = std::array<double, 6>;

  /// A symmetric tensor times a vector.
  template <class Tensor, class Number>
  [[gnu::always_inline]] inline Vector3<Number> multiply(const Tensor &t, const Vector3<Number> &x)
  {
    return {t[0] * x[0] + t[3] * x[1] + t[4] * x[2], t[3] * x[0] + t[1] * x[1] + t[5] * x[2],
            t[4] * x[0] + t[5] * x[1] + t[2] * x[2]};
  }

  /// x.t.x
  template <class Tensor, class Number>
  [[gnu::always_inline]] inline Number stretch(const Tensor &t, const Vector3<Number> &x)
  {
    const Vector3<Number> tx = multiply(t, x);
    return tx[0] * x[0] + tx[1] * x[1] + tx[2] * x[2];
  }

  /// a : b
  template <class A>
  double contract(const A &a, const SymmetricTensor &b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2. * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
  }

  inline SymmetricTensor symmetric_part(const Matrix3<double> &m)
  {
    return {m(0, 0), m(1, 1), m(2, 2), 0.5 * (m(0, 1) + m(1, 0)), 0.5 * (m(0, 2) + m(2, 0)), 0.5 * (m(1, 2) + m(2, 1))};
  }

  inline Matrix3<double> full(const SymmetricTensor &t)
  {
    Matrix3<double> m;
    m << t[0], t[3], t[4], t[3], t[1], t[5], t[4], t[5], t[2];
    return m;
  }
} // namespace birdstrike
