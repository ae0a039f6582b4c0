#pragma once

#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/number.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>

#if defined(__AVX512F__)
#  include <immintrin.h>
#endif

namespace birdstrike
{
  /// A register of doubles, or of twice as many floats.
  template <class T>
  using LanesOf = stdx::native_simd<T>;

  /// What a loop needs of one entity (particle, node), in whole cache lines. Records are loaded whole and a register's
  /// worth of them is transposed in registers: hardware gathers of single components take twice as long (measured,
  /// Zen 4).
  template <class T, std::size_t n>
  struct alignas(n * sizeof(T)) Record
  {
    std::array<T, n> value{};
  };
  template <class T, std::size_t n>
  using Records = AlignedVector<Record<T, n>>;

  namespace internal
  {
    template <class T>
    inline constexpr std::size_t width = LanesOf<T>::size();

    template <class T>
    using LaneVector [[gnu::vector_size(width<T> * sizeof(T)), gnu::may_alias]] = T;

    /// A square matrix of lanes, by rows.
    template <class T>
    struct Rows
    {
      LaneVector<T> row[width<T>];
    };

    /// Row r of the matrix after its off-diagonal blocks of edge S are swapped: after S = 1, 2, ... it is transposed.
    template <class T, std::size_t S, std::size_t r, std::size_t... k>
    [[gnu::always_inline]] inline LaneVector<T> swapped_row(const Rows<T> &m, std::index_sequence<k...>)
    {
      constexpr std::size_t N = width<T>;
      if constexpr ((r & S) == 0)
        return __builtin_shufflevector(m.row[r], m.row[r + S], ((k & S) == 0 ? k : N + k - S)...);
      else
        return __builtin_shufflevector(m.row[r - S], m.row[r], ((k & S) == 0 ? k + S : N + k)...);
    }

    template <class T, std::size_t S, std::size_t... r>
    [[gnu::always_inline]] inline Rows<T> transpose(const Rows<T> &m, std::index_sequence<r...> all)
    {
      if constexpr (S == width<T>)
        return m;
      else
        return transpose<T, 2 * S>({{swapped_row<T, S, r>(m, all)...}}, all);
    }

    /// The lower (or upper) halves of each 128-bit quarter of a and b, interleaved by units of S lanes: one
    /// instruction on every instruction set, half as dear as the general two-source permutation (measured, Zen 4).
    template <class T, std::size_t S, bool is_upper, std::size_t... k>
    [[gnu::always_inline]] inline LaneVector<T> unpack(const LaneVector<T> &a, const LaneVector<T> &b,
                                                       std::index_sequence<k...>)
    {
      constexpr std::size_t quarter = 16 / sizeof(T);
      return __builtin_shufflevector(a, b,
                                     (k / quarter * quarter + (is_upper ? quarter / 2 : 0) + k % quarter / (2 * S) * S +
                                      k % S + (k / S % 2 == 0 ? 0 : width<T>) )...);
    }

    /// Transposes the 4 x 4 blocks of floats within 128-bit quarters of rows 4g .. 4g + 3, for every g.
    template <std::size_t... g>
    [[gnu::always_inline]] inline Rows<float> transpose_quarters(const Rows<float> &m, std::index_sequence<g...>)
    {
      constexpr auto all = std::make_index_sequence<width<float>>();
      Rows<float>    result;
      const auto     block = [&](const std::size_t r) [[gnu::always_inline]] {
        const auto a      = unpack<float, 1, false>(m.row[r], m.row[r + 1], all);
        const auto b      = unpack<float, 1, true>(m.row[r], m.row[r + 1], all);
        const auto c      = unpack<float, 1, false>(m.row[r + 2], m.row[r + 3], all);
        const auto d      = unpack<float, 1, true>(m.row[r + 2], m.row[r + 3], all);
        result.row[r]     = unpack<float, 2, false>(a, c, all);
        result.row[r + 1] = unpack<float, 2, true>(a, c, all);
        result.row[r + 2] = unpack<float, 2, false>(b, d, all);
        result.row[r + 3] = unpack<float, 2, true>(b, d, all);
      };
      (block(4 * g), ...);
      return result;
    }

