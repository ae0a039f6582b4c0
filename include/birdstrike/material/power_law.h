#pragma once

#include <birdstrike/core/number.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace birdstrike
{
  /// (1 + mu)^gamma - 1 to full relative precision at small mu too, by log1p and expm1 in one.
  inline double compute_power_less_one(const double mu, const double gamma)
  {
    return std::expm1(gamma * std::log1p(mu));
  }

  namespace internal
  {
    /// 2 artanh s = log((1 + s)/(1 - s)) by its series, s^2 <= 0.085.
    inline Lanes compute_log_of_ratio(const Lanes &s)
    {
      const Lanes s2     = s * s;
      Lanes       series = 0.;
      for (int n = 29; n >= 3; n -= 2)
        series = (series + 1. / n) * s2;
      return 2. * s * (1. + series);
    }

    /// log x of positive, normal numbers: x = 2^k m, sqrt(1/2) <= m < sqrt(2). Of all others something beyond +-700.
    inline Lanes compute_log(const Lanes &x)
    {
      constexpr double                        log2          = 0.693147180559945309417;
      constexpr std::uint64_t                 bits_of_least = 0x3fe6a09e667f3bcd; // sqrt(1/2)
      alignas(64) std::array<double, n_lanes> of_x, power, mantissa;
      store(x, of_x.data());
      for (std::size_t l = 0; l < n_lanes; ++l)
        {
          const auto         bits = std::bit_cast<std::uint64_t>(of_x[l]);
          const std::int64_t k    = static_cast<std::int64_t>(bits - bits_of_least) >> 52;
          power[l]                = static_cast<double>(k);
          mantissa[l]             = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(k) << 52));
        }
      const Lanes m = load<Lanes>(mantissa.data());
      return load<Lanes>(power.data()) * log2 + compute_log_of_ratio((m - 1.) / (m + 1.));
    }
  } // namespace internal

  /// As above, for whole registers: a quarter of the time of the mathematical library (2.8 against 11.4 ns a number,
  /// Zen 4). With s = mu/(2 + mu), log(1 + mu) = 2 artanh s, whose series is summed for |mu| <= 0.45; beyond, where
  /// sprayed particles are, the power of two is taken out first (7 against 22 ns, Intel Xeon). exp(z) - 1 by
  /// reduction to |r| <= log(2)/2 and Taylor's series. Numbers out of all range take the library's way. Relative error
  /// below 1e-14 up to twenty times the density (tested), for gamma of 1 and more.
  inline Lanes compute_power_less_one(const Lanes &mu, const double gamma)
  {
    constexpr double log2 = 0.693147180559945309417, inverse_log2 = 1.442695040888963407360;
    constexpr double largest_mu = 0.45, largest_exponent = 500.;

    Lanes      z       = gamma * internal::compute_log_of_ratio(mu / (2. + mu));
    const auto is_wide = stdx::abs(mu) > Lanes(largest_mu);
    if (stdx::any_of(is_wide))
      z = select(is_wide, gamma * internal::compute_log(1. + mu), z);

    // adding 1.5 2^52 rounds to an integer, left in the low bits
    constexpr double magic   = 6755399441055744.;
    const Lanes      shifted = z * inverse_log2 + magic, k = shifted - magic, r = z - k * log2;
    Lanes            tail = 0.;
    for (int n = 14; n >= 2; --n)
      tail = (tail + 1.) * (r * (1. / n));
    const Lanes less_one = r * (1. + tail); // exp(r) - 1
    Lanes       power;                      // 2^k
    for (std::size_t l = 0; l < n_lanes; ++l)
      power[l] = std::bit_cast<double>((std::bit_cast<std::uint64_t>(static_cast<double>(shifted[l])) + 1023) << 52);
    Lanes result = power * less_one + (power - 1.);

    const auto beyond = stdx::abs(z) > Lanes(largest_exponent); // where 1 + mu is not above 0, too
    if (stdx::any_of(beyond))
      for (std::size_t l = 0; l < n_lanes; ++l)
        if (beyond[l])
          result[l] = compute_power_less_one(static_cast<double>(mu[l]), gamma);
    return result;
  }
} // namespace birdstrike
