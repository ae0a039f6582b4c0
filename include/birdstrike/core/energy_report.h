#pragma once

#include <array>

namespace birdstrike
{
  /// Energies of one part at one instant (J). Absent kinds stay zero. `external_work` is work done *on* the part by
  /// loads and prescribed motion, `contact_work` work done on it by contact forces. For each part
  ///   total() - external_work - contact_work = const,
  /// and what the parts give to contact, -sum of contact_work, is stored in the penalty springs or dissipated.
  ///
  /// Works are booked in the kicks, with the velocity of the drift: force^n . v^{n-1/2} dt_{n-1/2}/2 in the second
  /// half kick and force^n . v^{n+1/2} dt_{n+1/2}/2 in the first. The kinetic energy that closes against these sums is
  /// the product of neighbouring half-step velocities, m v^{n-1/2} . v^{n+1/2} / 2 (exactly, for a constant step).
  struct EnergyReport
  {
    double kinetic       = 0.; ///< translation and rotation
    double elastic       = 0.; ///< recoverable strain energy (blade) or whole internal energy (bird)
    double plastic       = 0.; ///< plastic work
    double hourglass     = 0.; ///< work against hourglass stabilisation
    double viscous       = 0.; ///< by the bulk viscosity of solid elements
    double dissipated    = 0.; ///< mass-proportional damping, viscosity that is not part of `elastic`
    double retired       = 0.; ///< energy of mass that left the computation
    double eroded        = 0.; ///< energy of failed elements
    double external_work = 0.; ///< by loads and prescribed motion
    double contact_work  = 0.; ///< by contact forces

    double total() const
    {
      return kinetic + elastic + plastic + hourglass + viscous + dissipated + retired + eroded;
    }
  };

  /// Linear momentum (N s) and angular momentum about the origin (N m s) of one part, with what left it or was taken
  /// by its supports: `momentum + support_impulse` of all parts stays constant when no external load acts.
  struct MomentumReport
  {
    std::array<double, 3> momentum{};         ///< carried by moving mass
    std::array<double, 3> angular_momentum{}; ///< about the origin
    std::array<double, 3> support_impulse{};  ///< time integral of the force that the part exerts *on* its supports
    std::array<double, 3> retired{};          ///< momentum of mass that left the computation
    std::array<double, 3> external_impulse{}; ///< time integral of loads on the part
    std::array<double, 3> contact_impulse{};  ///< time integral of contact forces on the part
  };
} // namespace birdstrike
