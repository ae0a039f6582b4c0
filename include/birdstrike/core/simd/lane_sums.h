#pragma once

#include <birdstrike/core/simd/transpose.h>

#include <type_traits>

namespace birdstrike
{
  namespace internal
  {
    /// Lane k holds a_k + a_{k^S} where bit S of k is clear, b_k + b_{k^S} where it is set.
    template <class T, std::size_t S, std::size_t... k>
    [[gnu::always_inline]] inline LaneVector<T> fold(const LaneVector<T> &a, const LaneVector<T> &b,
                                                     std::index_sequence<k...>)
    {
      constexpr std::size_t N = width<T>;
      return __builtin_shufflevector(a, b, ((k & S) == 0 ? k : N + k - S)...) +
             __builtin_shufflevector(a, b, ((k & S) == 0 ? k + S : N + k)...);
    }

    template <class T, std::size_t n>
    using VectorOf [[gnu::vector_size(n * sizeof(T))]] = T;

    /// As many as there are lanes, from `first` on, as doubles.
    template <std::size_t first, class Vector, std::size_t... k>
    [[gnu::always_inline]] inline Lanes widen_half(const Vector &a, std::index_sequence<k...>)
    {
      return std::bit_cast<Lanes>(
        __builtin_convertvector(__builtin_shufflevector(a, a, (first + k)...), LaneVector<double>));
    }

    template <class T, std::size_t S, std::size_t n>
    [[gnu::always_inline]] inline void fold_all(Rows<T> &m)
    {
      if constexpr (n > 1)
        {
          for (std::size_t k = 0; k < n / 2; ++k)
            m.row[k] = fold<T, S>(m.row[2 * k], m.row[2 * k + 1], std::make_index_sequence<width<T>>());
          fold_all<T, 2 * S, n / 2>(m);
        }
    }
  } // namespace internal

  /// The lower and the upper half of a register of floats, or of as many integers, as doubles. (std::experimental's
  /// casts and splits are calls, before which all that a loop holds in registers is put away: 4 % of a particle step,
  /// measured.)
  template <class Register>
  [[gnu::always_inline]] inline std::array<Lanes, 2> widen(const Register &a)
  {
    using T = typename Register::value_type;
    static_assert(Register::size() == 2 * n_lanes);
    using Vector = internal::VectorOf<T, 2 * n_lanes>;
    Vector lanes;
    if constexpr (std::is_trivially_copyable_v<Register> && sizeof(Register) == sizeof(Vector))
      lanes = std::bit_cast<Vector>(a);
    else // integers of AVX without AVX2: two registers
      {
        T values[2 * n_lanes];
        a.copy_to(values, stdx::element_aligned);
        std::memcpy(&lanes, values, sizeof lanes);
      }
    constexpr auto half = std::make_index_sequence<n_lanes>();
    return {internal::widen_half<0>(lanes, half), internal::widen_half<n_lanes>(lanes, half)};
  }

  /// sums[k] = sum over the lanes of terms[k]. All sums share one tree of shuffles, a third of the work of one
  /// reduction each.
  template <class T, std::size_t n>
  [[gnu::always_inline]] inline std::array<double, n> sum_lanes(const std::array<LanesOf<T>, n> &terms)
  {
    constexpr std::size_t N = internal::width<T>;
    std::array<double, n> sums;
    for (std::size_t first = 0; first < n; first += N)
      {
        internal::Rows<T> m{};
        for (std::size_t k = 0; k < N && first + k < n; ++k)
          m.row[k] = std::bit_cast<internal::LaneVector<T>>(terms[first + k]);
        internal::fold_all<T, 1, N>(m);
        std::array<double, N> folded;
        if constexpr (std::is_same_v<T, double>)
          std::memcpy(folded.data(), &m.row[0], sizeof folded);
        else
          {
            const auto [low, high] = widen(std::bit_cast<LanesOf<T>>(m.row[0]));
            store(low, folded.data());
            store(high, folded.data() + n_lanes);
          }
        for (std::size_t k = 0; k < N && first + k < n; ++k)
          sums[first + k] = folded[k];
      }
    return sums;
  }
} // namespace birdstrike
