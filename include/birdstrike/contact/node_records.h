#pragma once

#include <birdstrike/core/number.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>

namespace birdstrike
{
  /// What contact needs of a node, in one cache line: position, velocity, inverse mass, half thickness.
  struct alignas(64) NodeRecord
  {
    std::array<double, 8> value{};
  };

  namespace node_records
  {
    using LaneVector = double __attribute__((vector_size(n_lanes * sizeof(double)), may_alias));

    /// A square matrix of lanes, by rows.
    struct Rows
    {
      LaneVector row[n_lanes];
    };

    /// Row r of the matrix after its off-diagonal blocks of edge S are swapped: after S = 1, 2, ... it is transposed.
    template <std::size_t S, std::size_t r, std::size_t... k>
    [[gnu::always_inline]] inline LaneVector swapped_row(const Rows &m, std::index_sequence<k...>)
    {
      if constexpr ((r & S) == 0)
        return __builtin_shufflevector(m.row[r], m.row[r + S], ((k & S) == 0 ? k : n_lanes + k - S)...);
      else
        return __builtin_shufflevector(m.row[r - S], m.row[r], ((k & S) == 0 ? k + S : n_lanes + k)...);
    }

    template <std::size_t S, std::size_t... r>
    [[gnu::always_inline]] inline Rows transpose(const Rows &m, std::index_sequence<r...> all)
    {
      if constexpr (S == n_lanes)
        return m;
      else
        return transpose<2 * S>({{swapped_row<S, r>(m, all)...}}, all);
    }

    [[gnu::always_inline]] inline LaneVector load_row(const double *p)
    {
      LaneVector row;
      std::memcpy(&row, p, sizeof(row));
      return row;
    }

    template <std::size_t... r>
    [[gnu::always_inline]] inline Rows load_block(const NodeRecord *records, const std::uint32_t *index,
                                                  const std::size_t block, std::index_sequence<r...> all)
    {
      return transpose<1>({{load_row(&records[index[r]].value[block])...}}, all);
    }
  } // namespace node_records

  /// The eight components of records[index[0 .. n_lanes)]: whole lines are loaded and transposed in registers, as in
  /// the particle sums.
  [[gnu::always_inline]] inline std::array<Lanes, 8> load_nodes(const NodeRecord *records, const std::uint32_t *index)
  {
    static_assert(8 % n_lanes == 0, "a record holds whole registers");
    std::array<Lanes, 8> components;
    for (std::size_t block = 0; block < 8; block += n_lanes)
      {
        const auto columns = node_records::load_block(records, index, block, std::make_index_sequence<n_lanes>());
        for (std::size_t k = 0; k < n_lanes; ++k)
          components[block + k] = std::bit_cast<Lanes>(columns.row[k]);
      }
    return components;
  }
} // namespace birdstrike
