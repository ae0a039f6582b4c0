#include "simulation/stepper.h"
#include "simulation/scene.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/contact/self_contact.h>
#include <birdstrike/report/contact_watch.h>
#include <birdstrike/report/patch_forces.h>
#include <birdstrike/structure/blade.h>

namespace birdstrike
{
  // Steps of the blade within that of the bird are kicks and drifts of their own, so each may have its length: where
  // elements stiffen on the way, as a corner that loses its volume does within one step, the rest goes in shorter ones.
  void Stepper::advance(const Schedule &schedule)
  {
    if (schedule.n_bird > 1)
      return advance_with_several_bird_steps(schedule);
    const double half = 0.5 * schedule.step;
    double       step = schedule.blade_step(), blade_half = 0.5 * step;
    unsigned int n = schedule.n_blade;
    kick_bird(half, HalfKick::first, blade_half);
    for (unsigned int k = 0; k < n; ++k)
      {
        if (k > 0)
          kick_bird_by_contact(blade_half, HalfKick::first);
        kick_blade_by_contact(blade_half, HalfKick::first);
        kick_blade(blade_half, HalfKick::first);
        drift_bird(step);
        drift_blade(step);
        const bool is_last = k + 1 == n;
        if (is_last)
          update_neighbor_list();
        compute_blade_forces(step);   // elements may fail: contact meets the facets that are left
        compute_contact_forces(step); // at velocities of the drift, on both sides
        if (is_last)
          compute_bird_rates();
        kick_blade(blade_half, HalfKick::second);
        kick_blade_by_contact(blade_half, HalfKick::second);
        if (is_last)
          break;
        kick_bird_by_contact(blade_half, HalfKick::second);
        const unsigned int n_left = n - k - 1, n_needed = scene.divide_blade_steps(step, n_left);
        if (n_needed > n_left)
          {
            step *= double(n_left) / n_needed;
            blade_half = 0.5 * step;
            n          = k + 1 + n_needed;
          }
      }
    kick_bird(half, HalfKick::second, blade_half);
    done.particle_steps_not_done += (n - 1) * scene.n_particles_here();
  }

  void Stepper::advance_with_several_bird_steps(const Schedule &schedule)
  {
    const double step = schedule.bird_step(), half = 0.5 * step;
    kick_blade(0.5 * schedule.step, HalfKick::first);
    for (unsigned int k = 0; k < schedule.n_bird; ++k)
      {
        kick_bird(half, HalfKick::first, half);
        kick_blade_by_contact(half, HalfKick::first);
        drift_bird(step);
        drift_blade(step);
        update_neighbor_list();
        compute_contact_forces(step);
        compute_bird_rates();
        kick_blade_by_contact(half, HalfKick::second);
        kick_bird(half, HalfKick::second, half);
      }
    compute_blade_forces(schedule.step);
    kick_blade(0.5 * schedule.step, HalfKick::second);
    done.blade_not_done += schedule.n_bird - 1;
  }

  void Stepper::compute_initial_forces(const double step)
  {
    compute_blade_forces(step);
    compute_contact_forces(step);
    compute_bird_rates();
    done = {};
  }

  template <class Part, class Verb>
  void Stepper::timed(const Part &part, const std::size_t section, const Verb &verb)
  {
    if (!part)
      return;
    const Timings::Scope scope(timings, section);
    verb(*part);
  }

  template <class Verb>
  void Stepper::each_bird(const std::size_t section, const Verb &verb)
  {
    const Timings::Scope scope(timings, section);
    for (Projectile &each : scene.birds)
      if (each.is_here())
        verb(each);
  }

  void Stepper::kick_bird(const double half_step, const HalfKick half, const double contact_half)
  {
    each_bird(sections.bird_kick, [&](Projectile &each) { each.bird->kick(half_step, half, contact_half); });
  }

  void Stepper::kick_bird_by_contact(const double half_step, const HalfKick half)
  {
    each_bird(sections.bird_kick, [&](Projectile &each) { each.bird->kick_contact(half_step, half); });
  }

  void Stepper::kick_blade(const double half_step, const HalfKick half)
  {
    timed(scene.blade, sections.blade_kick, [&](Blade &blade) { blade.kick_internal(half_step, half); });
  }

