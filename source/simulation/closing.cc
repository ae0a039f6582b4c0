#include "simulation/bird_strike.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/core/program.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/summary.h>
#include <birdstrike/report/text.h>
#include <birdstrike/structure/blade.h>

#include <fmt/format.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    std::string describe(const SkippedWork &work)
    {
      const std::string count =
        work.unit == "s" ? format_quantity(work.count, "s") : format_count(std::llround(work.count)) + " " + work.unit;
      return count + (std::isnan(work.saved) ? "" : ", saved about " + format_share(work.saved));
    }

    std::map<std::string, double> energy_parts(const Balance &balance)
    {
      const EnergyReport &bird = balance.state().bird, &blade = balance.state().blade;
      return {{"bird_kinetic", bird.kinetic},
              {"bird_elastic", bird.elastic},
              {"bird_dissipated", bird.dissipated},
              {"bird_retired", bird.retired},
              {"blade_kinetic", blade.kinetic},
              {"blade_elastic", blade.elastic},
              {"blade_plastic", blade.plastic},
              {"blade_hourglass", blade.hourglass},
              {"blade_eroded", blade.eroded},
              {"blade_viscous", blade.viscous},
              {"blade_damped", blade.damped},
              {"staggering", bird.staggering + blade.staggering},
              {"external_work", blade.external_work},
              {"contact_stored", balance.state().contact.elastic},
              {"contact_dissipated", balance.state().contact.dissipated},
              {"self_contact_stored", balance.state().self_contact.elastic},
              {"self_contact_dissipated", balance.state().self_contact.dissipated}};
    }
  } // namespace

  Summary BirdStrike::compute_summary() const
  {
    Summary summary;
    summary.case_name       = parameters.name;
    summary.program.version = program_identity().version;
    summary.program.build   = program_identity().build;
    summary.end.time        = now;
    summary.end.reason      = why_ended;
    if (scene.blade)
      {
        summary.blade.kind                 = blade_kinds().name(scene.blade->kind());
        summary.blade.elements             = scene.symmetry.factor() * scene.blade->n_elements();
        summary.blade.nodes                = scene.blade->n_nodes();
        summary.blade.mass                 = scene.symmetry.factor() * scene.blade->mass();
        summary.blade.added_rotary_inertia = scene.blade->census().mass_scaling.added_rotary_inertia;
      }
    summary.bird.particles      = scene.symmetry.factor() * n_particles_at_start;
    summary.bird.mass           = bird_mass;
    summary.bird.kinetic_energy = bird_kinetic;
    summary.bird.momentum       = bird_momentum;
    summary.steps.blade         = stepper.counts().blade;
    summary.steps.bird          = stepper.counts().bird;

    summary.tip.peak                     = observed.tip_peak.value();
    summary.tip.peak_time                = observed.tip_peak.time();
    summary.tip.final                    = observed.tip.mid_chord;
    summary.root.peak_normal_stress      = observed.root_stress.value();
    summary.root.peak_normal_stress_time = observed.root_stress.time();
    summary.root.peak_moment             = observed.root_moment.value();
    summary.root.peak_force              = observed.root_force.value();

    summary.contact.impulse         = balance.state().blade_momentum.contact_impulse;
    summary.contact.peak_force      = observed.contact.peak().value();
    summary.contact.peak_force_time = observed.contact.peak().time();
    summary.contact.max_penetration = observed.contact.max_penetration();
    if (n_particles_at_start > 0)
      summary.contact.max_penetration_over_spacing = observed.contact.max_penetration() / parameters.bird.spacing;

    summary.plastic.max_strain = observed.plastic.value;
    summary.plastic.position   = observed.plastic.position;
    summary.plastic.work       = balance.state().blade.plastic;

    summary.failed.elements  = observed.failure.n_elements;
    summary.failed.collapsed = observed.failure.n_collapsed;
    summary.failed.at_root   = observed.failure.n_at_root;
    summary.failed.mass      = observed.failure.mass;
    summary.failed.free_mass = observed.failure.free_mass;
    summary.failed.energy    = balance.state().blade.eroded;

    summary.energy.initial                      = balance.initial_energy();
    summary.energy.final                        = balance.energy();
    summary.energy.max_relative_error           = balance.energy_error().largest;
    summary.energy.max_hourglass_over_internal  = observed.hourglass_share.value();
    summary.energy.parts                        = energy_parts(balance);
    summary.momentum.max_relative_error         = balance.momentum_error().largest;
    summary.angular_momentum.max_relative_error = balance.angular_momentum_error().largest;
    summary.energy.bird_internal                = balance.state().bird.internal;
    const Balance::Origins from                 = balance.origins();
    summary.energy.error_origins                = {
                     {"blade", from.blade}, {"bird", from.bird}, {"contact", from.contact}, {"steps", from.steps}};

    summary.retired.particles = scene.symmetry.factor() * (n_retired + n_dropped);
    summary.retired.mass   = n_particles_at_start > 0 ? bird_mass * (n_retired + n_dropped) / n_particles_at_start : 0.;
    summary.retired.energy = balance.state().bird.retired;

    summary.skipped = compute_skipped();

    summary.cost.wall                 = timings.wall();
    summary.cost.threads              = parameters.time.n_threads();
    const UnitCosts costs             = compute_unit_costs();
    summary.cost.ns_per_particle_step = 1e9 * costs.particle_step;
    summary.cost.ns_per_element_step  = 1e9 * costs.element_step;
    summary.cost.peak_memory          = compute_peak_memory();
    return summary;
  }

  std::string BirdStrike::closing_report() const
  {
    const Summary summary = compute_summary();
    TextTable     table("Ended at t = " + format_quantity(now, "s") + ": " + why_ended);
    if (scene.symmetry.is_mirrored())
      table.add_heading(symmetry_sentence);
    if (scene.blade && scene.blade->is_deformable())
      {
        table.add_heading("Blade");
        table.add("tip peak (mid-chord)",
                  format_quantity(summary.tip.peak, "m") + " at " + format_quantity(summary.tip.peak_time, "s"));
        table.add("tip at the end", summary.tip.final, "m");
        table.add("root peak normal stress", format_quantity(summary.root.peak_normal_stress, "Pa") + " at " +
                                               format_quantity(summary.root.peak_normal_stress_time, "s"));
        table.add("root peak moment", summary.root.peak_moment, "N m");
        table.add("peak plastic strain",
                  fmt::format("{:.4f} at ({:.4g}, {:.4g}, {:.4g}) m", summary.plastic.max_strain,
                              summary.plastic.position[0], summary.plastic.position[1], summary.plastic.position[2]));
      }
    if (observed.failure.can_fail)
      {
        table.add_heading("Failure");
        table.add("failed elements",
                  fmt::format("{} of {}, {}", format_count(summary.failed.elements),
                              format_count(summary.blade.elements), format_quantity(summary.failed.mass, "kg")));
        if (summary.failed.collapsed > 0)
          table.add("  of these, collapsed", format_count(summary.failed.collapsed) + ": below the smallest step");
        table.add("mass flying free of all elements", summary.failed.free_mass, "kg");
        table.add("energy eroded with them", summary.failed.energy, "J");
        if (summary.failed.at_root > 0)
          table.add("failed at the root section", format_count(summary.failed.at_root) + ": their stress is zero");
        if (observed.failure.has_lost_tip)
          table.add("tip deflection", "of nodes that fly free");
      }
    if (n_particles_at_start > 0 && summary.contact.peak_force > 0.)
      {
        table.add_heading("Contact");
        table.add("impulse on the blade", fmt::format("({:.4g}, {:.4g}, {:.4g}) N s", summary.contact.impulse[0],
                                                      summary.contact.impulse[1], summary.contact.impulse[2]));
        table.add("peak force", format_quantity(summary.contact.peak_force, "N") + " at " +
                                  format_quantity(summary.contact.peak_force_time, "s"));
        table.add("largest penetration", fmt::format("{} ({:.3f} of the particle spacing)",
                                                     format_quantity(summary.contact.max_penetration, "m"),
                                                     summary.contact.max_penetration_over_spacing));
      }
    table.add_heading("Balance");
    table.add("initial energy", summary.energy.initial, "J");
    for (const auto &[part, value] : summary.energy.parts)
      if (value != 0.)
        table.add("  " + part, fmt::format("{} ({})", format_quantity(value, "J"),
                                           format_share(value / std::max(1e-300, std::abs(summary.energy.initial)))));
    table.add("largest energy error", format_share(summary.energy.max_relative_error));
    for (const auto &[origin, value] : summary.energy.error_origins)
      if (std::abs(value) > 1e-3 * std::abs(summary.energy.initial))
        table.add("  at the end, from " + origin,
                  format_quantity(value, "J") + " (" + format_share(value / std::abs(summary.energy.initial)) + ")");
    table.add("largest momentum error", fmt::format("{:.2e}", summary.momentum.max_relative_error));
    table.add("largest angular momentum error", fmt::format("{:.2e}", summary.angular_momentum.max_relative_error));
    table.add("hourglass over internal, at most", format_share(summary.energy.max_hourglass_over_internal));
    table.add_heading("Skipped");
    for (const SkippedWork &work : summary.skipped)
      table.add("skipped: " + work.what, describe(work));
    table.add("retired particles",
              format_count(summary.retired.particles) + " of " + format_count(summary.bird.particles));
    table.add_heading("Cost");
    table.add("steps", format_count(n_steps) + " macro, " + format_count(summary.steps.bird) + " bird, " +
                         format_count(summary.steps.blade) + " blade");
    table.add("per particle-step", fmt::format("{:.0f} ns", summary.cost.ns_per_particle_step));
    table.add("per element-step", fmt::format("{:.0f} ns", summary.cost.ns_per_element_step));
    table.add("peak memory", format_bytes(static_cast<double>(summary.cost.peak_memory)));
    return table.text() + "\n" + timings.table();
  }
} // namespace birdstrike
