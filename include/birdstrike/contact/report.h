#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// What contact did in its last call, and the peaks over all calls: of the whole, work excepted.
  struct ContactReport
  {
    std::array<double, 3> force{};                ///< N, on the facets
    double                stored_energy     = 0.; ///< J, of all springs
    double                dissipation_power = 0.; ///< W, of dampers and friction
    double                dissipated_energy = 0.; ///< J, taken by them and lost by springs (dissipation.h)
    double                released_energy   = 0.; ///< J, part of that: lost by springs
    double                staggering        = 0.; ///< J, what of it the next half step gives back
    double                dissipation_fall  = 0.; ///< J, by which its sum over finished steps ever fell: nothing
    double                largest_frequency = 0.; ///< 1/s, bound of the springs' largest angular frequency
    std::size_t           n_touching        = 0;  ///< pairs of point and facet
    double                penetration       = 0.; ///< m, largest now
    std::uint32_t         deepest_point = 0, deepest_facet = 0; ///< of that, as the views count them
    std::vector<double>   patch_pressures;                      ///< Pa, in the order of the parameter

    double peak_force                   = 0.; ///< N, largest norm
    double peak_force_time              = 0.; ///< s
    double max_penetration              = 0.; ///< m
    double max_penetration_over_spacing = 0.; ///< -

    // work done and saved, over all calls
    std::uint64_t calls         = 0;
    std::uint64_t skipped       = 0; ///< calls in which points and facets were apart: no search, no forces
    std::uint64_t searches      = 0; ///< candidate lists built
    std::uint64_t reused        = 0; ///< calls served by the last list
    std::uint64_t pairs_listed  = 0; ///< sum over calls of the pairs of point and facet on the list
    std::uint64_t pairs_tested  = 0; ///< of these, closest points computed; the others slept
    std::uint64_t points_near   = 0; ///< sum over calls of the points on the list
    std::uint64_t points_active = 0; ///< of these, with a pair tested
    std::uint64_t touches       = 0; ///< sum over calls of n_touching

    /// Points on the list, mean over the calls that were not skipped.
    double mean_points_near() const
    {
      return calls > skipped ? static_cast<double>(points_near) / static_cast<double>(calls - skipped) : 0.;
    }
  };

  /// A block's share in the last call.
  struct BlockReport
  {
    /// Stiffness of its springs over mass, 1/s^2, the largest of the points, and which.
    struct LargestPoint
    {
      double        value = 0.;
      std::uint32_t index = 0;
    };

    std::array<double, 3> force{};
    double                stored_energy = 0., dissipation_power = 0., penetration = 0.;
    double                released_energy = 0.; // J, in this call
    std::size_t           n_touching = 0, n_tested = 0, n_active = 0;
    std::vector<double>   patch_pressures;
    LargestPoint          largest_point;
    std::uint32_t         deepest_point = 0, deepest_facet = 0; ///< of `penetration`

    void clear(const std::size_t n_patches)
    {
      force         = {};
      stored_energy = dissipation_power = penetration = released_energy = 0.;
      n_touching = n_tested = n_active = 0;
      largest_point                    = {};
      patch_pressures.assign(n_patches, 0.);
    }
  };
} // namespace birdstrike