  void Stepper::kick_blade_by_contact(const double half_step, const HalfKick half)
  {
    if (scene.has_contact())
      timed(scene.blade, sections.contact_kick, [&](Blade &blade) { blade.kick_contact(half_step, half); });
  }

  void Stepper::drift_bird(const double step)
  {
    const Timings::Scope scope(timings, sections.bird_drift);
    for (Projectile &each : scene.birds)
      if (each.bird)
        each.drift(step);
  }

  void Stepper::drift_blade(const double step)
  {
    timed(scene.blade, sections.blade_drift, [&](Blade &blade) { blade.drift(step); });
  }

  void Stepper::update_neighbor_list()
  {
    each_bird(sections.list, [](Projectile &each) { each.bird->update_neighbor_list(); });
  }

  void Stepper::compute_blade_forces(const double step)
  {
    if (!scene.blade || !scene.blade->is_deformable())
      return;
    timed(scene.blade, sections.blade_forces, [](Blade &blade) { blade.compute_internal_forces(); });
    timed(scene.self_contact, sections.self_contact, [&](SelfContact &contact) {
      contact.update(scene.blade->facets(), step);
      scene.blade->add_internal_forces(contact.forces());
    });
    ++done.blade;
  }

  void Stepper::compute_contact_forces(const double step)
  {
    if (!scene.has_contact())
      return;
    const Timings::Scope scope(timings, sections.contact);
    const NodeForces     on_blade = scene.blade->clear_contact_forces();
    const FacetsView     facets   = scene.blade->facets();
    std::size_t          n        = 0;
    for (Projectile &each : scene.birds)
      if (each.is_here())
        {
          each.contact->find(each.bird->points(), facets, step, scene.pool);
          ++n;
        }
    if (n > 1)
      weights.assign(facets.n_nodes, 0.);
    if (n > 1)
      for (const Projectile &each : scene.birds)
        if (each.is_here())
          each.contact->add_weights(weights);
    for (Projectile &each : scene.birds)
      if (each.is_here())
        each.contact->act(each.bird->points(), facets, step, {each.bird->clear_contact_forces(), on_blade}, scene.pool,
                          n > 1 ? &weights : nullptr);
    scene.add_up_contacts();
    if (watch)
      watch->update(scene.contact_report(), step);
    if (scene.patches)
      scene.patches->update(on_blade, step);
  }

  void Stepper::compute_bird_rates()
  {
    const std::size_t n = scene.n_particles_here();
    each_bird(sections.rates, [](Projectile &each) { each.bird->compute_rates(); });
    done.bird += n > 0;
    done.particle_steps += n;
    for (const Projectile &each : scene.birds)
      if (n > 0 && each.waits())
        done.particle_steps_waited += each.n_at_start;
  }

  void Stepper::end_contact()
  {
    if (!scene.blade)
      return;
    const NodeForces none = scene.blade->clear_contact_forces();
    if (scene.patches)
      scene.patches->update(none, 0.);
  }

  Stepper::Stepper(Scene &scene, Timings &timings, ContactWatch *const watch)
    : scene(scene)
    , timings(timings)
    , watch(watch)
    , sections{timings.section("bird: kick"),
               timings.section("blade: kick"),
               timings.section("blade: kick by contact"),
               timings.section("bird: drift"),
               timings.section("blade: drift"),
               timings.section("bird: neighbour list"),
               timings.section("blade: internal forces"),
               timings.section("blade: self-contact"),
               timings.section("contact"),
               timings.section("bird: rates")}
  {
  }

  const Stepper::Counts &Stepper::counts() const
  {
    return done;
  }

  Stepper::Seconds Stepper::seconds() const
  {
    const auto sum = [&](const auto... section) { return (timings.sections()[section].seconds + ...); };
    return {sum(sections.bird_kick, sections.bird_drift, sections.list, sections.rates),
            sum(sections.blade_kick, sections.blade_drift, sections.blade_forces, sections.self_contact,
                sections.contact_kick),
            sum(sections.contact)};
  }
} // namespace birdstrike