    [[gnu::always_inline]] inline Rows<double> transpose(const Rows<double> &m)
    {
      return transpose<double, 1>(m, std::make_index_sequence<width<double>>());
    }
    [[gnu::always_inline]] inline Rows<float> transpose(const Rows<float> &m)
    {
      return transpose<float, 4>(transpose_quarters(m, std::make_index_sequence<width<float> / 4>()),
                                 std::make_index_sequence<width<float>>());
    }

    template <class T>
    [[gnu::always_inline]] inline LaneVector<T> load_row(const T *p)
    {
      LaneVector<T> row;
      std::memcpy(&row, p, sizeof(row));
      return row;
    }

    template <class T, std::size_t n, std::size_t... r>
    [[gnu::always_inline]] inline Rows<T> load_block(const Record<T, n> *records, const std::uint32_t *index,
                                                     const std::size_t block, std::index_sequence<r...>)
    {
      return transpose(Rows<T>{{load_row(&records[index[r]].value[block])...}});
    }
  } // namespace internal

  /// The n components of records[index[0 .. lanes)].
  template <class T, std::size_t n>
  [[gnu::always_inline]] inline std::array<LanesOf<T>, n> load_records(const Record<T, n>  *records,
                                                                       const std::uint32_t *index)
  {
    constexpr std::size_t N = internal::width<T>;
    static_assert(n % N == 0, "a record holds whole registers");
    std::array<LanesOf<T>, n> components;
    for (std::size_t block = 0; block < n; block += N)
      {
        const auto columns = internal::load_block(records, index, block, std::make_index_sequence<N>());
        for (std::size_t k = 0; k < N; ++k)
          components[block + k] = std::bit_cast<LanesOf<T>>(columns.row[k]);
      }
    return components;
  }

  template <class T, std::size_t n>
  [[gnu::always_inline]] inline std::array<LanesOf<T>, n> load_records(const Records<T, n> &records,
                                                                       const std::uint32_t *index)
  {
    return load_records(records.data(), index);
  }

  /// records[p + k].value[c] = lane k of components[c], for as many k as there are lanes of doubles.
  template <class T, std::size_t n>
  [[gnu::always_inline]] inline void store_records(const std::array<Lanes, n> &components, Records<T, n> &records,
                                                   const std::size_t p)
  {
    static_assert(n % n_lanes == 0, "a record holds whole registers");
    for (std::size_t block = 0; block < n; block += n_lanes)
      {
        internal::Rows<double> columns;
        for (std::size_t k = 0; k < n_lanes; ++k)
          columns.row[k] = std::bit_cast<internal::LaneVector<double>>(components[block + k]);
        const internal::Rows<double> rows = internal::transpose(columns);
        for (std::size_t k = 0; k < n_lanes; ++k)
          std::bit_cast<Lanes>(rows.row[k]).copy_to(&records[p + k].value[block], stdx::element_aligned);
      }
  }
  template <class T, std::size_t n>
  [[gnu::always_inline]] inline void store_records(const std::array<double, n> &components, Records<T, n> &records,
                                                   const std::size_t p)
  {
    for (std::size_t c = 0; c < n; ++c)
      records[p].value[c] = static_cast<T>(components[c]);
  }

  /// 1/sqrt(a) to full precision, a > 0. Hardware's 14-bit estimate and Newton steps y <- y(3 - a y^2)/2 take half the
  /// time of a division and a root, which together are the dearest part of a pair.
  template <class T>
  [[gnu::always_inline]] inline LanesOf<T> inverse_sqrt(const LanesOf<T> &a)
  {
#if defined(__AVX512F__)
    if constexpr (sizeof(a) == 64)
      {
        LanesOf<T> y;
        if constexpr (sizeof(T) == 8)
          y = std::bit_cast<LanesOf<T>>(_mm512_rsqrt14_pd(std::bit_cast<__m512d>(a)));
        else
          y = std::bit_cast<LanesOf<T>>(_mm512_rsqrt14_ps(std::bit_cast<__m512>(a)));
        const LanesOf<T> half = T(0.5) * a;
        for (int newton = 0; newton < (sizeof(T) == 8 ? 2 : 1); ++newton)
          y *= T(1.5) - half * y * y;
        return y;
      }
#endif
    return T(1) / sqrt(a);
  }
} // namespace birdstrike
