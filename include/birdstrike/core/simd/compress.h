#pragma once

#include <birdstrike/core/number.h>

#include <bit>
#include <cstdint>

#if defined(__AVX__)
#  include <immintrin.h>
#endif

namespace birdstrike
{
  /// Numbers (of particles, pairs, ...) beside the lanes of `Register`.
  template <class Register>
  using LaneNumbers = stdx::rebind_simd_t<std::uint32_t, Register>;

  /// 0, 1, 2, ...
  template <class Register>
  inline Register count_lanes()
  {
    return Register([](const auto k) { return static_cast<typename Register::value_type>(k); });
  }

  /// Bit k is set where lane k is.
  template <class T, class Abi>
  [[gnu::always_inline]] inline std::uint32_t to_bits(const stdx::simd_mask<T, Abi> &mask)
  {
#if defined(__AVX512F__)
    if constexpr (sizeof(mask) == sizeof(__mmask16))
      return std::bit_cast<__mmask16>(mask);
    if constexpr (sizeof(mask) == sizeof(__mmask8))
      return std::bit_cast<__mmask8>(mask);
#elif defined(__AVX__)
    if constexpr (sizeof(mask) == 32 && sizeof(T) == 4)
      return static_cast<std::uint32_t>(_mm256_movemask_ps(std::bit_cast<__m256>(mask)));
    if constexpr (sizeof(mask) == 32 && sizeof(T) == 8)
      return static_cast<std::uint32_t>(_mm256_movemask_pd(std::bit_cast<__m256d>(mask)));
#endif
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < mask.size(); ++k)
      bits |= static_cast<std::uint32_t>(mask[k]) << k;
    return bits;
  }

  /// Whether compress_lanes of such a register is a few instructions, not a loop over its lanes.
  template <class Register>
  inline constexpr bool is_compressed_in_registers =
#if defined(__AVX512F__) && defined(__AVX512VL__)
    sizeof(Register) == 64 || (sizeof(Register) == 32 && sizeof(typename Register::value_type) == 4);
#else
    false;
#endif

  /// Writes the lanes whose bit is set, in order, and returns how many. There must be room for all lanes: whole
  /// registers are written. Compressed in registers it takes a fifth of the time of the loop (measured, Zen 4; a
  /// compressing store to memory would be ten times slower there).
  template <class T, class Abi>
  [[gnu::always_inline]] inline std::size_t compress_lanes(const stdx::simd<T, Abi> &a, const std::uint32_t bits,
                                                           T *out)
  {
    using Register [[maybe_unused]] = stdx::simd<T, Abi>;
#if defined(__AVX512F__) && defined(__AVX512VL__)
    if constexpr (sizeof(a) == 64 && sizeof(T) == 4)
      std::bit_cast<Register>(_mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), std::bit_cast<__m512i>(a)))
        .copy_to(out, stdx::element_aligned);
    else if constexpr (sizeof(a) == 32 && sizeof(T) == 4)
      std::bit_cast<Register>(_mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), std::bit_cast<__m256i>(a)))
        .copy_to(out, stdx::element_aligned);
    else if constexpr (sizeof(a) == 64 && sizeof(T) == 8)
      std::bit_cast<Register>(_mm512_maskz_compress_pd(static_cast<__mmask8>(bits), std::bit_cast<__m512d>(a)))
        .copy_to(out, stdx::element_aligned);
    else
#endif
      for (std::uint32_t left = bits; left != 0; left &= left - 1)
        *out++ = a[static_cast<std::size_t>(std::countr_zero(left))];
    return static_cast<std::size_t>(std::popcount(bits));
  }
} // namespace birdstrike
