#include "simulation/balance.h"
#include <birdstrike/core/errors.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    using Vector = MomentumReport::Vector;

    double norm(const Vector &a)
    {
      return std::hypot(a[0], a[1], a[2]);
    }

    double energy_of(const SystemState &state)
    {
      return state.bird.total() + state.blade.total() + state.contact_stored + state.contact_dissipated +
             state.self_contact_stored + state.self_contact_dissipated - state.bird.external_work -
             state.blade.external_work;
    }

    Vector sum_of(const SystemState &state, const std::array<Vector MomentumReport::*, 3> &kept,
                  Vector MomentumReport::*external)
    {
      Vector sum{};
      for (const MomentumReport *part : {&state.bird_momentum, &state.blade_momentum})
        for (int c = 0; c < 3; ++c)
          {
            for (const auto member : kept)
              sum[c] += (part->*member)[c];
            sum[c] -= (part->*external)[c];
          }
      return sum;
    }

    Vector momentum_of(const SystemState &state)
    {
      return sum_of(state, {&MomentumReport::momentum, &MomentumReport::retired, &MomentumReport::support_impulse},
                    &MomentumReport::external_impulse);
    }

    Vector angular_momentum_of(const SystemState &state)
    {
      return sum_of(
        state, {&MomentumReport::angular_momentum, &MomentumReport::retired_moment, &MomentumReport::support_moment},
        &MomentumReport::external_moment);
    }

    double largest_norm(const SystemState &state, const std::initializer_list<Vector MomentumReport::*> members)
    {
      double largest = 0.;
      for (const MomentumReport *part : {&state.bird_momentum, &state.blade_momentum})
        for (const auto member : members)
          largest = std::max(largest, norm(part->*member));
      return largest;
    }

    double relative_distance(const Vector &now, const Vector &reference, const double scale)
    {
      const Vector difference{now[0] - reference[0], now[1] - reference[1], now[2] - reference[2]};
      return scale > 0. ? norm(difference) / scale : 0.;
    }

    /// Of the sums of m |v| and m |x| |v|: momenta that are smaller count as so much.
    constexpr double smallest_share = 1e-2;

    struct Kind
    {
      const char *name;
      double      value;
    };

    /// What cannot be negative.
    std::array<Kind, 15> kinds_of(const SystemState &state)
    {
      const EnergyReport &bird = state.bird, &blade = state.blade;
      return {{{"bird_kinetic", bird.kinetic},
               {"bird_elastic", bird.elastic},
               {"bird_dissipated", bird.dissipated},
               {"bird_retired", bird.retired},
               {"blade_kinetic", blade.kinetic},
               {"blade_elastic", blade.elastic},
               {"blade_plastic", blade.plastic},
               {"blade_hourglass", blade.hourglass},
               {"blade_viscous", blade.viscous},
               {"blade_damped", blade.dissipated},
               {"blade_eroded", blade.eroded},
               {"contact_stored", state.contact_stored},
               {"contact_dissipated", state.contact_dissipated},
               {"self_contact_stored", state.self_contact_stored},
               {"self_contact_dissipated", state.self_contact_dissipated}}};
    }

    std::string advise(const SystemState &state)
    {
      const bool has_bird = norm(state.bird_momentum.momentum) + norm(state.bird_momentum.retired) > 0.;
      return std::string("Reduce ") + (has_bird ? "Time/Step scale and Time/Bird step scale" : "Time/Step scale") +
             ", and look at the last fields written.";
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
        reference_angular  = angular_momentum_of(state);
        has_reference      = true;
      }
    scale     = std::abs(reference_energy) + std::abs(state.bird.external_work) + std::abs(state.blade.external_work);
    error     = scale > 0. ? (current_energy - reference_energy) / scale : 0.;
    max_error = std::max(max_error, std::abs(error));
    most_dissipated = std::max(most_dissipated, state.contact_dissipated);
    fall            = std::max({fall, most_dissipated - state.contact_dissipated, state.contact_dissipation_fall});
    update_momenta();
    check(time, step);
  }

  void Balance::update_momenta()
  {
    const double momentum_scale =
      std::max({norm(reference_momentum),
                largest_norm(last, {&MomentumReport::momentum, &MomentumReport::contact_impulse,
                                    &MomentumReport::support_impulse, &MomentumReport::external_impulse}),
                smallest_share * (last.bird_momentum.impulse_scale + last.blade_momentum.impulse_scale)});
    error_of_momentum     = relative_distance(momentum_of(last), reference_momentum, momentum_scale);
    max_error_of_momentum = std::max(max_error_of_momentum, error_of_momentum);

    const double angular_scale =
      std::max({norm(reference_angular),
                largest_norm(last, {&MomentumReport::angular_momentum, &MomentumReport::support_moment,
                                    &MomentumReport::external_moment}),
                smallest_share * (last.bird_momentum.moment_scale + last.blade_momentum.moment_scale)});
    error_of_angular     = relative_distance(angular_momentum_of(last), reference_angular, angular_scale);
    max_error_of_angular = std::max(max_error_of_angular, error_of_angular);
  }

  void Balance::check(const double time, const unsigned long step) const
  {
    if (std::isinf(limit))
      return; // rows of the history only look
    const std::string when = fmt::format("at t = {:.6g} s, step {}", time, step);
    if (!(std::abs(error) <= limit))
      {
        const Origins from = origins();
        throw NumericalFailure(fmt::format(
          "The energy balance is lost: {:+.3g} of {:.6g} J {} (Time/Energy error limit {:.3g}).\n{}\n"
          "The error comes from the blade's elements with {:+.3g} J, the bird's density {:+.3g}, contact {:+.3g}, the "
          "steps in time {:+.3g}.\n{}",
          error, scale, when, limit, describe_parts(), from.blade, from.bird, from.contact, from.steps,
          advise(last) +
            (from.blade > 0.5 * std::abs(error) * scale
               ? "\nThe elements make it: crushed ones do so, and at strains of some per cent one-point bricks without "
                 "Blade/Element/Linear viscosity at steps near the largest stable one."
               : "")));
      }
    for (const Kind &kind : kinds_of(last))
      if (!(kind.value >= -negative_limit * scale))
        throw NumericalFailure(
          fmt::format("An energy that cannot be negative is: {} = {:.6g} J {} (limit {:.3g} J).\n{}\n{}", kind.name,
                      kind.value, when, -negative_limit * scale, describe_parts(), advise(last)));
    if (fall > negative_limit * scale)
      throw NumericalFailure(
        fmt::format("Contact has made energy: contact_dissipated has fallen by {:.6g} J to {:.6g} J "
                    "{} (limit {:.3g} J).\n{}\n{}",
                    fall, last.contact_dissipated, when, negative_limit * scale, describe_parts(), advise(last)));
  }

  std::string Balance::describe_parts() const
  {
    return fmt::format(
      "Bird: kinetic {:.6g}, elastic {:.6g}, dissipated {:.6g}, retired {:.6g}; blade: kinetic {:.6g}, elastic {:.6g}, "
      "plastic {:.6g},\nhourglass {:.6g}, viscous {:.6g}, damped {:.6g}, eroded {:.6g}, external work {:.6g}; contact: "
      "stored {:.6g}, dissipated {:.6g} J.",
      last.bird.kinetic, last.bird.elastic, last.bird.dissipated, last.bird.retired, last.blade.kinetic,
      last.blade.elastic, last.blade.plastic, last.blade.hourglass, last.blade.viscous, last.blade.dissipated,
      last.blade.eroded, last.blade.external_work, last.contact_stored, last.contact_dissipated);
  }

  Balance::Origins Balance::origins() const
  {
    const EnergyReport &bird = last.bird, &blade = last.blade;
    Origins             from{};
    from.blade   = blade.elastic + blade.plastic + blade.hourglass + blade.viscous + blade.eroded - blade.internal;
    from.bird    = bird.elastic + bird.dissipated + bird.retired_made - bird.internal;
    from.contact = last.contact_stored + last.contact_dissipated - contact_energy();
    from.steps   = current_energy - reference_energy - from.blade - from.bird - from.contact;
    return from;
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

  double Balance::contact_fall() const
  {
    return fall;
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

  double Balance::angular_momentum_error() const
  {
    return error_of_angular;
  }

  double Balance::max_angular_momentum_error() const
  {
    return max_error_of_angular;
  }

  const SystemState &Balance::state() const
  {
    return last;
  }
} // namespace birdstrike
