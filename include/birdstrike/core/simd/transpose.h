#pragma once

#include <birdstrike/core/number.h>

#include <array>
#include <bit>
#include <cstring>
#include <utility>

namespace birdstrike
{
  /// A register of doubles, or of twice as many floats.
  template <class T>
  using LanesOf = stdx::native_simd<T>;
} // namespace birdstrike

namespace birdstrike::internal
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

  /// The lower (or upper) halves of each 128-bit quarter of a and b, interleaved by units of S lanes: one instruction
  /// on every instruction set, half as dear as the general two-source permutation (measured, Zen 4).
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
    const auto     block = [&](const std::size_t r) __attribute__((always_inline))
    {
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

  /// A square of lanes, transposed, of which row r begins at begin(r, block).
  template <class T, class Begin, std::size_t... r>
  [[gnu::always_inline]] inline Rows<T> load_block(const Begin &begin, const std::size_t block,
                                                   std::index_sequence<r...>)
  {
    return transpose(Rows<T>{{load_row<T>(begin(r, block))...}});
  }

  /// The first n columns of rows whose column c begins at begin(0 .. lanes, c).
  template <class T, std::size_t n, class Begin>
  [[gnu::always_inline]] inline std::array<LanesOf<T>, n> load_columns(const Begin &begin)
  {
    constexpr std::size_t N = width<T>;
    static_assert(n % N == 0, "whole registers");
    std::array<LanesOf<T>, n> column;
    for (std::size_t block = 0; block < n; block += N)
      {
        const Rows<T> m = load_block<T>(begin, block, std::make_index_sequence<N>());
        for (std::size_t k = 0; k < N; ++k)
          column[block + k] = std::bit_cast<LanesOf<T>>(m.row[k]);
      }
    return column;
  }

  /// The inverse: calls store(r, block, p) with n_lanes columns block .. of row r, which begin at p.
  template <std::size_t n, class Store>
  [[gnu::always_inline]] inline void store_columns(const std::array<Lanes, n> &column, const Store &store)
  {
    static_assert(n % n_lanes == 0, "whole registers");
#pragma GCC unroll 8
    for (std::size_t block = 0; block < n; block += n_lanes)
      {
        Rows<double> m;
#pragma GCC unroll 8
        for (std::size_t k = 0; k < n_lanes; ++k)
          m.row[k] = std::bit_cast<LaneVector<double>>(column[block + k]);
        m = transpose(m);
#pragma GCC unroll 8
        for (std::size_t r = 0; r < n_lanes; ++r)
          store(r, block, m.row[r]);
      }
  }
} // namespace birdstrike::internal
