#include "simulation/bird_strike.h"
#include "simulation/projectile/bird_phase.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/core/log.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/text.h>
#include <birdstrike/structure/blade.h>

#include <spdlog/logger.h>

#include <algorithm>
#include <cmath>

/// The end of each bird's phase: particles that can meet nothing more leave the computation, and at last the bird does.
namespace birdstrike
{
  namespace
  {
    // In times that the bird takes to close in by its own diameter: a scene of other lengths and times, but the same
    // speeds, ends its phases as this one does. Of frontal.prm 2 ms and 0.1 ms.

    /// How far ahead the blade is carried on when its box is compared with the paths of particles.
    constexpr double retirement_horizon = 8.7;

    /// The bird's phase may end once nothing has touched for this long.
    constexpr double quiet_time = 0.44;
  } // namespace

  void BirdStrike::retire_particles()
  {
    const Timings::Scope scope(timings, sections.retirement);
    for (Projectile &each : scene.birds)
      if (each.is_here())
        retire_particles(each, std::min(retirement_horizon * each.passing_time(), parameters.time.end_time - now));
    if (!scene.has_contact())
      stepper.end_contact();
  }

  void BirdStrike::retire_particles(Projectile &projectile, const double horizon)
  {
    // without a facet nothing is left to meet: the bird's phase ends by itself
    if (projectile.parameters.retire && scene.blade->facets().n_facets > 0)
      {
        const bool          are_kept = parameters.output.removed_fly_on && parameters.output.bird_fields;
        const FieldSnapshot before   = are_kept ? view().bird_snapshot() : FieldSnapshot();
        const std::size_t   n        = projectile.bird->retire(scene.compute_reach_of_blade(now, horizon));
        if (are_kept && n > 0)
          observed.removed_particles.keep(before, view().bird_snapshot(), now);
        projectile.n_retired += n;
      }
    if (projectile.bird->n_particles() == 0 || is_bird_phase_over(projectile, horizon))
      end_phase_of(projectile);
  }

  void BirdStrike::end_phase_of(Projectile &projectile)
  {
    const std::size_t n_left = projectile.bird->n_particles();
    log().info("The phase of section '{}' ends at t = {}: {} particles are left, which could add at most {:.2g} N s. "
               "From here the blade continues without this bird.",
               projectile.parameters.section, format_quantity(now, "s"), n_left, projectile.reachable_impulse);
    const bool          are_kept = parameters.output.removed_fly_on && parameters.output.bird_fields && n_left > 0;
    const FieldSnapshot before   = are_kept ? view().bird_snapshot() : FieldSnapshot();
    projectile.n_retired += n_left;
    projectile.n_dropped = projectile.bird->state().size();
    projectile.drop();
    if (are_kept)
      observed.removed_particles.keep(before, view().bird_snapshot(), now);
    projectile.time_gone    = now;
    projectile.n_steps_with = n_steps;
  }

  bool BirdStrike::is_bird_phase_over(Projectile &projectile, const double horizon)
  {
    const auto  &given     = balance.state().blade_momentum.contact_impulse;
    const double tolerated = parameters.time.bird_phase_tolerance * std::hypot(given[0], given[1], given[2]);
    // of a blade that turns what is left may be met a turn later, and a later bird that has not struck yet may come to
    // a blade that has bent away: they stay until they are removed
    if (tolerated == 0. || now - projectile.last_touch < quiet_time * projectile.passing_time() ||
        scene.blade->rotor() != nullptr || projectile.is_to_come())
      return false;
    projectile.reachable_impulse = compute_reachable_impulse(projectile.bird->points(), scene.blade->facets(), horizon);
    return projectile.reachable_impulse <= tolerated;
  }
} // namespace birdstrike
