#pragma once

#include <birdstrike/core/archive.h>

#include <array>
#include <cstddef>

namespace birdstrike
{
  /// Energies of one part, or of contact, at one instant (J). Absent kinds stay zero; `energy_kinds` says how each
  /// counts.
  ///
  /// No kind is what is left of the others: what is stored follows from stresses (blade), from density by the equation
  /// of state (bird) or from penetration (contact), what is dissipated from its own rate. So the sum over the parts and
  /// contact, less external work, is constant only as far as the computation is right; its change is an error.
  ///
  /// `internal` is the exception and no part of the sum: the work that the part's own forces have done, as codes book
  /// it that integrate an energy equation (LS-DYNA's internal energy). It closes against kinetic energy and works by
  /// construction. Against the sum of what is stored and dissipated it tells which part makes the error.
  ///
  /// Works are booked in the kicks, with the velocity of the drift: force^n . v^{n-1/2} dt_{n-1/2}/2 in the second half
  /// kick and force^n . v^{n+1/2} dt_{n+1/2}/2 in the first. With stored energies at x^n the leapfrog scheme conserves,
  /// of a linear system exactly,
  ///   m v^{n-1/2} . v^{n+1/2}/2 + stored^n = m |v^n|^2/2 - |f^n dt|^2/(8 m) + stored^n
  /// at constant dt (Hairer, Lubich & Wanner, Acta Numerica 2003, section 4). `kinetic` is that of v^n; the second term
  /// is `staggering`. When dt changes at t^n, the conserved sum changes by |f^n|^2 (dt_old^2 - dt_new^2)/(8 m), which
  /// nothing has gained or lost: `staggering` takes that off again, so that steps may vary.
  struct EnergyReport
  {
    double kinetic    = 0.; ///< translation and rotation, of the velocities at whole steps
    double staggering = 0.; ///< see above; of either sign, small where the step resolves the motion
    double elastic    = 0.; ///< recoverable: of stresses (blade), equation of state (bird), penalty springs (contact)
    double plastic    = 0.; ///< plastic work
    double hourglass  = 0.; ///< work against hourglass stabilisation, stored or not (LS-DYNA: hourglass energy)
    double viscous    = 0.; ///< by the bulk viscosity of solid elements
    double dissipated = 0.; ///< bird: by artificial viscosity or Riemann flux; contact: by dampers and friction
    double damped     = 0.; ///< by mass-proportional damping
    double retired    = 0.; ///< energy of mass that left the computation
    double eroded     = 0.; ///< energy of failed elements
    double external_work = 0.; ///< by loads and prescribed motion
    double contact_work  = 0.; ///< by contact forces
    double internal      = 0.; ///< work of the part's own forces; no part of the sum
    double driven = 0.; ///< of the kinetic energy, that of the hub's rotation at its present speed: no scale of errors
    double retired_made = 0.; ///< what `retired` has of stored and dissipated energy more than of `internal`; neither

    /// `sum` and all that is held (see energy_kinds), one kind after the other.
    double add_held(double sum) const;
    double total() const
    {
      return add_held(0.);
    }
  };

  /// How a kind of energy or momentum counts in what is conserved.
  enum class Account
  {
    held,      ///< on top
    external,  ///< taken off: what came from outside
    memorandum ///< no part of the sum
  };

  struct EnergyKind
  {
    double EnergyReport::*value;
    const char           *name; ///< in archives
    Account               account;
    bool                  is_positive;    ///< a sum of squares or of dissipation: below zero by an error only
    bool                  is_of_own_work; ///< what the work of the part's own forces (`internal`) has become
  };

  /// Every kind once. Sums are taken in this order.
  inline constexpr std::array<EnergyKind, 15> energy_kinds{{
    {&EnergyReport::kinetic, "kinetic", Account::held, true, false},
    {&EnergyReport::staggering, "staggering", Account::held, false, false},
    {&EnergyReport::elastic, "elastic", Account::held, true, true},
    {&EnergyReport::plastic, "plastic", Account::held, true, true},
    {&EnergyReport::hourglass, "hourglass", Account::held, true, true},
    {&EnergyReport::viscous, "viscous", Account::held, true, true},
    {&EnergyReport::dissipated, "dissipated", Account::held, true, true},
    {&EnergyReport::damped, "damped", Account::held, true, false},
    {&EnergyReport::retired, "retired", Account::held, true, false},
    {&EnergyReport::eroded, "eroded", Account::held, true, true},
    {&EnergyReport::external_work, "external work", Account::external, false, false},
    {&EnergyReport::contact_work, "contact work", Account::memorandum, false, false},
    {&EnergyReport::internal, "internal", Account::memorandum, false, false},
    {&EnergyReport::driven, "driven", Account::memorandum, true, false},
    {&EnergyReport::retired_made, "retired made", Account::memorandum, false, true},
  }};

