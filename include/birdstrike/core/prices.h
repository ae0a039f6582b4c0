#pragma once

#include <cstddef>

/// What a step of each kind of entity costs: the one table by which multirate chooses its ratio, `explain` foretells
/// the run time and "skipped" tells what was saved.
///
/// ns of one core, the smallest of several repetitions of the benchmark that is named beside each, at 10 000 entities:
/// AMD EPYC (Zen 4) with AVX-512, GCC 12, November 2026; the particles but Riemann's and yielding Belytschko-Tsay
/// shells, which beside the others cost 0.7 and 1.4 times as much on an Intel Xeon with AVX-512, are the geometric mean
/// of both. tests/benchmarks/prices.py compares them with a new measurement, in every run of tests/benchmarks/run.sh.
/// Constants and never clock readings: the same run takes the same steps anywhere.
namespace birdstrike::prices
{
  // of a particle: kicks, drift, its share of the neighbour list, rates
  constexpr double riemann_particle  = 195.; ///< bird/step/riemann
  constexpr double linear_particle   = 358.; ///< bird/step/linear
  constexpr double standard_particle = 222.; ///< bird/step/standard

  // of an element, its internal forces; "yielding" with five points through the thickness that all yield
  constexpr double physical_shell                  = 48.;  ///< shell/forces/physical/elastic
  constexpr double physical_shell_yielding         = 104.; ///< shell/forces/physical/plastic_5
  constexpr double belytschko_tsay_shell           = 43.;  ///< shell/forces/belytschko_tsay/elastic
  constexpr double belytschko_tsay_shell_yielding  = 107.; ///< shell/forces/belytschko_tsay/plastic_5
  constexpr double fully_integrated_shell          = 58.;  ///< shell/forces/fully_integrated/elastic
  constexpr double fully_integrated_shell_yielding = 299.; ///< shell/forces/fully_integrated/plastic_5
  constexpr double one_point_brick                 = 55.;  ///< solid/forces/one_point/elastic
  constexpr double one_point_brick_yielding        = 65.;  ///< solid/forces/one_point/plastic
  constexpr double b_bar_brick                     = 132.; ///< solid/forces/b_bar/elastic
  constexpr double b_bar_brick_yielding            = 179.; ///< solid/forces/b_bar/plastic
  constexpr double solid_shell                     = 52.;  ///< solid/forces/solid_shell/elastic
  constexpr double solid_shell_yielding            = 151.; ///< solid/forces/solid_shell/plastic

  // Of a whole run beside its steps, for `explain`: user time of the shipped cases on one core of an AMD EPYC (Zen 5),
  // November 2026, and the shares of the program's own sections in it; slopes, failing points and plies of perforation
  // and of the composite on an Intel Xeon that takes 1.31 times as long for frontal.
  constexpr double starting         = 0.22e9; ///< loading libraries, building a small scene
  constexpr double step             = 8e3;    ///< of any scene: sums, votes, history
  constexpr double field_byte       = 20.;    ///< before compression
  constexpr double contact_particle = 22.;    ///< a step, of a bird on a plate of one thickness
  constexpr double contact_on_slope = 110.;   ///< likewise, where the thickness changes from facet to facet
  constexpr double element_motion   = 20.;    ///< a step of an element's nodes
  constexpr double failing_point    = 110.;   ///< more of a point whose metal may fail, and hardens by rate and heat
  constexpr double ply              = 18.;    ///< more of each ply of a laminate, a step of an element

  /// Price of spray, which has few neighbours, over that of liquid.
  constexpr double spray_share = 0.25;

  // Memory of a run over that of its scene, bytes.
  constexpr double running          = 8e6;  ///< threads, histories, files
  constexpr double running_particle = 230.; ///< contact's memory
  constexpr double field_particle   = 240.; ///< a snapshot on its way to the disk
  constexpr double running_element  = 1500.;

  /// Memory, bytes, of state and neighbour list.
  constexpr double bytes_per_particle = 774.; ///< bird/step/riemann: bytes_per_particle

  // Largest memory while a scene is built, bytes, which is more than it keeps: resident set of `explain` with up to
  // 300 000 particles, 360 000 shells (physical, fully integrated), 160 000 bricks in one and in four layers (one
  // point, B-bar) over that of a small case. The dearest of each kind; others take 0.8 of it.
  constexpr double building_particle = 1110.; ///< explain
  constexpr double building_element  = 1250.; ///< explain
  constexpr double building_node     = 1080.; ///< explain
} // namespace birdstrike::prices

namespace birdstrike
{
  /// A step of the elements of a blade, ns: of all as they are, and what more it would take if all held points through
  /// the thickness. Registers of elements come to hold points together, but the price of a step counts those that have
  /// yielded themselves: which share a register hangs on the order of a mesh file, and the ratio of steps must not.
  struct ElementPrices
  {
    double      of_step = 0., of_points_spared = 0.;
    std::size_t n_elements = 0, n_with_points = 0;

    /// n elements, some with points, of which some have yielded; ns of one without and of one with them.
    void add(const std::size_t n, const std::size_t n_with, const std::size_t n_yielded, const double elastic,
             const double yielding)
    {
      of_step += elastic * static_cast<double>(n - n_yielded) + yielding * static_cast<double>(n_yielded);
      of_points_spared += (yielding - elastic) * static_cast<double>(n - n_with);
      n_elements += n;
      n_with_points += n_with;
    }
  };
} // namespace birdstrike
