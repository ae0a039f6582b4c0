#pragma once

#include <array>

namespace birdstrike
{
  /// Energies of one part at one instant (J). Absent kinds stay zero.
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
    double kinetic       = 0.; ///< translation and rotation, of the velocities at whole steps
    double staggering    = 0.; ///< see above; of either sign, small where the step resolves the motion
    double elastic       = 0.; ///< recoverable: of the stresses (blade), of the equation of state (bird)
    double plastic       = 0.; ///< plastic work
    double hourglass     = 0.; ///< work against hourglass stabilisation, stored or not (LS-DYNA: hourglass energy)
    double viscous       = 0.; ///< by the bulk viscosity of solid elements
    double dissipated    = 0.; ///< blade: by mass-proportional damping; bird: by artificial viscosity or Riemann flux
    double retired       = 0.; ///< energy of mass that left the computation
    double eroded        = 0.; ///< energy of failed elements
    double external_work = 0.; ///< by loads and prescribed motion
    double contact_work  = 0.; ///< by contact forces
    double internal      = 0.; ///< work of the part's own forces; no part of the sum
    double retired_made  = 0.; ///< what `retired` has of stored and dissipated energy more than of `internal`; neither

    double total() const
    {
      return kinetic + staggering + elastic + plastic + hourglass + viscous + dissipated + retired + eroded;
    }
  };

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
  };
} // namespace birdstrike
