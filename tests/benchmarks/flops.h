#pragma once

#include <cstddef>

namespace birdstrike
{
  enum class SolidFormulation;
}

namespace birdstrike::benchmarks
{
  /// What one unit of work computes, and what it must move between caches and memory once the entities no longer fit:
  /// operational intensity is flops / bytes (Williams, Waterman & Patterson 2009).
  ///
  /// Flops: +, -, *, / and sqrt count one each, a fused multiply-add two; min, max, comparison, selection, negation and
  /// conversion none; exp and log 20 each.
  /// Bytes: every array that the unit reads or writes, once, 8 for a double; a value that is read and written counts
  /// twice. What neighbours share (particles, nodes) is counted once, as if the caches held it in between.
  struct Work
  {
    double flops = 0., bytes = 0.;
  };

  Work pair_loop_work(double n_true_neighbors);                   ///< Riemann rates, corrected, per particle
  Work particle_step_work(double n_true_neighbors);               ///< with kicks and drift
  Work particle_motion_work();                                    ///< one kick or drift, mean
  Work shell_work(bool is_plastic, unsigned int n_points);        ///< default formulation, per element
  Work full_shell_work(bool is_plastic, unsigned int n_points);   ///< fully integrated
  Work solid_work(SolidFormulation formulation, bool is_plastic); ///< solid-shells with 5 points
  Work contact_work(double n_pairs); ///< per near point with so many candidate facets; half of the points touch
} // namespace birdstrike::benchmarks
