#pragma once

#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/number.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace birdstrike
{
  /// What a pair needs of one particle, in one cache line. A neighbour's line is loaded whole and n_lanes of them are
  /// transposed in registers: hardware gathers of single components take twice as long (measured, Zen 4).
  struct alignas(64) Record
  {
    std::array<double, 8> value{};
  };
  using Records = AlignedVector<Record>;

  namespace internal
  {
    using LaneVector = double __attribute__((vector_size(n_lanes * sizeof(double))));

    /// Swaps off-diagonal blocks of edge S of the square matrix `rows`: after S = 1, 2, ... it is transposed.
    template <std::size_t S, std::size_t... k>
    inline void swap_blocks(LaneVector *rows, std::index_sequence<k...>)
    {
      for (std::size_t r = 0; r < n_lanes; ++r)
        if ((r & S) == 0)
          {
            const LaneVector a = rows[r], b = rows[r + S];
            rows[r]     = __builtin_shufflevector(a, b, ((k & S) == 0 ? k : n_lanes + k - S)...);
            rows[r + S] = __builtin_shufflevector(a, b, ((k & S) == 0 ? k + S : n_lanes + k)...);
          }
    }

    template <std::size_t S = 1>
    inline void transpose(LaneVector *rows)
    {
      if constexpr (S < n_lanes)
        {
          swap_blocks<S>(rows, std::make_index_sequence<n_lanes>());
          transpose<2 * S>(rows);
        }
    }
  } // namespace internal

  /// The eight components of records[index[0 .. n_lanes)].
  inline std::array<Lanes, 8> load_records(const Records &records, const std::uint32_t *index)
  {
    static_assert(8 % n_lanes == 0, "a record holds whole registers");
    std::array<Lanes, 8> components;
    for (std::size_t block = 0; block < 8; block += n_lanes)
      {
        internal::LaneVector rows[n_lanes];
        for (std::size_t k = 0; k < n_lanes; ++k)
          std::memcpy(&rows[k], &records[index[k]].value[block], sizeof(rows[k]));
        internal::transpose(rows);
        for (std::size_t k = 0; k < n_lanes; ++k)
          std::memcpy(static_cast<void *>(&components[block + k]), &rows[k], sizeof(rows[k]));
      }
    return components;
  }
} // namespace birdstrike
