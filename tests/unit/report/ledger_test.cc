#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/core/symmetry_plane.h>
#include <birdstrike/report/balance.h>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>
#include <string>

using namespace birdstrike;

namespace
{
  using Energies = std::array<double, sizeof(EnergyReport) / sizeof(double)>;
  using Momenta  = std::array<double, sizeof(MomentumReport) / sizeof(double)>;

  /// Different powers of two in all members, named or not: sums of them are exact.
  EnergyReport powers(const int first)
  {
    Energies values;
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = std::ldexp(1., first + static_cast<int>(k));
    return std::bit_cast<EnergyReport>(values);
  }
} // namespace

TEST(Ledger, EveryMemberIsDoubledByAPlaneOfSymmetry)
{
  const EnergyReport half  = powers(0);
  const auto         whole = std::bit_cast<Energies>(SymmetryPlane(true).whole(half));
  for (std::size_t k = 0; k < whole.size(); ++k)
    EXPECT_EQ(whole[k], std::ldexp(2., static_cast<int>(k))) << "member " << k;
  Momenta ones;
  ones.fill(1.);
  const auto of_whole = std::bit_cast<Momenta>(SymmetryPlane(true).whole(std::bit_cast<MomentumReport>(ones)));
  for (std::size_t k = 0; k < of_whole.size(); ++k)
    EXPECT_NE(of_whole[k], 1.) << "number " << k << " is neither doubled nor cancelled";
}

// The sums of balance.h, spelled out: powers of two make them exact.
TEST(Ledger, AddsUpWhatIsHeldLessWhatCameFromOutside)
{
  SystemState state;
  state.bird         = powers(0);
  state.blade        = powers(1);
  state.contact      = powers(2);
  state.self_contact = powers(3);
  double sum         = 0.;
  for (const EnergyReport &e : {state.bird, state.blade, state.contact, state.self_contact})
    sum += e.kinetic + e.staggering + e.elastic + e.plastic + e.hourglass + e.viscous + e.dissipated + e.damped +
           e.retired + e.eroded - e.external_work;
  Balance balance(INFINITY);
  balance.update(state, 0., 0);
  EXPECT_EQ(balance.energy(), sum);
  const EnergyReport &blade = state.blade, &bird = state.bird;
  EXPECT_EQ(balance.origins().blade, blade.elastic + blade.plastic + blade.hourglass + blade.viscous +
                                       blade.dissipated + blade.eroded + blade.retired_made - blade.internal);
  EXPECT_EQ(balance.contact_energy(), -bird.contact_work - blade.contact_work);
}

TEST(Ledger, NamesAreDifferentAndStandForWhatTheySay)
{
  SystemState state;
  state.bird          = powers(0);
  state.blade         = powers(20);
  state.contact       = powers(40);
  state.self_contact  = powers(60);
  const auto value_of = [&](const std::string &name) {
    const auto entry =
      std::find_if(ledger.begin(), ledger.end(), [&](const LedgerEntry &each) { return each.name == name; });
    return entry == ledger.end() ? NAN : entry->value(state);
  };
  EXPECT_EQ(value_of("bird_dissipated"), state.bird.dissipated);
  EXPECT_EQ(value_of("blade_damped"), state.blade.damped);
  EXPECT_EQ(value_of("contact_stored"), state.contact.elastic);
  EXPECT_EQ(value_of("self_contact_dissipated"), state.self_contact.dissipated);
  EXPECT_EQ(value_of("staggering"),
            state.bird.staggering + state.blade.staggering + state.contact.staggering + state.self_contact.staggering);
  std::set<std::string_view> names, columns;
  for (const LedgerEntry &entry : ledger)
    EXPECT_TRUE(names.insert(entry.name).second && columns.insert(entry.column).second) << entry.name;
}

TEST(Ledger, AnEnergyThatCannotBeNegativeStopsTheRun)
{
  for (const LedgerEntry &entry : ledger)
    if (entry.part != nullptr)
      {
        SystemState state;
        state.bird.kinetic = 1000.; // J
        Balance balance(10.);       // errors of the sum are not asked for
        balance.update(state, 0., 0);
        state.*entry.part.*entry.kind = -0.9e-3 * 1000.;
        EXPECT_NO_THROW(balance.update(state, 1e-4, 10)) << entry.name;
        state.*entry.part.*entry.kind = -1.1e-3 * 1000.;
        const bool may_be_negative    = entry.name == "external_work" || entry.name == "bird_internal";
        if (may_be_negative)
          EXPECT_NO_THROW(balance.update(state, 1e-4, 10)) << entry.name;
        else
          EXPECT_THROW(balance.update(state, 1e-4, 10), NumericalFailure) << entry.name;
      }
}
