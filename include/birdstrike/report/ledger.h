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
    {"staggering", nullptr, &EnergyReport::staggering},
    {"bird_kinetic", &SystemState::bird, &EnergyReport::kinetic},
    {"bird_elastic", &SystemState::bird, &EnergyReport::elastic},
    {"bird_dissipated", &SystemState::bird, &EnergyReport::dissipated},
    {"bird_internal", &SystemState::bird, &EnergyReport::internal},
    {"bird_retired", &SystemState::bird, &EnergyReport::retired},
    {"contact_stored", &SystemState::contact, &EnergyReport::elastic},
    {"contact_dissipated", &SystemState::contact, &EnergyReport::dissipated},
    {"blade_kinetic", &SystemState::blade, &EnergyReport::kinetic},
    {"blade_elastic", &SystemState::blade, &EnergyReport::elastic},
    {"blade_plastic", &SystemState::blade, &EnergyReport::plastic},
    {"blade_hourglass", &SystemState::blade, &EnergyReport::hourglass},
    {"blade_viscous", &SystemState::blade, &EnergyReport::viscous},
    {"blade_damped", &SystemState::blade, &EnergyReport::damped},
    {"external_work", &SystemState::blade, &EnergyReport::external_work, "blade_external_work"},
    {"self_contact_stored", &SystemState::self_contact, &EnergyReport::elastic},
    {"self_contact_dissipated", &SystemState::self_contact, &EnergyReport::dissipated},
    {"blade_eroded", &SystemState::blade, &EnergyReport::eroded},
  }};

  static_assert(std::all_of(energy_kinds.begin(), energy_kinds.end(),
                            [](const EnergyKind &kind) {
                              return kind.account == Account::memorandum ||
                                     std::any_of(ledger.begin(), ledger.end(),
                                                 [&](const LedgerEntry &entry) { return entry.kind == kind.value; });
                            }),
                "a kind that counts in the sum is shown by no name");
} // namespace birdstrike
