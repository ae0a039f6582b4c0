#pragma once

#include <birdstrike/core/energy_report.h>

#include <array>
#include <string>

namespace birdstrike
{
  /// What the whole system holds at one instant. Absent parts stay zero.
  struct SystemState
  {
    EnergyReport   bird, blade;
    MomentumReport bird_momentum, blade_momentum;
    double         contact_stored      = 0.; ///< J, in the penalty springs
    double         contact_dissipated  = 0.; ///< J, by damper and friction, at their own rates
    double         self_contact_stored = 0., self_contact_dissipated = 0.; ///< J, of the blade with itself
  };

  /// The ledger of a run. Energy is conserved as
  ///   sum of part totals + contact + self-contact - external work = const,   contact = -(sum of contact works),
  /// linear momentum as
  ///   sum of (carried + retired + given to supports) - external impulse = const.
  /// The contact part is stored in springs or dissipated by the damper: `contact_dissipated` must not fall.
  /// Errors are relative to the scale of the run: initial energy plus |external work|; largest of the initial momentum,
  /// the impulse through contact, the supports' and the loads' (all as norms).
  class Balance
  {
  public:
    explicit Balance(double energy_error_limit);

    /// Books a state; the first one is the reference.
    /// @throws NumericalFailure if the energy error passes the limit or is not a number.
    void update(const SystemState &state, double time, unsigned long step);

    double initial_energy() const;
    double energy() const; ///< of the last state, external work taken off (J)
    double contact_energy() const;
    double contact_dissipated() const;
    double energy_error() const; ///< relative, with sign: positive is gained
    double max_energy_error() const;
    double momentum_error() const;
    double max_momentum_error() const;

    const SystemState &state() const;

  private:
    void check(double time, unsigned long step) const;

    double                limit;
    bool                  has_reference = false;
    SystemState           last;
    double                reference_energy = 0., current_energy = 0., error = 0., max_error = 0.;
    std::array<double, 3> reference_momentum{};
    double                error_of_momentum = 0., max_error_of_momentum = 0.;
  };
} // namespace birdstrike