  inline double EnergyReport::add_held(double sum) const
  {
    for (const EnergyKind &kind : energy_kinds)
      if (kind.account == Account::held)
        sum += this->*kind.value;
    return sum;
  }

  /// Linear momentum (N s) and angular momentum about the origin (N m s) of one part, with what left it or was taken
  /// by its supports: carried + given to supports + retired - external of all parts stays constant, contact being equal
  /// and opposite. Damping counts as external. Angular momentum is that of x^n and v^n, with rotary inertia of shells;
  /// kicks and drifts keep it as far as moments of internal forces vanish at the positions they act on.
  struct MomentumReport
  {
    using Vector = std::array<double, 3>;

    Vector momentum{};         ///< carried by moving mass
    Vector support_impulse{};  ///< time integral of the force that the part exerts *on* its supports
    Vector retired{};          ///< momentum of mass that left the computation
    Vector external_impulse{}; ///< time integral of loads on the part, and of mass-proportional damping
    Vector contact_impulse{};  ///< time integral of contact forces on the part

    Vector angular_momentum{}; ///< the same about the origin: carried,
    Vector support_moment{};   ///< given to supports, of held rotations too,
    Vector retired_moment{};   ///< gone with mass that left,
    Vector external_moment{};  ///< by loads and damping
    double impulse_scale = 0.; ///< sum of m |v| (N s): what momentum is small against
    double moment_scale  = 0.; ///< sum of m |x| |v| (N m s): what angular momentum is small against

    // Of bodies whose momenta may cancel in the sum.
    double largest_momentum         = 0.; ///< norm, of one body (N s)
    double largest_angular_momentum = 0.; ///< N m s
  };

  struct MomentumKind
  {
    MomentumReport::Vector MomentumReport::*value;
    const char                             *name;     ///< in archives
    bool                                    is_axial; ///< an angular momentum
    Account                                 account;
    bool                                    is_scale; ///< whether errors are measured against it
  };

  /// Every kind once.
  inline constexpr std::array<MomentumKind, 9> momentum_kinds{{
    {&MomentumReport::momentum, "momentum", false, Account::held, true},
    {&MomentumReport::retired, "retired", false, Account::held, false},
    {&MomentumReport::support_impulse, "support impulse", false, Account::held, true},
    {&MomentumReport::external_impulse, "external impulse", false, Account::external, true},
    {&MomentumReport::contact_impulse, "contact impulse", false, Account::memorandum, true},
    {&MomentumReport::angular_momentum, "angular momentum", true, Account::held, true},
    {&MomentumReport::retired_moment, "retired moment", true, Account::held, false},
    {&MomentumReport::support_moment, "support moment", true, Account::held, true},
    {&MomentumReport::external_moment, "external moment", true, Account::external, true},
  }};
  inline constexpr std::array momentum_scales{&MomentumReport::impulse_scale, &MomentumReport::moment_scale};
  inline constexpr std::array largest_momenta{&MomentumReport::largest_momentum,
                                              &MomentumReport::largest_angular_momentum};

  template <class Kinds>
  consteval bool are_distinct(const Kinds &kinds)
  {
    for (std::size_t a = 0; a < kinds.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (kinds[a].value == kinds[b].value)
          return false;
    return true;
  }

  // A member that no table names would be doubled by no plane of symmetry and counted in no sum.
  static_assert(sizeof(EnergyReport) == sizeof(double) * energy_kinds.size() && are_distinct(energy_kinds));
  static_assert(sizeof(MomentumReport) == sizeof(MomentumReport::Vector) * momentum_kinds.size() +
                                            sizeof(double) * (momentum_scales.size() + largest_momenta.size()) &&
                are_distinct(momentum_kinds));

  /// Of several parts together.
  void add(EnergyReport &sum, const EnergyReport &one);
  void add(MomentumReport &sum, const MomentumReport &one);

  void archive(Archive &archive, const char *name, EnergyReport &energy);
  void archive(Archive &archive, const char *name, MomentumReport &momentum);
} // namespace birdstrike
