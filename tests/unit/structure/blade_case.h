#pragma once

#include <birdstrike/structure/blade.h>
#include <birdstrike/structure/parameters.h>

#include <cmath>
#include <string>
#include <vector>

/// Blades and loops that several tests of this room share.
namespace birdstrike::test
{
  /// The plate of benchmark A4 (Ti-6Al-4V-like, 311.2 x 88.9 x 4.27 mm), elastic, clamped at the root.
  BladeParameters elastic_plate(unsigned int n_span, unsigned int n_chord);
  /// The same, held nowhere.
  BladeParameters free_plate(unsigned int n_span, unsigned int n_chord);

  /// Velocity-Verlet without contact.
  void advance(Blade &blade, double dt, unsigned int n_steps);

  /// What a blade, shell or solid, comes to that vibrates under pressure and damping: its velocities, energies and
  /// angular momentum.
  template <class AnyBlade>
  std::vector<double> shake(BladeParameters p, unsigned int n_threads);

  bool is_bitwise_equal(const std::vector<double> &a, const std::vector<double> &b);

  /// total() - external_work - contact_work, which stays constant.
  double balance(const Blade &blade);
} // namespace birdstrike::test
