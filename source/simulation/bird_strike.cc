#include "simulation/bird_strike.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/core/allocation_guard.h>
#include <birdstrike/core/log.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/patch_forces.h>
#include <birdstrike/report/text.h>
#include <birdstrike/structure/blade.h>

#include <spdlog/logger.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace birdstrike
{
  namespace
  {
    /// Sums over all entities (energies, momenta) every so many macro steps: a step changes them little, and they cost
    /// about as much as a step of the elements.
    constexpr unsigned long observation_stride = 10;

    /// Looking for particles that have left costs a pass over them: seldom enough not to count.
    constexpr unsigned long retirement_stride = 50;

#ifndef NDEBUG
    /// Steps until every buffer has its size. After them a list may outgrow its memory in one step, a thread meet its
    /// first touch or a bird that waited its blade; a loop that allocates does so in every step.
    constexpr unsigned long warm_up = 300, n_allocating_steps = 3;
#endif

    std::atomic<bool> stop_requested{false};
  } // namespace

  BirdStrike::BirdStrike(const CaseParameters &parameters, Scene &scene, const std::filesystem::path &folder,
                         Warnings case_warnings)
    : parameters(parameters)
    , scene(scene)
    , case_warnings(std::move(case_warnings))
    , stepper(scene, timings, &observed.contact)
    , sections{timings.section("removal of particles"), timings.section("stable time step"),
               timings.section("balance and output")}
    , guards(parameters, scene)
    , balance(parameters.time.energy_error_limit)
    , row_balance(INFINITY)
    , progress(parameters.time.end_time, parameters.output.console_interval)
  {
    if (!folder.empty())
      recorder.emplace(view(), folder);
    has_contact      = scene.has_contact();
    observed.contact = ContactWatch(parameters.output.channel_class);
  }

  void BirdStrike::run(const std::function<void(bool is_over)> &between_steps)
  {
    try
      {
        start();
        while ((why_ended = reason_to_stop()) == EndReason::none)
          {
            advance();
            if (between_steps)
              between_steps(false);
          }
        if (between_steps)
          between_steps(true);
        finish();
      }
    catch (NumericalFailure &failure)
      {
        failure.add_instant(now, n_steps);
        name_fastest(scene, failure);
        end_badly();
        throw;
      }
    catch (...)
      {
        end_badly();
        throw;
      }
  }

  void BirdStrike::end_badly()
  {
    progress.finish();
    try
      {
        if (recorder)
          recorder->flush();
      }
    catch (const std::exception &error) // must not hide what ended the run
      {
        log().error("{}", error.what());
      }
  }

  void BirdStrike::start()
  {
    if (is_started)
      return;
    is_started = true;
    if (scene.blade)
      observed.start(*scene.blade);
    plan();
    stepper.compute_initial_forces(schedule.bird_step());
    observe();
  }

  void BirdStrike::plan()
  {
    const Timings::Scope scope(timings, sections.votes);
    schedule = scene.plan(parameters.time.end_time - now);
  }

  void BirdStrike::step()
  {
    observed.contact.make_room(schedule.step);
#ifdef NDEBUG
    stepper.advance(schedule);
#else
    const std::uint64_t   lists = scene.n_list_changes();
    const AllocationGuard guard(n_steps >= warm_up);
    stepper.advance(schedule);
    n_allocated_steps =
      n_steps >= warm_up && guard.count() > 0 && scene.n_list_changes() == lists ? n_allocated_steps + 1 : 0;
    if (n_allocated_steps >= n_allocating_steps)
      throw std::logic_error("Steps that made no list have allocated memory:\n" + AllocationGuard::first_call_sites());
#endif
  }

  void BirdStrike::advance()
  {
    start();
    scene.wake_birds(now);
    plan();
    limiters.count(schedule.limiter, now);
    step();
    now += schedule.step;
    ++n_steps;
    for (Projectile &each : scene.birds)
      if (each.is_here() && each.contact && each.contact->report().n_touching > 0)
        each.last_touch = now;
    if (scene.has_contact() && n_steps % retirement_stride == 0)
      retire_particles();
    observe();
  }

  void BirdStrike::observe()
  {
    const Timings::Scope scope(timings, sections.output);
    guards.check_penetration(scene);
    for (const auto &table : scene.histories.tables)
      table->follow();
    if (scene.blade)
      observed.update_peaks(*scene.blade, scene.has_contact(), now);
    const bool is_sample = n_steps % observation_stride == 0, is_due = recorder && recorder->is_due(now);
    if (!is_sample && !is_due)
      return;
    const SystemState state = scene.state();
    if (is_sample)
      {
        guards.check_motion(scene, state.blade.kinetic);
        balance.update(state, now, n_steps);
        observed.update_shares(balance, now);
      }
    if (recorder)
      record(state);
  }

  void BirdStrike::record(const SystemState &state)
  {
    if (recorder->is_due(now) || n_steps == 0)
      {
        row_balance.update(state, now, n_steps);
        if (scene.blade)
          observed.update_present(*scene.blade);
        if (recorder->record(view()))
          {
            observed.contact.start_row();
            if (scene.patches)
              scene.patches->start_row();
          }
      }
    recorder->flush_when_due(timings.wall());
    if (progress.is_due())
      progress.print({now, schedule.step, n_steps, balance.energy_error().now, schedule.limiter.brief()});
  }

  EndReason BirdStrike::reason_to_stop() const
  {
    const TimeParameters &limits = parameters.time;
    if (now >= limits.end_time * (1. - 1e-12))
      return EndReason::end_time;
    if (stop_requested)
      return EndReason::signal;
    if (limits.maximum_wall_time > 0. && timings.wall() > limits.maximum_wall_time)
      return EndReason::wall_time;
    // a later bird that has not struck yet may make a higher one: of a blade that has bent away it comes after its time
    if (limits.stop_at_tip_peak && observed.first_tip_peak.is_passed(now, limits.tip_peak_wait) &&
        std::ranges::none_of(scene.birds, &Projectile::is_to_come))
      return EndReason::tip_peak;
    return EndReason::none;
  }

  void BirdStrike::finish()
  {
    const Timings::Scope scope(timings, sections.output);
    const SystemState    state = scene.state();
    balance.update(state, now, n_steps);
    row_balance.update(state, now, n_steps);
    observed.update_shares(balance, now);
    observed.filter_force(parameters.output.channel_class);
    if (scene.blade)
      observed.update_present(*scene.blade);
    if (recorder)
      recorder->finish(view());
    progress.finish();
  }

  double BirdStrike::time() const
  {
    return now;
  }

  unsigned long BirdStrike::n_steps_done() const
  {
    return n_steps;
  }

  std::string BirdStrike::describe_step() const
  {
    const Schedule &plan = scene.last_plan();
    return "time step " + format_quantity(plan.step, "s") + " by " + plan.limiter.text();
  }

  void BirdStrike::forget_stop_requests()
  {
    stop_requested = false;
  }

  void BirdStrike::request_stop()
  {
    stop_requested = true;
  }
} // namespace birdstrike
