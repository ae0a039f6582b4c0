#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/core/simd/larger.h>
#include <birdstrike/report/balance.h>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace birdstrike
{
  namespace
  {
    using Vector = MomentumReport::Vector;

    double norm(const Vector &a)
    {
      return std::hypot(a[0], a[1], a[2]);
    }

    double external_work_of(const SystemState &state)
    {
      double sum = 0.;
      for (const PartOfSystem part : parts_of_system)
        sum += (state.*part).external_work;
      return sum;
    }

    double energy_of(const SystemState &state)
    {
      return state.self_contact.add_held(state.contact.add_held(state.bird.total() + state.blade.total())) -
             external_work_of(state);
    }

    /// What the work of a part's own forces has become, less that work.
    double made_by(const EnergyReport &part, const double work)
    {
      double sum = 0.;
      for (const EnergyKind &kind : energy_kinds)
        if (kind.is_of_own_work)
          sum += part.*kind.value;
      return sum - work;
    }

    Vector momentum_of(const SystemState &state, const bool is_axial)
    {
      Vector sum{};
      for (const MomentumReport *part : {&state.bird_momentum, &state.blade_momentum})
        for (const MomentumKind &kind : momentum_kinds)
          if (kind.is_axial == is_axial && kind.account != Account::memorandum)
            for (int c = 0; c < 3; ++c)
              sum[c] += (kind.account == Account::held ? 1. : -1.) * (part->*kind.value)[c];
      return sum;
    }

    double largest_norm(const SystemState &state, const bool is_axial)
    {
      double largest = 0.;
      for (const MomentumReport *part : {&state.bird_momentum, &state.blade_momentum})
        for (const MomentumKind &kind : momentum_kinds)
          if (kind.is_axial == is_axial && kind.is_scale)
            largest = larger(largest, norm(part->*kind.value));
      return largest;
    }

    double relative_distance(const Vector &now, const Vector &reference, const double scale)
    {
      const Vector difference{now[0] - reference[0], now[1] - reference[1], now[2] - reference[2]};
      return scale == 0. ? 0. : norm(difference) / scale;
    }

    /// Of the sums of m |v| and m |x| |v|: momenta that are smaller count as so much.
    constexpr double smallest_share = 1e-2;

    std::string describe(const SystemState &state)
    {
      std::string text;
      for (const LedgerEntry &entry : ledger)
        if (const double value = entry.value(state); value != 0.)
          text += fmt::format("{}{} {:.6g}", text.empty() ? "" : ", ", entry.column, value);
      return "Energies in J: " + text + ".";
    }

    struct Entry
    {
      std::string what;
      double      value;
    };

    /// The first entry of any account, memoranda too, that is no number; without words where there is none.
    Entry find_no_number(const SystemState &state)
    {
      static constexpr std::array<const char *, 4> parts{{"bird", "blade", "contact", "self-contact"}};
      for (std::size_t p = 0; p < parts.size(); ++p)
        for (const EnergyKind &kind : energy_kinds)
          if (const double value = state.*parts_of_system[p].*kind.value; !std::isfinite(value))
            return {std::string(parts[p]) + ", energy '" + kind.name + "'", value};
      for (const auto &[part, name] :
           {std::pair(&SystemState::bird_momentum, "bird"), {&SystemState::blade_momentum, "blade"}})
        for (const MomentumKind &kind : momentum_kinds)
          for (const double value : state.*part.*kind.value)
            if (!std::isfinite(value))
              return {std::string(name) + ", " + kind.name, value};
      return {};
    }

    std::string advise(const SystemState &state)
    {
      const bool has_bird = norm(state.bird_momentum.momentum) + norm(state.bird_momentum.retired) > 0.;
      return std::string("Reduce ") + (has_bird ? "Time/Step scale and Time/Bird step scale" : "Time/Step scale") +
             ", and check the last fields written.";
    }
  } // namespace

  Balance::Balance(const double energy_error_limit) : limit(energy_error_limit)
  {
  }

  /// Of a blade that turns, the strike as the hub sees it: its rotation may be thirty times as much, and the bird's
  /// energy in fixed axes next to nothing.
  double Balance::scale_of(const SystemState &state) const
  {
    const double driven = state.blade.driven, spun_up = driven - reference_driven;
    const double work = std::abs(external_work_of(state) - spun_up);
    if (driven == 0. && reference_driven == 0.)
      return std::abs(reference_energy) + work;
    const double strike = larger(std::abs(reference_energy - reference_driven), state.seen_from_hub);
    return larger(larger(scale, strike + work + std::abs(state.blade.kinetic - driven)), least_of_rotation * driven);
  }

  void Balance::update(const SystemState &state, const double time, const unsigned long step)
  {
    last           = state;
    current_energy = energy_of(state);
    if (!has_reference)
      {
        reference_energy  = current_energy;
        reference_driven  = state.blade.driven;
        linear.reference  = momentum_of(state, false);
        angular.reference = momentum_of(state, true);
        has_reference     = true;
      }
    scale = scale_of(state);
    error.update(scale == 0. ? 0. : (current_energy - reference_energy) / scale);
    most_dissipated = larger(most_dissipated, state.contact.dissipated);
    fall            = larger(larger(fall, most_dissipated - state.contact.dissipated), state.contact_dissipation_fall);
    update(linear, false, &MomentumReport::impulse_scale, &MomentumReport::largest_momentum);
    update(angular, true, &MomentumReport::moment_scale, &MomentumReport::largest_angular_momentum);
    check(time, step);
  }

  void Balance::RelativeError::update(const double value)
  {
    now     = value;
    largest = larger(largest, std::abs(value));
  }

  void Balance::update(Momentum &momentum, const bool is_axial, double MomentumReport::*const smallest_scale,
                       double MomentumReport::*const of_one_body)
  {
    momentum.largest_of_one_body = larger(momentum.largest_of_one_body, last.bird_momentum.*of_one_body);
    const double against =
      larger(larger(norm(momentum.reference), momentum.largest_of_one_body),
             larger(largest_norm(last, is_axial),
                    smallest_share * (last.bird_momentum.*smallest_scale + last.blade_momentum.*smallest_scale)));
    momentum.error.update(relative_distance(momentum_of(last, is_axial), momentum.reference, against));
  }

  void Balance::check(const double time, const unsigned long step) const
  {
    if (std::isinf(limit))
      return; // rows of the history only look
    const auto fail = [&](FailureFacts facts, const std::string &details = "", const std::string &advice = "") {
      facts.time    = time;
      facts.step    = step;
      facts.details = describe(last) + details;
      facts.advice  = advise(last) + advice;
      throw NumericalFailure(std::move(facts));
    };
    if (const auto [what, value] = find_no_number(last); !what.empty())
      fail({"An entry of the balance is no number", what, value, ""});
    if (!(std::abs(error.now) <= limit))
      {
        const Origins from = origins();
        fail({fmt::format("The energy balance, of {:.6g} J, is lost", scale), "energy error", error.now, "-", limit,
              "Time/Energy error limit"},
             fmt::format("\nThe error comes from the blade's elements with {:+.3g} J, the bird's density {:+.3g}, "
                         "contact {:+.3g}, the steps in time {:+.3g}.",
                         from.blade, from.bird, from.contact, from.steps),
             from.blade > 0.5 * std::abs(error.now) * scale
               ? " The elements make it: crushed ones do so, and at strains of some per cent one-point bricks without "
                 "Blade/Element/Linear viscosity at steps near the largest stable one."
               : "");
      }
    for (const LedgerEntry &entry : ledger)
      if (const double value = entry.value(last); entry.rules().is_positive && !(value >= -negative_limit * scale))
        fail({"An energy that cannot be negative is", std::string(entry.column), value, "J", -negative_limit * scale});
    if (!(fall <= negative_limit * scale))
      fail({"Contact has made energy", "fall of contact_dissipated", fall, "J", negative_limit * scale});
  }

  Balance::Origins Balance::origins() const
  {
    Origins from{};
    from.blade   = made_by(last.blade, last.blade.internal);
    from.bird    = made_by(last.bird, last.bird.internal);
    from.contact = made_by(last.contact, contact_energy()) + last.contact.staggering;
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

  const Balance::RelativeError &Balance::energy_error() const
  {
    return error;
  }

  const Balance::RelativeError &Balance::momentum_error() const
  {
    return linear.error;
  }

  const Balance::RelativeError &Balance::angular_momentum_error() const
  {
    return angular.error;
  }

  const SystemState &Balance::state() const
  {
    return last;
  }

  void Balance::archive(Archive &archive, const char *name)
  {
    const auto group = archive.group(name);
    archive("has reference", has_reference);
    birdstrike::archive(archive, "bird", last.bird);
    birdstrike::archive(archive, "blade", last.blade);
    birdstrike::archive(archive, "contact", last.contact);
    birdstrike::archive(archive, "self-contact", last.self_contact);
    birdstrike::archive(archive, "bird momentum", last.bird_momentum);
    birdstrike::archive(archive, "blade momentum", last.blade_momentum);
    archive("contact dissipation", most_dissipated, fall, last.contact_dissipation_fall);
    archive("energy", reference_energy, reference_driven, current_energy, scale);
    archive("reference momentum", linear.reference, angular.reference);
    archive("largest momentum of a bird", linear.largest_of_one_body, angular.largest_of_one_body);
    archive("errors", error.now, error.largest, linear.error.now, linear.error.largest, angular.error.now,
            angular.error.largest);
  }
} // namespace birdstrike
