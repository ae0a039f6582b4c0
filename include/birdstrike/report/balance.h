#pragma once

#include <birdstrike/report/ledger.h>

#include <string>

namespace birdstrike
{
  /// The ledger of a run. Energy is conserved as
  ///   sum of part totals + stored and dissipated by contact and self-contact - external work = const,
  /// linear and angular momentum (about the origin) as
  ///   sum of (carried + retired + given to supports) - external = const.
  /// No kind of energy is taken from this sum (core/energy_report.h), so what it changes by is an error, and where it
  /// comes from can be told: each part's stored and dissipated energies against the work of its forces, contact's
  /// against the works of its impulses; the rest is of the steps in time.
  ///
  /// Errors are relative to the scale of the run: initial energy plus |external work|, of a blade that turns the
  /// strike as the hub sees it; largest of the initial momentum, that of one bird, the impulse through contact, the
  /// supports' and the loads' (all as norms), or a hundredth of the sum of m |v| if that is more: a free vibration has
  /// none. Of angular momentum the same with moments and the sum of m |x| |v|.
  ///
  /// A run ends where the energy error passes its limit, where a kind that cannot be negative is below -1e-3 of the
  /// scale (they are sums of squares and of dissipation rates: 1e-6 of round-off in pairs of floats, up to 1e-4 of
  /// trapezoids in time) or where contact has given back as much of what it had dissipated.
  class Balance
  {
  public:
    /// An infinite limit switches all checks off: for those who only look.
    explicit Balance(double energy_error_limit);

    static constexpr double negative_limit    = 1e-3; ///< -, share of the energy scale
    static constexpr double least_of_rotation = 1e-5; ///< -, share of a driven rotation that the scale is at least

    /// Books a state; the first one is the reference.
    /// @throws NumericalFailure if a limit is passed or the energy is not a number.
    void update(const SystemState &state, double time, unsigned long step);

    double initial_energy() const;
    double energy() const; ///< of the last state, external work taken off (J)

    struct RelativeError
    {
      double now     = 0.; ///< of energy with sign: positive is gained
      double largest = 0.; ///< absolute value over all updates

      void update(double value);
    };
    const RelativeError &energy_error() const;
    const RelativeError &momentum_error() const;
    const RelativeError &angular_momentum_error() const;

    double energy_scale() const ///< J, of the run: what errors are relative to
    {
      return scale;
    }
    double contact_energy() const; ///< J, by the works of its impulses

    /// Where an energy error comes from (J): what stored and dissipated energies are more than the work behind them.
    struct Origins
    {
      double blade, bird, contact, steps;
    };
    Origins origins() const;

    const SystemState &state() const;

    void archive(Archive &archive, const char *name);

  private:
    /// Linear momentum, or angular momentum.
    struct Momentum
    {
      std::array<double, 3> reference{};
      double                largest_of_one_body = 0.; ///< N s or N m s: birds from two sides may have none together
      RelativeError         error;
    };

    void update(Momentum &momentum, bool is_axial, double MomentumReport::*smallest_scale,
                double MomentumReport::*of_one_body);
    void check(double time, unsigned long step) const;
    /// J.
    double scale_of(const SystemState &state) const;

    double      limit;
    bool        has_reference = false;
    SystemState last;

    double        reference_energy = 0., reference_driven = 0., current_energy = 0., scale = 0.;
    double        most_dissipated = 0., fall = 0.; ///< J, by contact
    RelativeError error;
    Momentum      linear, angular;
  };
} // namespace birdstrike
