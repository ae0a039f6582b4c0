#pragma once

#include <birdstrike/core/step_limit.h>

namespace birdstrike
{
  class Blade;
  struct CaseParameters;
  class NumericalFailure;
  class Projectile;
  struct Scene;

  /// A node of the blade or a particle, and its speed (m/s).
  struct Mover
  {
    EntityPlace where;
    double      speed = 0.;
  };

  /// End a run in which a node or particle has run away, or a particle is stuck in the blade. Element groups and the
  /// particles' rates have guards of their own (elements turned inside out, densities), the parts' steps another
  /// (time_control/smallest_step.h), the ledger the last (report/balance.h).
  ///
  /// *Runaway.* No physics makes anything faster than
  ///   v_max = 10 v_0 + 2 c,
  /// v_0 the largest speed of a node or particle at first touch, or the blade's root mean square, sqrt(2 E_kin/m),
  /// where loads have made it faster; c the sound speed of a bar of the metal, sqrt(E/rho), or of the liquid's shock at
  /// v_0, c_0 + s v_0. Jets are what is fastest: a wedge of ideal liquid that closes at the angle beta jets with
  /// v_0 cot(beta/2) (Birkhoff, MacDougall, Pugh & Taylor, J. Appl. Phys. 19, 563, 1948), without bound where it
  /// grazes; a liquid with a sound speed lets none out before the line of contact is slower than the shock (Lesser,
  /// Proc. R. Soc. A 377, 289, 1981), and twice that is its jet.
  /// In the shipped cases and the scenes of tests/scenes/draw.py particles reach 1.9 v_0 and nodes 1.5 v_0, at most a
  /// tenth of the limit; what runs away grows from step to step. A position or velocity that is no number is refused
  /// likewise.
  ///
  /// *Stuck.* A particle deeper than Contact/Largest penetration below the surface that it met has come through it, or
  /// sits in it: contact remembers on which side it was (contact/narrow_phase.h). Shocks take 0.15 spacings in those
  /// scenes, and 0.5 at 1500 m/s in a liquid with a linear equation of state (contact/law.h).
  class Guards
  {
  public:
    /// On the scene as the clock starts.
    Guards(const CaseParameters &parameters, const Scene &scene);

    /// A pass over all nodes and particles. Throws NumericalFailure. `kinetic_energy`: J, the blade's.
    void check_motion(const Scene &scene, double kinetic_energy) const;

    /// What contact has just found. Throws NumericalFailure.
    void check_penetration(const Scene &scene) const;

  private:
    void check_penetration(const Projectile &projectile, const Blade &blade) const;

    double largest_penetration = 0.;                  ///< over a bird's spacing
    double initial_speed       = 0.;                  ///< m/s
    double liquid_sound_speed = 0., shock_slope = 0.; ///< c_0, m/s, and s
    double metal_sound_speed = 0.;                    ///< m/s
  };

  /// Into a failure that names no entity, such as the balance's.
  void name_fastest(const Scene &scene, NumericalFailure &failure);

  /// Of the whole scene; one whose motion is no number before all others.
  Mover find_fastest(const Scene &scene);
} // namespace birdstrike
