#include "structure/elements/solid/implementation.h"
#include <birdstrike/core/errors.h>

#include <algorithm>
#include <cmath>
#include <string>

// Selective mass scaling as the elements see it: their bound on the step with it, and the factors that a step needs.
namespace birdstrike
{
  namespace
  {
    constexpr int largest_exponent = 20; ///< of 2: more changes no step
    constexpr int n_halvings       = 30; ///< leave 2e-8 of the exponent

    void check_size(const std::size_t given, const std::size_t n_elements)
    {
      if (given != n_elements)
        throw InputError("Solid elements: mass scaling of " + std::to_string(given) + " elements, there are " +
                         std::to_string(n_elements) + ".");
    }
  } // namespace

  unsigned int SolidElements::Implementation::axis_in_batch(const std::size_t element, const unsigned int axis) const
  {
    return thickness_axis.empty() ? axis : (axis + 5u - thickness_axis[element]) % 3u; // see with_third
  }

  Lanes SolidElements::Implementation::compute_scaled_frequency(const SolidModes<Lanes> &modes, const Lanes &rest_det,
                                                                const Lanes &inverse_mass, const Lanes &drag,
                                                                const MassFactors<Lanes> &factors) const
  {
    const SolidGeometry<Lanes> geometry(modes);
    return compute_frequency_bound(geometry, rest_det, inverse_mass, drag, law, section.formulation, factors);
  }

  Lanes SolidElements::Implementation::compute_frequency_at_rest(const std::size_t         b,
                                                                 const MassFactors<Lanes> &factors) const
  {
    Vector3<Lanes> x[8];
    for (std::size_t k = 0; k < n_lanes; ++k)
      for (int i = 0; i < 8; ++i)
        for (int c = 0; c < 3; ++c)
          x[i][c][k] = records[cells[std::min(b * n_lanes + k, cells.size() - 1)][i]].value[c];
    const SolidModes<Lanes> modes(x);
    Lanes                   drag;
    law.compute_viscous_pressure(Lanes(0.), SolidGeometry<Lanes>(modes).compute_height(), drag);
    return compute_scaled_frequency(modes, batches[b].rest_det, batches[b].inverse_mass, drag, factors);
  }

  void SolidElements::Implementation::update_scaled_frequencies()
  {
    if (mass_factors.empty())
      return;
    for (Chunk &chunk : chunks)
      chunk.frequency = Lanes(0.);
    for (std::size_t b = 0; b < batches.size(); ++b)
      {
        batches[b].frequency = compute_frequency_at_rest(b, mass_factors[b]);
        Chunk &chunk         = chunks[b / batches_per_chunk];
        chunk.frequency      = max(chunk.frequency, batches[b].frequency);
      }
  }

  /// Bounds of one batch whose elements have powers of 2 as factors over their axes.
  class SolidElements::Implementation::Trial
  {
  public:
    Trial(const Implementation &elements, const std::size_t b, const std::span<const unsigned int> axis)
      : elements(elements), b(b)
    {
      for (std::size_t k = 0; k < n_lanes; ++k)
        {
          const std::size_t element = std::min(b * n_lanes + k, elements.cells.size() - 1);
          axes[k]                   = elements.axis_in_batch(element, axis[element]);
        }
    }

    Lanes compute_frequency(const Lanes &exponent) const
    {
      MassFactors<Lanes> factors;
      for (unsigned int a = 0; a < 3; ++a)
        for (std::size_t k = 0; k < n_lanes; ++k)
          {
            factors.axis[a][k]    = a == axes[k] ? std::exp2(lane(exponent, k)) : 1.;
            factors.inverse[a][k] = 1. / factors.axis[a][k];
          }
      return elements.compute_frequency_at_rest(b, factors);
    }

    Lanes find_best_exponent() const
    {
      Lanes best = 0., lowest = compute_frequency(best);
      for (int exponent = 1; exponent <= largest_exponent; ++exponent)
        {
          const Lanes frequency = compute_frequency(Lanes(double(exponent)));
          best                  = select(frequency < lowest, Lanes(double(exponent)), best);
          lowest                = min(frequency, lowest);
        }
      return best;
    }

  private:
    const Implementation             &elements;
    std::size_t                       b;
    std::array<unsigned int, n_lanes> axes;
  };

  void SolidElements::scale_masses(const std::span<const MassScale> scale)
  {
    Implementation &my = *implementation;
    check_size(scale.size(), n_elements());
    my.mass_factors.resize(my.batches.size());
    for (std::size_t e = 0; e < my.batches.size() * n_lanes; ++e)
      {
        const std::size_t element = std::min(e, n_elements() - 1);
        const auto [axis, factor] = scale[element];
        if (axis > 2 || !(factor >= 1. && factor < 1e12))
          throw InputError("Solid elements: element " + std::to_string(element) + " has the mass factor " +
                           std::to_string(factor) + " along axis " + std::to_string(axis) +
                           ".\nAllowed: 1 to 1e12 along 0, 1 or 2.");
        for (unsigned int k = 0; k < 3; ++k)
          {
            const bool is_scaled                                 = k == my.axis_in_batch(element, axis);
            my.mass_factors[e / n_lanes].axis[k][e % n_lanes]    = is_scaled ? factor : 1.;
            my.mass_factors[e / n_lanes].inverse[k][e % n_lanes] = is_scaled ? 1. / factor : 1.;
          }
      }
    my.update_scaled_frequencies();
  }

  std::vector<double> SolidElements::compute_mass_factors(const std::span<const unsigned int> axis,
                                                          const double                        step) const
  {
    const Implementation &my = *implementation;
    check_size(axis.size(), n_elements());
    std::vector<double> factors(n_elements());
    for (std::size_t b = 0; b < my.batches.size(); ++b)
      {
        const Implementation::Trial trial(my, b, axis);
        Lanes                       too_small = 0., enough = trial.find_best_exponent();
        enough = select(trial.compute_frequency(too_small) * step <= Lanes(2.), Lanes(0.), enough);
        for (int k = 0; k < n_halvings; ++k)
          {
            const Lanes middle  = 0.5 * (too_small + enough);
            const auto  is_fine = trial.compute_frequency(middle) * step <= Lanes(2.);
            enough              = select(is_fine, middle, enough);
            too_small           = select(is_fine, too_small, middle);
          }
        for (std::size_t k = 0; k < my.n_elements_of(b); ++k)
          factors[b * n_lanes + k] = std::exp2(lane(enough, k));
      }
    return factors;
  }

  double SolidElements::compute_reachable_step(const std::span<const unsigned int> axis) const
  {
    const Implementation &my = *implementation;
    check_size(axis.size(), n_elements());
    Lanes largest = 0.;
    for (std::size_t b = 0; b < my.batches.size(); ++b)
      {
        const Implementation::Trial trial(my, b, axis);
        largest = max(largest, trial.compute_frequency(trial.find_best_exponent()));
      }
    return 2. / stdx::hmax(largest);
  }

  double SolidElements::edge_mass(const std::size_t element) const
  {
    const Implementation &my = *implementation;
    return 0.125 / lane(my.batches[element / n_lanes].inverse_mass, element % n_lanes);
  }
} // namespace birdstrike
