#include "simulation/bird_strike.h"
#include <birdstrike/report/closing.h>
#include <birdstrike/report/columns.h>

/// What a strike says of itself.
namespace birdstrike
{
  RunView BirdStrike::view() const
  {
    RunView run{parameters,
                observed,
                balance,
                row_balance,
                scene.blade.get(),
                scene.has_contact() ? &scene.contact_report() : nullptr,
                scene.self_contact != nullptr,
                &scene.histories};
    run.time       = now;
    run.n_steps    = n_steps;
    run.bird_step  = scene.last_plan().bird_step();
    run.blade_step = scene.last_plan().blade_step();
    for (const Projectile &each : scene.birds)
      {
        run.birds.push_back(each.report(scene.birds.size() > 1));
        run.bird_at_start.particles += each.at_start.particles;
        run.bird_at_start.mass += each.at_start.mass;
        run.bird_at_start.kinetic_energy += each.at_start.kinetic_energy;
        for (unsigned int d = 0; d < 3; ++d)
          run.bird_at_start.momentum[d] += each.at_start.momentum[d];
      }
    if (!scene.birds.empty())
      run.aim = scene.birds.front().aim;
    run.end_reason    = why_ended;
    run.n_blade_steps = stepper.counts().blade;
    run.n_bird_steps  = stepper.counts().bird;
    return run;
  }

  RunView BirdStrike::view_whole_run() const
  {
    RunView         run   = view();
    const UnitCosts costs = compute_unit_costs();
    run.wall              = timings.wall();
    run.particle_step     = costs.particle_step;
    run.element_step      = costs.element_step;
    run.skipped           = compute_skipped();
    run.limiters          = limiters.all();
    run.case_warnings     = case_warnings;
    return run;
  }

  Summary BirdStrike::compute_summary() const
  {
    return Summary(view_whole_run());
  }

  ToldText BirdStrike::closing_report() const
  {
    const RunView run     = view_whole_run();
    ToldText      closing = birdstrike::closing_report(run, Summary(run));
    closing.whole += "\n" + timings.table();
    return closing;
  }

  std::string BirdStrike::describe_columns() const
  {
    const RunView run = view();
    return birdstrike::describe_columns(&run);
  }
} // namespace birdstrike
