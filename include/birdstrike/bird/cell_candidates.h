#pragma once

#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/simd/compress.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace birdstrike
{
  /// Positions by component, in float; whole registers can be read from the last one on.
  using FloatPositions = std::array<AlignedVector<float>, 3>;

  /// What may neighbour the particles of one cell: those around it, side by side in the order of their numbers' runs.
  /// All particles of the cell then run over the same registers, without ends of runs, whose number no processor
  /// guesses right. What is out of range of the whole cell is left out where a register can be compressed.
  class CellCandidates
  {
  public:
    static constexpr std::size_t width = FloatLanes::size();
    using Numbers                      = LaneNumbers<FloatLanes>;

    /// None as yet, of at most `most`; the square of the range in m^2.
    void clear(const std::size_t most, const float squared_range)
    {
      n      = 0;
      range2 = squared_range;
      number.resize(std::max(number.size(), most + width));
      for (auto &column : x)
        column.resize(number.size());
    }

    /// The box of the cell's particles [begin, end), at least one.
    void set_box(const FloatPositions &positions, const std::size_t begin, const std::size_t end)
    {
      for (int d = 0; d < 3; ++d)
        {
          const auto of_cell = std::minmax_element(positions[d].begin() + begin, positions[d].begin() + end);
          low[d]             = *of_cell.first;
          high[d]            = *of_cell.second;
        }
    }

    /// The particles [begin, end). `all`: whatever their distance from the box.
    template <bool all>
    void add(const FloatPositions &positions, const std::size_t begin, const std::size_t end)
    {
      for (std::size_t j = begin; j < end; j += width)
        {
          const std::size_t         in_run = std::min(width, end - j);
          std::array<FloatLanes, 3> at;
          for (int d = 0; d < 3; ++d)
            at[d] = FloatLanes(&positions[d][j], stdx::element_aligned);
          const Numbers numbers = count_lanes<Numbers>() + static_cast<std::uint32_t>(j);
          if constexpr (all || !is_compressed_in_registers<FloatLanes>)
            {
              for (int d = 0; d < 3; ++d)
                at[d].copy_to(x[d].data() + n, stdx::element_aligned);
              numbers.copy_to(number.data() + n, stdx::element_aligned);
              n += in_run;
            }
          else
            {
              FloatLanes gap2 = 0.f;
              for (int d = 0; d < 3; ++d)
                {
                  const FloatLanes gap = max(max(low[d] - at[d], at[d] - high[d]), FloatLanes(0.f));
                  gap2 += gap * gap;
                }
              // round-off of both distances is less than the excess
              const std::uint32_t bits =
                to_bits(gap2 < 1.00001f * range2) & static_cast<std::uint32_t>((std::uint64_t(1) << in_run) - 1);
              for (int d = 0; d < 3; ++d)
                compress_lanes(at[d], bits, x[d].data() + n);
              n += compress_lanes(numbers, bits, number.data() + n);
            }
        }
    }

    /// After the last one: what fills the last register is near nothing.
    void close()
    {
      for (auto &column : x)
        FloatLanes(std::numeric_limits<float>::quiet_NaN()).copy_to(column.data() + n, stdx::element_aligned);
    }

    /// Writes those closer than the range to particle p at `place`, but itself, whole registers at a time; returns the
    /// end. `period` of each direction, m; 0: none.
    template <bool is_periodic>
    std::uint32_t *list(std::uint32_t *out, const std::uint32_t p, const std::array<float, 3> &place,
                        const std::array<float, 3> &period) const
    {
      for (std::size_t j = 0; j < n; j += width)
        {
          FloatLanes r2 = 0.f;
          for (int d = 0; d < 3; ++d)
            {
              FloatLanes r = FloatLanes(x[d].data() + j, stdx::element_aligned) - place[d];
              if constexpr (is_periodic)
                if (period[d] > 0.f)
                  r -= period[d] * stdx::nearbyint(r * (1.f / period[d]));
              r2 += r * r;
            }
          const Numbers numbers(number.data() + j, stdx::element_aligned);
          out += compress_lanes(numbers, to_bits(r2 < range2) & to_bits(numbers != p), out);
        }
      return out;
    }

  private:
    FloatPositions               x; ///< m
    AlignedVector<std::uint32_t> number;
    std::size_t                  n      = 0;
    float                        range2 = 0.f; ///< m^2
    std::array<float, 3>         low{}, high{};
  };
} // namespace birdstrike
