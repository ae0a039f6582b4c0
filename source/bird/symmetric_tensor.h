#pragma once

#include <birdstrike/core/number.h>

namespace birdstrike
{
  /// A symmetric tensor, anything whose first six entries are xx yy zz xy xz yz, times a vector.
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
} // namespace birdstrike
