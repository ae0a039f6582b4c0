#pragma once

#include <birdstrike/core/energy_report.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace birdstrike
{
  /// What the whole system holds at one instant. Absent parts stay zero. Of contact, and of the blade's with itself:
  /// what penalty springs store (elastic) and what dampers and friction took, from their own rates (dissipated).
  struct SystemState
  {
    EnergyReport   bird, blade, contact, self_contact;
    MomentumReport bird_momentum, blade_momentum;
    double         contact_dissipation_fall = 0.; ///< J, by which what dampers took has ever fallen
    double         seen_from_hub            = 0.; ///< J, of the bird at the start, for somebody on a hub that turns
  };

  using PartOfSystem = EnergyReport SystemState::*;

  inline constexpr std::array<PartOfSystem, 4> parts_of_system{
    {&SystemState::bird, &SystemState::blade, &SystemState::contact, &SystemState::self_contact}};

  /// A line of the ledger: an energy that is shown by name, in history.csv as a column and in summary.json below
  /// energy/parts. How it counts is a matter of its kind (energy_kinds).
  struct LedgerEntry
  {
    std::string_view name; ///< in summary.json
    PartOfSystem     part; ///< nullptr: of all parts together
    double EnergyReport::*kind;
    std::string_view      meaning;
    std::string_view      column = name;

    double value(const SystemState &state) const
    {
      double sum = part == nullptr ? 0. : state.*part.*kind;
      if (part == nullptr)
        for (const PartOfSystem one : parts_of_system)
          sum += state.*one.*kind;
      return sum;
    }
    const EnergyKind &rules() const
    {
      return *std::find_if(energy_kinds.begin(), energy_kinds.end(),
                           [this](const EnergyKind &each) { return each.value == kind; });
    }
  };

  /// In the order of the columns.
  inline constexpr std::array<LedgerEntry, 18> ledger{{
    {"staggering", nullptr, &EnergyReport::staggering,
     "What the energy that leapfrog conserves has besides, -|f dt|^2/(8 m) and what changes of the step did to it; of "
     "either sign"},
    {"bird_kinetic", &SystemState::bird, &EnergyReport::kinetic,
     "Kinetic energy of the bird, of the velocities at whole steps"},
    {"bird_elastic", &SystemState::bird, &EnergyReport::elastic,
     "Energy stored by compression, of the equation of state at the present densities"},
    {"bird_dissipated", &SystemState::bird, &EnergyReport::dissipated,
     "Heat of the artificial viscosity or of the Riemann flux, its rate summed up"},
    {"bird_internal", &SystemState::bird, &EnergyReport::internal,
     "Work of the bird's own forces (its energy equation); no part of the sum"},
    {"bird_retired", &SystemState::bird, &EnergyReport::retired,
     "Energy of particles that have left, all kinds together"},
    {"contact_stored", &SystemState::contact, &EnergyReport::elastic,
     "Energy in the penalty springs of contact, of the present penetration"},
    {"contact_dissipated", &SystemState::contact, &EnergyReport::dissipated,
     "Energy taken by dampers and friction of contact"},
    {"blade_kinetic", &SystemState::blade, &EnergyReport::kinetic,
     "Kinetic energy of the blade, rotation of shells included, of the velocities at whole steps"},
    {"blade_elastic", &SystemState::blade, &EnergyReport::elastic,
     "Recoverable energy of the blade's present stresses; of bricks with that of the stabilisation, which is their "
     "bending"},
    {"blade_plastic", &SystemState::blade, &EnergyReport::plastic, "Plastic work of the blade"},
    {"blade_hourglass", &SystemState::blade, &EnergyReport::hourglass,
     "Work on the hourglass stabilisation of shells, stored or not"},
    {"blade_viscous", &SystemState::blade, &EnergyReport::viscous, "Energy taken by the bulk viscosity of bricks"},
    {"blade_damped", &SystemState::blade, &EnergyReport::damped, "Energy taken by Blade/Loads/Damping"},
    {"external_work", &SystemState::blade, &EnergyReport::external_work,
     "Work of loads and driven supports on the blade; taken off the sum", "blade_external_work"},
    {"self_contact_stored", &SystemState::self_contact, &EnergyReport::elastic,
     "Energy in the springs between parts of the blade that meet"},
    {"self_contact_dissipated", &SystemState::self_contact, &EnergyReport::dissipated,
     "Energy taken by the dampers between parts of the blade that meet"},
    {"blade_eroded", &SystemState::blade, &EnergyReport::eroded, "Elastic energy that failed elements had"},
  }};

  static_assert(std::all_of(energy_kinds.begin(), energy_kinds.end(),
                            [](const EnergyKind &kind) {
                              return kind.account == Account::memorandum ||
                                     std::any_of(ledger.begin(), ledger.end(),
                                                 [&](const LedgerEntry &entry) { return entry.kind == kind.value; });
                            }),
                "a kind that counts in the sum is shown by no name");
} // namespace birdstrike
