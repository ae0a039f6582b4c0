#include "simulation/bird_strike.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/contact/self_contact.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/structure/blade.h>

/// The state of a whole run by name.
namespace birdstrike
{
  namespace
  {
    /// Of a contact that has gone: what reports and costs still ask for.
    void archive_gone(Archive &archive, ContactReport &report)
    {
      const auto group = archive.group("gone contact");
      archive("force", report.force);
      archive("energies", report.stored_energy, report.dissipation_power, report.dissipated_energy,
              report.released_energy, report.staggering, report.dissipation_fall);
      archive("penetration", report.penetration, report.max_penetration, report.max_penetration_over_spacing);
      archive("peak force", report.peak_force, report.peak_force_time);
      archive("work", report.calls, report.skipped, report.searches, report.reused, report.pairs_listed,
              report.pairs_tested, report.points_near, report.points_active, report.touches);
    }
  } // namespace

  void Stepper::archive(Archive &archive)
  {
    const auto group = archive.group("stepper");
    archive("steps", done.bird, done.blade, done.particle_steps);
    archive("steps not done", done.particle_steps_not_done, done.blade_not_done, done.particle_steps_waited);
  }

  void Projectile::archive(Archive &archive, const Blade *const blade)
  {
    const auto group   = archive.group("bird " + std::to_string(number));
    bool       is_gone = bird == nullptr;
    archive("has gone", is_gone);
    if (archive.is_reading() && bird && is_gone)
      drop();
    archive("waits", is_waiting);
    archive("extent", extent.low, extent.high);
    if (bird)
      bird->archive(archive);
    if (contact && !is_waiting)
      contact->archive(archive, bird->points(), blade->facets());
    smallest_step.archive(archive);
    archive("removed", n_retired, n_dropped);
    archive("gone at", time_gone);
    archive("steps", n_steps_with);
    archive("last touch", last_touch);
    archive("reachable impulse", reachable_impulse);
    birdstrike::archive(archive, "gone energy", gone_energy);
    birdstrike::archive(archive, "gone momentum", gone_momentum);
    archive_gone(archive, gone_contact);
  }

  void Scene::archive(Archive &archive)
  {
    if (blade)
      blade->archive(archive);
    for (const auto &table : histories.tables)
      table->archive(archive);
    for (Projectile &each : birds)
      each.archive(archive, blade.get());
    add_up_contacts();
    if (self_contact)
      self_contact->archive(archive, blade->facets());
    const auto group = archive.group("plan");
    archive("step", latest.step);
    archive("sub-steps", latest.n_bird, latest.n_blade);
    archive("largest bird step", largest_bird_step);
    smallest_blade_step.archive(archive);
  }

  void BirdStrike::archive(Archive &archive)
  {
    if (archive.is_reading() && scene.blade)
      observed.start(*scene.blade); // of the undeformed blade
    scene.archive(archive);
    stepper.archive(archive);
    balance.archive(archive, "balance");
    row_balance.archive(archive, "balance of rows");
    observed.archive(archive);
    if (recorder)
      recorder->archive(archive);
    const auto group = archive.group("run");
    archive("time", now);
    archive("steps", n_steps);
    limiters.archive(archive);
    is_started = true;
  }

  void BirdStrike::require_sound_state() const
  {
    const SystemState state = scene.state();
    guards.check_motion(scene, state.blade.kinetic);
    Balance(balance).update(state, now, n_steps);
  }
} // namespace birdstrike
