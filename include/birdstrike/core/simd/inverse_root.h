#pragma once

#include <birdstrike/core/number.h>

#include <bit>

#if defined(__AVX512F__)
#  include <immintrin.h>
#endif

/// 1/sqrt(a) to full precision, a > 0 normal: with the hardware's 14-bit estimate y half the time of a division and a
/// root, which together are the dearest part of a particle pair (Zen 4).
namespace birdstrike
{
  inline double inverse_root(const double a)
  {
    return 1. / std::sqrt(a);
  }

  /// With e = 1 - a y^2 the series y (1 + e/2 + 3 e^2/8 + 5 e^3/16), the next term of which is 1e-16.
  [[gnu::always_inline]] inline Lanes inverse_root(const Lanes &a)
  {
#if defined(__AVX512F__)
    if constexpr (n_lanes == 8)
      {
        const Lanes y = std::bit_cast<Lanes>(_mm512_rsqrt14_pd(std::bit_cast<__m512d>(a)));
        const Lanes e = Lanes(1.) - (a * y) * y;
        return y + y * (e * (Lanes(0.5) + e * (Lanes(0.375) + 0.3125 * e)));
      }
#endif
    return 1. / sqrt(a);
  }

  /// One Newton step y (3 - a y^2)/2.
  [[gnu::always_inline]] inline FloatLanes inverse_root(const FloatLanes &a)
  {
#if defined(__AVX512F__)
    if constexpr (FloatLanes::size() == 16)
      {
        const FloatLanes y = std::bit_cast<FloatLanes>(_mm512_rsqrt14_ps(std::bit_cast<__m512>(a)));
        return y * (1.5f - 0.5f * a * y * y);
      }
#endif
    return 1.f / sqrt(a);
  }
} // namespace birdstrike
