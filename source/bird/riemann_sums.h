#pragma once

#include <birdstrike/core/simd/lane_sums.h>

#include <array>
#include <cstdint>

namespace birdstrike
{
  /// Sum of pair forces, one component per entry: in double as it comes, in float in fixed point.
  ///
  /// A pair force is antisymmetric to the last bit in float too, but a sum of floats is not: its round-off depends on
  /// the order. Truncated to integers, which add exactly, pair forces cancel exactly, so that momentum is kept to the
  /// round-off of double. The unit is chosen such that no sum overflows (RiemannRates::update_scale).
  template <class T>
  class ForceSum;

  template <>
  class ForceSum<double>
  {
  public:
    [[gnu::always_inline]] inline void add(const Vector3<Lanes> &f)
    {
      for (int d = 0; d < 3; ++d)
        total[d] += f[d];
    }
    [[gnu::always_inline]] inline std::array<double, 3> value() const
    {
      return sum_lanes<double>(total);
    }

  private:
    std::array<Lanes, 3> total{};
  };

  template <>
  class ForceSum<float>
  {
  public:
    [[gnu::always_inline]] inline void add(const Vector3<FloatLanes> &f)
    {
      for (int d = 0; d < 3; ++d)
        total[d] += stdx::static_simd_cast<Integers>(f[d]);
    }
    [[gnu::always_inline]] inline std::array<double, 3> value() const
    {
      std::array<Lanes, 3> sums;
      for (int d = 0; d < 3; ++d)
        {
          const auto [a, b] = widen(total[d]);
          sums[d]           = a + b;
        }
      return sum_lanes<double>(sums);
    }

  private:
    using Integers = stdx::rebind_simd_t<std::int32_t, FloatLanes>;
    std::array<Integers, 3> total{};
  };

  /// The finished sums of as many consecutive particles as there are lanes, component by component.
  struct SumBlock
  {
    /// Places of the components: force; w v x^T as xx yy zz, xy xz yz, yx zx zy; scalars; w x x^T;
    /// extremes; the particle's own pressure and volume as its record has them.
    static constexpr int force = 0, gradient = 3, flux = 12, heat = 13, weight = 14, moments = 15, approach = 21,
                         smallest = 22, pressure = 23, volume = 24, size = 25;

    template <std::size_t n>
    [[gnu::always_inline]] inline void store(const int first, const std::size_t particle,
                                             const std::array<double, n> &sums)
    {
      for (std::size_t k = 0; k < n; ++k)
        value[first + k][particle] = sums[k];
    }
    template <class Number>
    Number get(const int component, const std::size_t particle) const
    {
      return load<Number>(&value[component][particle]);
    }

    alignas(64) std::array<std::array<double, n_lanes>, size> value;
  };

  /// The sums of one particle over its neighbours besides the force; w is V_i V_j times the kernel's slope.
  template <class Number>
  struct PairSums
  {
    std::array<Number, 12> mean{};    ///< from SumBlock::gradient on
    std::array<Number, 6>  moments{}; ///< w x x^T

    [[gnu::always_inline]] inline Number &flux()
    {
      return mean[SumBlock::flux - SumBlock::gradient];
    }
    [[gnu::always_inline]] inline Number &heat()
    {
      return mean[SumBlock::heat - SumBlock::gradient];
    }
    [[gnu::always_inline]] inline Number &weight()
    {
      return mean[SumBlock::weight - SumBlock::gradient];
    }

    [[gnu::always_inline]] inline void add_gradient(const Vector3<Number> &wx, const Vector3<Number> &v)
    {
      mean[0] += v[0] * wx[0];
      mean[1] += v[1] * wx[1];
      mean[2] += v[2] * wx[2];
      mean[3] += v[0] * wx[1];
      mean[4] += v[0] * wx[2];
      mean[5] += v[1] * wx[2];
      mean[6] += v[1] * wx[0];
      mean[7] += v[2] * wx[0];
      mean[8] += v[2] * wx[1];
    }
    [[gnu::always_inline]] inline void add_moments(const Vector3<Number> &wx, const Vector3<Number> &x)
    {
      moments[0] += wx[0] * x[0];
      moments[1] += wx[1] * x[1];
      moments[2] += wx[2] * x[2];
      moments[3] += wx[0] * x[1];
      moments[4] += wx[0] * x[2];
      moments[5] += wx[1] * x[2];
    }
  };
} // namespace birdstrike
