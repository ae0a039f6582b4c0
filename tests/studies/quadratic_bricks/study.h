#pragma once

#include "part.h"

#include <array>
#include <vector>

namespace birdstrike::studies
{
  /// Lowest natural frequencies (Hz) of the plate clamped at x = 0, by subspace iteration (Bathe 1971). Of a shell
  /// those of bending and torsion.
  std::vector<double> compute_frequencies(Part &part, unsigned int n_modes);

  /// Motions of a free part of any shape that strain nothing: eigenvalues below 1e-9 of the largest. Six are rigid.
  unsigned int count_free_modes(Part &part);

  /// 2/omega_max (s) of the assembled part, free, by power iteration from `mode` [n][n_unknowns] (empty: a start of its
  /// own), which is improved.
  double compute_stable_step(Part &part, const double *position, unsigned int n_iterations, std::vector<double> &mode);

  /// Patch test (Irons): largest inner nodal force of a distorted brick mesh under uniform strain, over the largest at
  /// its boundary. At least 2 x 2 x 2 elements.
  double check_patch(const Part &part, const Plate &plate);

  /// A strained block of bricks after one turn in 72 steps: change of the nodal forces over what they were.
  double check_turning(Part &part);

  /// Force (N) along z that is the same on all of a disc, both faces alike: impulse over duration.
  struct Pulse
  {
    double impulse = 14., duration = 459e-6, station = 0.7, diameter = 40.7e-3; ///< N s, s, share of span, m
  };

  struct ImpulseResult
  {
    double      tip, plastic_work, hourglass_energy; ///< at the end: m at mid-chord, J
    double      energy_error;                        ///< largest |balance| over the work of the load
    double      peak, peak_time;                     ///< m, s: largest tip deflection
    std::size_t n_steps;
    double      seconds; ///< of the internal forces: steps times the median of a step, by the thread's clock
  };

  /// The plate under the pulse until `end_time`, central differences at 0.9 of the stable step: the element's own bound
  /// at every step, or the exact limit anew every 200 steps (not timed) where it has none.
  ImpulseResult run_impulse(Part &part, const Plate &plate, const Pulse &pulse, double end_time);

  /// Nanoseconds per element and call, least of many repetitions: a plate that goes to and fro (elastic) or stretches
  /// and bends on so that every point yields (plastic).
  double measure_cost(Part &part, bool is_plastic);

  /// Flops of a quadratic brick and step, counted by running it; rules in tests/benchmarks/flops.h.
  double count_quadratic_flops(const std::string &rule, bool is_plastic);
} // namespace birdstrike::studies
