#include "structure/elements/solid/elements.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text/number_text.h>

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

  unsigned int SolidGroup::axis_in_batch(const std::size_t element, const unsigned int axis) const
  {
    return thickness_axis.empty() ? axis : (axis + 5u - thickness_axis[element]) % 3u; // see with_third
  }

  Lanes SolidGroup::compute_scaled_frequency(const SolidModes<Lanes> &modes, const Lanes &rest_det,
                                             const Lanes &inverse_mass, const Lanes &drag,
                                             const MassFactors<Lanes> &factors, Lanes *const shape) const
  {
    const SolidGeometry<Lanes> geometry(modes);
    const Lanes                bound =
      compute_frequency_bound(geometry, rest_det, inverse_mass, drag, law, section.formulation, factors, shape);
    if (shape) // at least the distortion without factors
      *shape *= factors.axis[0] * factors.axis[1] * factors.axis[2];
    return bound;
  }

  Lanes SolidGroup::compute_frequency_at_rest(const std::size_t b, const MassFactors<Lanes> &factors) const
  {
    const SolidModes<Lanes> modes = modes_of_batch(b);
    Lanes                   drag;
    law.compute_viscous_pressure(Lanes(0.), SolidGeometry<Lanes>(modes).compute_height(), drag);
    return compute_scaled_frequency(modes, batches[b].rest_det, batches[b].inverse_mass, drag, factors);
  }

  /// Bounds of one batch whose elements have powers of 2 as factors over their axes.
  class SolidElements::Trial
  {
  public:
    /// `axis` of all elements of the mesh.
    Trial(const SolidGroup &group, const std::size_t b, const std::span<const unsigned int> axis) : group(group), b(b)
    {
      for (std::size_t k = 0; k < n_lanes; ++k)
        {
          const std::size_t element = group.element_of(b * n_lanes + k);
          axes[k]                   = group.axis_in_batch(element, axis[group.place.number[element]]);
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
      return group.compute_frequency_at_rest(b, factors);
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
    const SolidGroup                 &group;
    std::size_t                       b;
    std::array<unsigned int, n_lanes> axes;
  };

  void SolidElements::scale_masses(const std::span<const MassScale> scale)
  {
    check_size(scale.size(), n_elements());
    for (SolidGroup &group : groups)
      {
        group.mass_factors.resize(group.batches.size());
        for (std::size_t slot = 0; slot < group.batches.size() * n_lanes; ++slot)
          {
            const std::size_t element = group.element_of(slot);
            const auto [axis, factor] = scale[group.place.number[element]];
            if (axis > 2 || !(factor >= 1. && factor < 1e12))
              throw InputError("Solid elements: element " + std::to_string(group.place.number[element]) +
                               " has the mass factor " + number_text(factor) + " along axis " + std::to_string(axis) +
                               ".\nAllowed: 1 to 1e12 along 0, 1 or 2.");
            MassFactors<Lanes> &factors = group.mass_factors[slot / n_lanes];
            for (unsigned int k = 0; k < 3; ++k)
              {
                const bool is_scaled               = k == group.axis_in_batch(element, axis);
                factors.axis[k][slot % n_lanes]    = is_scaled ? factor : 1.;
                factors.inverse[k][slot % n_lanes] = is_scaled ? 1. / factor : 1.;
              }
          }
        group.update_bounds_at_rest();
      }
  }

  std::vector<double> SolidElements::compute_mass_factors(const std::span<const unsigned int> axis,
                                                          const double                        step) const
  {
    check_size(axis.size(), n_elements());
    std::vector<double> factors(n_elements());
    for (const SolidGroup &group : groups)
      for (std::size_t b = 0; b < group.batches.size(); ++b)
        {
          const Trial trial(group, b, axis);
          Lanes       too_small = 0., enough = trial.find_best_exponent();
          enough = select(trial.compute_frequency(too_small) * step <= Lanes(2.), Lanes(0.), enough);
          for (int k = 0; k < n_halvings; ++k)
            {
              const Lanes middle  = 0.5 * (too_small + enough);
              const auto  is_fine = trial.compute_frequency(middle) * step <= Lanes(2.);
              enough              = select(is_fine, middle, enough);
              too_small           = select(is_fine, too_small, middle);
            }
          for (std::size_t k = 0; k < group.n_elements_of(b); ++k)
            factors[group.place.number[b * n_lanes + k]] = std::exp2(lane(enough, k));
        }
    return factors;
  }

  double SolidElements::compute_reachable_step(const std::span<const unsigned int> axis) const
  {
    check_size(axis.size(), n_elements());
    Lanes largest = 0.;
    for (const SolidGroup &group : groups)
      for (std::size_t b = 0; b < group.batches.size(); ++b)
        {
          const Trial trial(group, b, axis);
          largest = max(largest, trial.compute_frequency(trial.find_best_exponent()));
        }
    return 2. / stdx::hmax(largest);
  }

  double SolidElements::edge_mass(const std::size_t element) const
  {
    const auto [group, k] = find(element);
    return 0.125 / lane(group.batches[k / n_lanes].inverse_mass, k % n_lanes);
  }
} // namespace birdstrike
