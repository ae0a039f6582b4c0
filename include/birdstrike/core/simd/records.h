#pragma once

#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/simd/transpose.h>

#include <cstdint>

namespace birdstrike
{
  /// What a loop needs of one entity (particle, node), in whole cache lines. Records are loaded whole and a register's
  /// worth of them is transposed in registers, and back: reading, gathering or scattering single components takes twice
  /// as long at least (measured, Zen 4).
  template <class T, std::size_t n>
  struct alignas(n * sizeof(T)) Record
  {
    std::array<T, n> value{};
  };
  template <class T, std::size_t n>
  using Records = AlignedVector<Record<T, n>>;

  /// Eight numbers of one entity in one cache line.
  struct alignas(64) Row
  {
    double value[8];
  };

  /// The n components of records[index[0 .. lanes)].
  template <class T, std::size_t n>
  [[gnu::always_inline]] inline std::array<LanesOf<T>, n> load_records(const Record<T, n>  *records,
                                                                       const std::uint32_t *index)
  {
    return internal::load_columns<T, n>([=](const std::size_t r, const std::size_t column)
                                          __attribute__((always_inline)) { return &records[index[r]].value[column]; });
  }
  template <class T, std::size_t n>
  [[gnu::always_inline]] inline std::array<LanesOf<T>, n> load_records(const Records<T, n> &records,
                                                                       const std::uint32_t *index)
  {
    return load_records(records.data(), index);
  }

  /// The eight components of the rows that begin at base + offset[0 .. n_lanes), offsets in doubles.
  [[gnu::always_inline]] inline std::array<Lanes, 8> load_rows(const double *base, const std::uint32_t *offset)
  {
    return internal::load_columns<double, 8>([=](const std::size_t r, const std::size_t column)
                                               __attribute__((always_inline)) { return base + offset[r] + column; });
  }

  /// records[p + k].value[c] = lane k of components[c], for as many k as there are lanes of doubles.
  template <class T, std::size_t n>
  [[gnu::always_inline]] inline void store_records(const std::array<Lanes, n> &components, Records<T, n> &records,
                                                   const std::size_t p)
  {
    internal::store_columns(
      components, [&](const std::size_t r, const std::size_t c, const auto &part)
                    __attribute__((always_inline)) { store(std::bit_cast<Lanes>(part), &records[p + r].value[c]); });
  }
  template <class T, std::size_t n>
  [[gnu::always_inline]] inline void store_records(const std::array<double, n> &components, Records<T, n> &records,
                                                   const std::size_t p)
  {
    for (std::size_t c = 0; c < n; ++c)
      records[p].value[c] = static_cast<T>(components[c]);
  }

  /// rows[row[k]].value[c] = lane k of components[c].
  [[gnu::always_inline]] inline void store_rows(const std::array<Lanes, 8> &components, const std::uint32_t *row,
                                                Row *rows)
  {
    internal::store_columns(
      components, [&](const std::size_t r, const std::size_t c, const auto &part)
                    __attribute__((always_inline)) { std::memcpy(rows[row[r]].value + c, &part, sizeof part); });
  }

  /// The same with halves of four components, of which each goes to a place of its own: rows[...].value[4].
  template <class HalfRow>
  [[gnu::always_inline]] inline void store_half_rows(const std::array<Lanes, 8> &components, const std::uint32_t *first,
                                                     const std::uint32_t *second, HalfRow *rows)
  {
    constexpr std::size_t n = n_lanes < 4 ? n_lanes : 4;
    internal::store_columns(
      components, [&](const std::size_t r, const std::size_t block, const auto &part) __attribute__((always_inline)) {
#pragma GCC unroll 2
        for (std::size_t k = 0; k < n_lanes; k += n)
          {
            const std::size_t c = block + k;
            std::memcpy(rows[c < 4 ? first[r] : second[r]].value + c % 4,
                        reinterpret_cast<const char *>(&part) + k * sizeof(double), n * sizeof(double));
          }
      });
  }
} // namespace birdstrike
