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
  void Stepper::advance(const Schedule &schedule)
  {
    if (schedule.n_bird > 1)
      return advance_with_several_bird_steps(schedule);
    const double half = 0.5 * schedule.step, step = schedule.blade_step(), blade_half = 0.5 * step;
    kick_bird(half, HalfKick::first, blade_half);
    for (unsigned int k = 0; k < schedule.n_blade; ++k)
      {
        if (k > 0)
          kick_bird_by_contact(blade_half, HalfKick::first);
        kick_blade_by_contact(blade_half, HalfKick::first);
        kick_blade(blade_half, HalfKick::first);
        drift_bird(step);
        drift_blade(step);
        const bool is_last = k + 1 == schedule.n_blade;
        if (is_last)
          update_neighbor_list();
        compute_blade_forces(step);   // elements may fail: contact meets the facets that are left
        compute_contact_forces(step); // at velocities of the drift, on both sides
        if (is_last)
          compute_bird_rates();
        kick_blade(blade_half, HalfKick::second);
        kick_blade_by_contact(blade_half, HalfKick::second);
        if (!is_last)
          kick_bird_by_contact(blade_half, HalfKick::second);
      }
    kick_bird(half, HalfKick::second, blade_half);
    if (scene.bird)
      done.particle_steps_not_done += (schedule.n_blade - 1) * scene.bird->state().size();
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

  void Stepper::kick_bird(const double half_step, const HalfKick half, const double contact_half)
  {
    timed(scene.bird, sections.bird_kick, [&](Bird &bird) { bird.kick(half_step, half, contact_half); });
  }

  void Stepper::kick_bird_by_contact(const double half_step, const HalfKick half)
  {
    timed(scene.bird, sections.bird_kick, [&](Bird &bird) { bird.kick_contact(half_step, half); });
  }

  void Stepper::kick_blade(const double half_step, const HalfKick half)
  {
    timed(scene.blade, sections.blade_kick, [&](Blade &blade) { blade.kick_internal(half_step, half); });
  }

  void Stepper::kick_blade_by_contact(const double half_step, const HalfKick half)
  {
    timed(scene.contact, sections.contact_kick, [&](const Contact &) { scene.blade->kick_contact(half_step, half); });
  }

  void Stepper::drift_bird(const double step)
  {
    timed(scene.bird, sections.bird_drift, [&](Bird &bird) { bird.drift(step); });
  }

  void Stepper::drift_blade(const double step)
  {
    timed(scene.blade, sections.blade_drift, [&](Blade &blade) { blade.drift(step); });
  }

  void Stepper::update_neighbor_list()
  {
    timed(scene.bird, sections.list, [](Bird &bird) { bird.update_neighbor_list(); });
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
    timed(scene.contact, sections.contact, [&](Contact &contact) {
      const NodeForces on_blade = scene.blade->clear_contact_forces();
      contact.add_forces(scene.bird->points(), scene.blade->facets(), step,
                         {scene.bird->clear_contact_forces(), on_blade}, scene.pool);
      if (watch)
        watch->update(contact.report(), step);
      if (scene.patches)
        scene.patches->update(on_blade, step);
    });
  }

  void Stepper::compute_bird_rates()
  {
    timed(scene.bird, sections.rates, [&](Bird &bird) {
      bird.compute_rates();
      ++done.bird;
      done.particle_steps += bird.state().size();
    });
  }

  void Stepper::drop_bird()
  {
    if (scene.contact)
      {
        const NodeForces none = scene.blade->clear_contact_forces();
        if (scene.patches)
          scene.patches->update(none, 0.);
      }
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
