#pragma once

#include <birdstrike/core/number.h>

#include <array>

namespace birdstrike
{
  /// The pair sums of one particle.
  template <class Number>
  struct RiemannSums
  {
    [[gnu::always_inline]] inline void add_force(const std::array<Number, 8> &P, const Number &q,
                                                 const Vector3<Number> &wx);
    [[gnu::always_inline]] inline void add_moments(const Vector3<Number> &wx, const Vector3<Number> &x);
    [[gnu::always_inline]] inline void add_gradient(const Vector3<Number> &wx, const Vector3<Number> &v);

    std::array<Number, 3> force{};    ///< V w (p B + q) x
    std::array<Number, 3> own{};      ///< V w x
    std::array<Number, 6> moments{};  ///< V w x x^T
    std::array<Number, 9> gradient{}; ///< V w v x^T
    Number                divergence = 0., flux = 0., heat = 0.;
  };

  template <class Number>
  inline void RiemannSums<Number>::add_force(const std::array<Number, 8> &P, const Number &q, const Vector3<Number> &wx)
  {
    force[0] += (P[0] + q) * wx[0] + P[3] * wx[1] + P[4] * wx[2];
    force[1] += P[3] * wx[0] + (P[1] + q) * wx[1] + P[5] * wx[2];
    force[2] += P[4] * wx[0] + P[5] * wx[1] + (P[2] + q) * wx[2];
  }

  template <class Number>
  inline void RiemannSums<Number>::add_moments(const Vector3<Number> &wx, const Vector3<Number> &x)
  {
    moments[0] += wx[0] * x[0];
    moments[1] += wx[1] * x[1];
    moments[2] += wx[2] * x[2];
    moments[3] += wx[0] * x[1];
    moments[4] += wx[0] * x[2];
    moments[5] += wx[1] * x[2];
  }

  template <class Number>
  inline void RiemannSums<Number>::add_gradient(const Vector3<Number> &wx, const Vector3<Number> &v)
  {
    gradient[0] += v[0] * wx[0];
    gradient[1] += v[0] * wx[1];
    gradient[2] += v[0] * wx[2];
    gradient[3] += v[1] * wx[0];
    gradient[4] += v[1] * wx[1];
    gradient[5] += v[1] * wx[2];
    gradient[6] += v[2] * wx[0];
    gradient[7] += v[2] * wx[1];
    gradient[8] += v[2] * wx[2];
  }
} // namespace birdstrike
