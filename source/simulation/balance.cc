#include <birdstrike/core/errors.h>
#include <birdstrike/simulation/balance.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    double norm(const std::array<double, 3> &a)
    {
      return std::hypot(a[0], a[1], a[2]);
    }

    double energy_of(const SystemState &state)
    {
      return state.bird.total() + state.blade.total() - state.bird.contact_work - state.blade.contact_work -
             state.bird.external_work - state.blade.external_work + state.self_contact_stored +
             state.self_contact_dissipated;
    }

    std::array<double, 3> momentum_of(const SystemState &state)
    {
      std::array<double, 3> sum{};
      for (const MomentumReport *part : {&state.bird_momentum, &state.blade_momentum})
        for (int c = 0; c < 3; ++c)
          sum[c] += part->momentum[c] + part->retired[c] + part->support_impulse[c] - part->external_impulse[c];
      return sum;
    }

    double momentum_scale(const SystemState &state, const std::array<double, 3> &reference)
    {
      double scale = norm(reference);
      for (const MomentumReport *part : {&state.bird_momentum, &state.blade_momentum})
        scale = std::max({scale, norm(part->contact_impulse), norm(part->support_impulse), norm(part->external_impulse),
                          norm(part->momentum)});
      return scale;
    }
  } // namespace

  Balance::Balance(const double energy_error_limit) : limit(energy_error_limit)
  {
  }

  void Balance::update(const SystemState &state, const double time, const unsigned long step)
  {
    last           = state;
    current_energy = energy_of(state);
    if (!has_reference)
      {
        reference_energy   = current_energy;
        reference_momentum = momentum_of(state);
        has_reference      = true;
      }
    const double scale =
      std::abs(reference_energy) + std::abs(state.bird.external_work) + std::abs(state.blade.external_work);
    error     = scale > 0. ? (current_energy - reference_energy) / scale : 0.;
    max_error = std::max(max_error, std::abs(error));

    std::array<double, 3> difference = momentum_of(state);
    for (int c = 0; c < 3; ++c)
      difference[c] -= reference_momentum[c];
    const double momentum_size = momentum_scale(state, reference_momentum);
    error_of_momentum          = momentum_size > 0. ? norm(difference) / momentum_size : 0.;
    max_error_of_momentum      = std::max(max_error_of_momentum, error_of_momentum);
    check(time, step);
  }

  void Balance::check(const double time, const unsigned long step) const
  {
    if (std::abs(error) <= limit)
      return;
    throw NumericalFailure(fmt::format(
      "The energy balance is lost: {:+.3g} of the initial {:.6g} J at t = {:.6g} s, step {} (limit {:.3g}).\n"
      "Bird: kinetic {:.6g}, internal {:.6g}, retired {:.6g}; blade: kinetic {:.6g}, elastic {:.6g}, plastic {:.6g}, "
      "hourglass {:.6g},\n"
      "viscous {:.6g}, damped {:.6g}, eroded {:.6g}; contact {:.6g} J. Reduce Time/Step scale and Time/Bird step "
      "scale, and look at the last fields written.",
      error, reference_energy, time, step, limit, last.bird.kinetic, last.bird.elastic, last.bird.retired,
      last.blade.kinetic, last.blade.elastic, last.blade.plastic, last.blade.hourglass, last.blade.viscous,
      last.blade.dissipated, last.blade.eroded, contact_energy()));
  }

  double Balance::initial_energy() const
  {
    return reference_energy;
  }

  double Balance::energy() const
  {
    return current_energy;
  }

  double Balance::contact_energy() const
  {
    return -last.bird.contact_work - last.blade.contact_work;
  }

  double Balance::contact_dissipated() const
  {
    return last.contact_dissipated;
  }

  double Balance::energy_error() const
  {
    return error;
  }

  double Balance::max_energy_error() const
  {
    return max_error;
  }

  double Balance::momentum_error() const
  {
    return error_of_momentum;
  }

  double Balance::max_momentum_error() const
  {
    return max_error_of_momentum;
  }

  const SystemState &Balance::state() const
  {
    return last;
  }
} // namespace birdstrike
