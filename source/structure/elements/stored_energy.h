#pragma once

#include <birdstrike/core/number.h>
#include <birdstrike/core/thread_pool.h>

#include <array>

namespace birdstrike
{
  /// What elements store, from their stresses and volumes alone: a function of the present state, so that it can
  /// neither be negative nor hide what a path has made (a sum of V du over time does: a law in rates, ds = C : de, does
  /// not come back to zero on a closed path). Stresses are Kirchhoff's, in shells and bricks: with the energy density
  /// u = s : C^{-1} : s / 2 an element stores V_0 u, and takes in V_0 s : de = V_0 du on every path. Two kinds go side
  /// by side: of the stress that the element is integrated with, and of its stabilisation.
  struct StoredEnergy
  {
    static constexpr std::size_t n_kinds = 2;
    using Sums                           = std::array<double, n_kinds>; ///< J

    /// Of one section of a batch of elements.
    struct State
    {
      Lanes density[n_kinds]; ///< J/m^3
      Lanes volume;           ///< m^3; 0 of lanes that are no element
    };

    /// Sums over all sections, evaluate(section) -> State, in a fixed order.
    template <class Evaluate>
    static Sums compute(ThreadPool &pool, const std::size_t n_sections, const Evaluate &evaluate)
    {
      constexpr std::size_t sections_per_chunk = 64;
      return pool.template ordered_sums<n_kinds>(
        n_sections,
        [&](const std::size_t begin, const std::size_t end) {
          Lanes sum[n_kinds] = {Lanes(0.), Lanes(0.)};
          for (std::size_t s = begin; s < end; ++s)
            {
              const State state = evaluate(s);
              for (std::size_t k = 0; k < n_kinds; ++k)
                sum[k] += state.volume * state.density[k];
            }
          return Sums{stdx::reduce(sum[0]), stdx::reduce(sum[1])};
        },
        sections_per_chunk);
    }
  };
} // namespace birdstrike
