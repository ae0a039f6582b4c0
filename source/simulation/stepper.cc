#include "simulation/stepper.h"
#include "simulation/contact_watch.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/contact/self_contact.h>
#include <birdstrike/structure/blade.h>

namespace birdstrike
{
  Stepper::Stepper(const Parts &parts, Timings &timings)
    : parts(parts)
    , timings(timings)
    , sections{timings.section("bird: rates"), timings.section("bird: kick and drift"),
               timings.section("blade: internal forces"), timings.section("blade: kick and drift"),
               timings.section("contact")}
  {
  }

  const Stepper::Counts &Stepper::counts() const
  {
    return done;
  }

  void Stepper::drop_bird()
  {
    if (parts.blade)
      {
        deliver();
        parts.blade->clear_contact_forces();
      }
    parts.bird    = nullptr;
    parts.contact = nullptr;
  }

  void Stepper::advance(const Schedule &schedule)
  {
    if (schedule.n_bird == 1)
      advance_with_sub_cycled_blade(schedule);
    else
      advance_with_sub_cycled_bird(schedule);
  }

  void Stepper::compute_initial_forces(const double step)
  {
    compute_blade_forces(step);
    compute_bird_forces(step);
    done = {};
  }

  void Stepper::advance_with_sub_cycled_blade(const Schedule &schedule)
  {
    if (parts.bird)
      done.particle_steps_not_done += (schedule.n_blade - 1) * parts.bird->state().size();
    const bool   is_held   = parts.contact && schedule.n_blade > 1;
    const double on_time   = in_transit + 0.5 * schedule.step; // s, of the present contact forces
    const double each_half = is_held ? 0.5 * on_time / schedule.n_blade : 0.;
    kick_bird(0.5 * schedule.step, HalfKick::first);
    if (!is_held)
      kick_contact(on_time, HalfKick::first);
    for (unsigned int k = 0; k < schedule.n_blade; ++k)
      step_blade(schedule.blade_step(), each_half, k + 1 == schedule.n_blade);
    if (parts.bird)
      {
        const Timings::Scope scope(timings, sections.bird_motion);
        parts.bird->drift(schedule.step);
      }
    compute_bird_forces(schedule.step); // at velocities of the drift, on both sides
    finish_blade_step(schedule.blade_step());
    kick_bird(0.5 * schedule.step, HalfKick::second);
    if (!is_held)
      kick_contact(0.5 * schedule.step, HalfKick::second);
    set_in_transit(is_held ? 0.5 * schedule.step : 0.);
  }

  void Stepper::advance_with_sub_cycled_bird(const Schedule &schedule)
  {
    const double step = schedule.bird_step();
    done.element_steps_not_done += (schedule.n_bird - 1) * parts.blade->n_elements();
    deliver();
    parts.blade->kick_internal(0.5 * schedule.step, HalfKick::first);
    for (unsigned int k = 0; k < schedule.n_bird; ++k)
      {
        kick_bird(0.5 * step, HalfKick::first);
        kick_contact(0.5 * step, HalfKick::first);
        parts.bird->drift(step);
        parts.blade->drift(step);
        compute_bird_forces(step);
        kick_bird(0.5 * step, HalfKick::second);
        kick_contact(0.5 * step, HalfKick::second);
      }
    compute_blade_forces(schedule.step);
    parts.blade->kick_internal(0.5 * schedule.step, HalfKick::second);
  }

  void Stepper::kick_bird(const double half_step, const HalfKick half)
  {
    if (!parts.bird)
      return;
    const Timings::Scope scope(timings, sections.bird_motion);
    parts.bird->kick(half_step, half);
  }

  void Stepper::kick_contact(const double half_step, const HalfKick half)
  {
    if (!parts.contact)
      return;
    const Timings::Scope scope(timings, sections.blade_motion);
    parts.blade->kick_contact(half_step, half);
  }

  void Stepper::set_in_transit(const double duration)
  {
    if (duration > 0. || in_transit > 0.)
      parts.blade->set_contact_in_transit(duration); // the forces are others, even if the duration is the same
    in_transit = duration;
  }

  void Stepper::deliver()
  {
    if (in_transit > 0.)
      kick_contact(in_transit, HalfKick::first);
    set_in_transit(0.);
  }

  void Stepper::finish_blade_step(const double step)
  {
    if (!parts.blade)
      return;
    const Timings::Scope scope(timings, sections.blade_motion);
    parts.blade->kick_internal(0.5 * step, HalfKick::second);
  }

  void Stepper::step_blade(const double step, const double contact_half, const bool is_last)
  {
    if (!parts.blade)
      return;
    {
      const Timings::Scope scope(timings, sections.blade_motion);
      if (contact_half > 0.)
        parts.blade->kick_contact(contact_half, HalfKick::first);
      parts.blade->kick_internal(0.5 * step, HalfKick::first);
      parts.blade->drift(step);
    }
    compute_blade_forces(step);
    {
      const Timings::Scope scope(timings, sections.blade_motion);
      if (contact_half > 0.)
        parts.blade->kick_contact(contact_half, HalfKick::second);
    }
    if (!is_last)
      finish_blade_step(step);
  }

  void Stepper::compute_blade_forces(const double step)
  {
    if (!parts.blade || !parts.blade->is_deformable())
      return;
    const Timings::Scope scope(timings, sections.blade_forces);
    parts.blade->compute_internal_forces();
    if (parts.self_contact)
      {
        parts.self_contact->update(parts.blade->facets(), step);
        parts.blade->add_internal_forces(parts.self_contact->forces());
      }
    ++done.blade;
    done.element_steps += parts.blade->n_elements();
  }

  void Stepper::compute_bird_forces(const double step)
  {
    if (!parts.bird)
      return;
    if (parts.contact)
      {
        const Timings::Scope scope(timings, sections.contact);
        parts.contact->add_forces(parts.bird->points(), parts.blade->facets(), step,
                                  {parts.bird->clear_contact_forces(), parts.blade->clear_contact_forces()},
                                  *parts.pool);
        if (parts.watch)
          parts.watch->update(parts.contact->report(), step);
      }
    const Timings::Scope scope(timings, sections.bird_rates);
    parts.bird->compute_rates();
    ++done.bird;
    done.particle_steps += parts.bird->state().size();
  }
} // namespace birdstrike
