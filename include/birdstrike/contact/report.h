#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// What contact did in its last call, and the peaks over all calls.
  struct ContactReport
  {
    std::array<double, 3> force{};                ///< N, on the facets
    double                stored_energy     = 0.; ///< J, sum of k d^2 / 2
    double                dissipation_power = 0.; ///< W, of dampers and friction
    std::size_t           n_touching        = 0;  ///< pairs of point and facet
    double                penetration       = 0.; ///< m, largest now
    std::vector<double>   patch_pressures;        ///< Pa, in the order of the parameter

    double peak_force                   = 0.; ///< N, largest norm
    double peak_force_time              = 0.; ///< s
    double max_penetration              = 0.; ///< m
    double max_penetration_over_spacing = 0.; ///< -

    std::uint64_t calls    = 0;
    std::uint64_t skipped  = 0; ///< calls in which points and facets were apart: no search, no forces
    std::uint64_t searches = 0; ///< candidate lists built
    std::uint64_t reused   = 0; ///< calls served by the last list
  };
} // namespace birdstrike
