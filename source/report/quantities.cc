#include "report/quantities.h"
#include <birdstrike/contact/report.h>
#include <birdstrike/core/program.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/summary.h>
#include <birdstrike/structure/blade.h>

#include <limits>
#include <stdexcept>

namespace birdstrike
{
  namespace
  {
    using View       = Quantity::View;
    using Quantities = std::vector<Quantity>;

    constexpr double absent = std::numeric_limits<double>::quiet_NaN();

    const SystemState &state(View run)
    {
      return run.shown.state();
    }

    /// The lines of the ledger that speak of a part, but for what only a metal that fails has, or that alone.
    Quantities energies_of(const PartOfSystem part, const bool of_failure = false)
    {
      Quantities rows;
      for (const LedgerEntry &entry : ledger)
        if (entry.part == part && (entry.kind == &EnergyReport::eroded) == of_failure)
          rows.push_back(
            {std::string(entry.column),
             (entry.rules().account == Account::memorandum ? "energy/" : "energy/parts/") + std::string(entry.name),
             "J", &entry, "", std::string(entry.meaning)});
      return rows;
    }

    Quantities of_the_run()
    {
      return {
        {"", "case", "", [](View run) { return run.parameters.name; }},
        {"", "program/version", "", [](View) { return program_identity().version; }},
        {"", "program/build", "", [](View) { return program_identity().build; }},
        {"time", "end/time", "s", [](View run) { return run.time; }, "end time", "Time since first touch"},
        {"", "end/reason", "", [](View run) { return end_reasons().name(run.end_reason); }, "ended"},
        {"step", "", "-", [](View run) { return static_cast<double>(run.n_steps); }, "",
         "Number of time steps so far; of bird and blade the longer one where they are subcycled"},
        {"bird_step", "", "s", [](View run) { return run.has_bird() ? run.bird_step : 0.; }, "",
         "Present step of the bird"},
        {"blade_step", "", "s", [](View run) { return run.blade_step; }, "", "Present step of the blade"},
        {"", "blade/kind", "",
         [](View run) { return blade_kinds().name(run.blade ? run.blade->kind() : BladeKind::none); }, "blade"},
        {"", "blade/elements", "count", [](View run) { return run.blade ? run.blade->n_elements() : std::size_t(0); },
         "elements"},
        {"", "blade/nodes", "count", [](View run) { return run.blade ? run.blade->n_nodes() : std::size_t(0); }},
        {"", "blade/mass", "kg", [](View run) { return run.blade ? run.blade->mass() : 0.; }},
        {"", "blade/added_rotary_inertia", "share", // by selective mass scaling, of its own
         [](View run) { return run.blade ? run.blade->census().mass_scaling.added_rotary_inertia : 0.; }},
        {"", "steps/blade", "count", [](View run) { return run.n_blade_steps; }, "steps of the blade"},
        {"", "steps/bird", "count", [](View run) { return run.n_bird_steps; }, "steps of the bird"},
        {"", "energy/initial", "J", [](View run) { return run.balance.initial_energy(); }, "initial energy"},
        {"energy", "energy/final", "J", [](View run) { return run.shown.energy(); }, "",
         "Sum of all energies less external work: constant but for errors"},
        {"energy_error", "", "-", [](View run) { return run.shown.energy_error().now; }, "",
         "Change of the sum of all energies less external work, over the initial energy plus |external work|"},
        {"", "energy/max_relative_error", "share", [](View run) { return run.balance.energy_error().largest; },
         "largest energy error"},
        {"momentum_error", "", "-", [](View run) { return run.shown.momentum_error().now; }, "",
         "Change of the momentum that is carried, was taken along by removed particles and given to supports, less "
         "that of "
         "loads and damping, over its scale"},
        {"", "momentum/max_relative_error", "-", [](View run) { return run.balance.momentum_error().largest; },
         "largest momentum error"},
        {"angular_momentum_error", "", "-", [](View run) { return run.shown.angular_momentum_error().now; }, "",
         "Change of the angular momentum about the origin, as momentum_error"},
        {"", "angular_momentum/max_relative_error", "-",
         [](View run) { return run.balance.angular_momentum_error().largest; }, "largest angular momentum error"},
        {"", "cost/wall", "s", [](View run) { return run.wall; }, "run time"},
        {"", "cost/threads", "count", [](View run) { return std::size_t(run.parameters.time.n_threads()); }, "threads"},
        {"", "cost/ns_per_particle_step", "ns", [](View run) { return 1e9 * run.particle_step; }},
        {"", "cost/ns_per_element_step", "ns", [](View run) { return 1e9 * run.element_step; }},
        {"", "cost/peak_memory", "B", [](View) { return compute_peak_memory(); }, "peak memory"},
      };
    }

    /// Hourglass energy over what the blade holds of elastic, plastic, hourglass and viscous energy, at most.
    Quantities of_hourglass()
    {
      return {{"", "energy/max_hourglass_over_internal", "share",
               [](View run) { return run.observed.hourglass_share.value(); }, "hourglass over internal, at most"}};
    }

    Quantities of_particles()
    {
      return {
        {"", "bird/particles", "count", [](View run) { return run.bird_at_start.particles; }, "particles"},
        {"", "bird/mass", "kg", [](View run) { return run.bird_at_start.mass; }},
        {"", "bird/kinetic_energy", "J", [](View run) { return run.bird_at_start.kinetic_energy; }},
        {"", "bird/momentum", "N s", [](View run) { return run.bird_at_start.momentum; }},
        {"particles", "", "-", [](View run) { return double(run.n_particles()); }, "",
         "Particles of the bird that are computed still (of the whole with a symmetry plane)"},
      };
    }

    Quantities of_bird()
    {
      return {
        {"bird_momentum", "", "N s", [](View run) { return state(run).bird_momentum.momentum; }, "",
         "Momentum that the bird carries, global axes"},
        {"", "retired/particles", "count", [](View run) { return run.n_retired(); }},
        {"", "retired/mass", "kg", [](View run) { return run.retired_mass(); }},
        {"", "retired/energy", "J", [](View run) { return state(run).bird.retired; }},
      };
    }

    /// Peaks of the force are over every evaluation of contact, between rows too.
    Quantities of_force()
    {
      return {
        {"contact_force", "", "N", [](View run) { return run.observed.force; }, "",
         "Force of the bird on the blade at the row's time, global axes"},
        {"contact_force_peak", "", "N", [](View run) { return run.observed.contact.peak_since_row(); }, "",
         "Largest norm of the contact force since the row before, over every evaluation of contact"},
        {"contact_impulse", "contact/impulse", "N s",
         [](View run) { return state(run).blade_momentum.contact_impulse; }, "impulse on the blade",
         "Time integral of the contact force on the blade, global axes"},
        {"", "contact/peak_force", "N", [](View run) { return run.observed.contact.peak().value(); }, "peak force"},
        {"", "contact/peak_force_time", "s", [](View run) { return run.observed.contact.peak().time(); }},
        {"", "contact/filtered/class", "",
         [](View run) { return channel_classes().name(run.parameters.output.channel_class); }},
        {"", "contact/filtered/peak_force", "N",
         [](View run) {
           return run.observed.filtered_force.values.empty() ? absent : run.observed.filtered_force.peak;
         },
         "peak force, filtered"},
        {"", "contact/filtered/peak_time", "s",
         [](View run) {
           return run.observed.filtered_force.values.empty() ? absent : run.observed.filtered_force.peak_time;
         }},
      };
    }

    Quantities of_penetration()
    {
      return {
        {"points_in_contact", "", "-", [](View run) { return run.contact ? double(run.contact->n_touching) : 0.; }, "",
         "Pairs of particle and facet that touch"},
        {"penetration", "", "m", [](View run) { return run.contact ? run.contact->penetration : 0.; }, "",
         "Largest penetration of a particle now"},
        {"", "contact/released_energy", "J", [](View run) { return run.contact ? run.contact->released_energy : 0.; },
         "lost by contact springs"},
        {"", "contact/max_penetration", "m", [](View run) { return run.observed.contact.max_penetration(); },
         "largest penetration"},
        {"", "contact/max_penetration_over_spacing", "-",
         [](View run) { return run.observed.contact.max_penetration_over_spacing(); },
         "largest penetration over spacing"},
      };
    }

    /// Whether the curve has come down since: the largest value at the last instant may be on its way up, and one
    /// before it may be no more than a first swing backwards while the bird pushes. What has never left zero has no
    /// peak (null): a blade without this section, or one that holds it.
    template <class AnyPeak>
    std::optional<bool> is_reached(const AnyPeak &peak, View run, const bool may_rise)
    {
      return peak.value() == 0. ? std::nullopt : std::optional(peak.time() < run.time && !may_rise);
    }

    /// Signs and frames: structure/reports.h. Peaks are over all macro steps: of the tip the largest deflection either
    /// way, with its sign, of the root the largest absolute values.
    Quantities of_blade()
    {
      return {
        {"blade_momentum", "", "N s", [](View run) { return state(run).blade_momentum.momentum; }, "",
         "Momentum that the blade carries, global axes"},
        {"support_impulse", "", "N s", [](View run) { return state(run).blade_momentum.support_impulse; }, "",
         "Time integral of the force that the blade exerts on its supports, global axes"},
        {"", "tip/peak", "m", [](View run) { return run.observed.tip_peak.value(); }, "peak (mid-chord)"},
        {"", "tip/peak_time", "s", [](View run) { return run.observed.tip_peak.time(); }, "time of the peak"},
        {"", "tip/peak_reached", "",
         [](View run) { return is_reached(run.observed.tip_peak, run, run.may_deflect_further()); }, "Tip peak"},
        {"tip_mid_chord", "", "m", [](View run) { return run.observed.tip.mid_chord; }, "",
         "Displacement of the tip row at mid-chord along its undeformed normal; positive away from the struck side"},
        {"", "tip/final", "m", [](View run) { return run.observed.tip.mid_chord; }, "deflection at the end"},
        {"tip_leading", "", "m", [](View run) { return run.observed.tip.leading; }, "",
         "Displacement of the tip's corner where the chord begins (smaller y of a flat plate), as tip_mid_chord"},
        {"tip_trailing", "", "m", [](View run) { return run.observed.tip.trailing; }, "",
         "Displacement of the tip's corner where the chord ends, as tip_mid_chord"},
        {"root_normal_force", "", "N", [](View run) { return run.observed.root.normal_force; }, "",
         "Force of the blade on its clamped section along the span, tension positive"},
        {"root_transverse_force", "", "N", [](View run) { return run.observed.root.transverse_force; }, "",
         "Force of the blade on its clamped section along its normal, positive away from the struck side"},
        {"root_bending_moment", "", "N m", [](View run) { return run.observed.root.bending_moment; }, "",
         "Moment about normal x span at the section's middle; positive stretches the struck face"},
        {"root_peak_normal_stress", "", "Pa", [](View run) { return run.observed.root.peak_stress(); }, "",
         "Largest absolute value of the normal stress along the span in the root's elements, both faces"},
        {"", "root/peak_normal_stress", "Pa", [](View run) { return run.observed.root_stress.value(); },
         "peak normal stress"},
        {"", "root/peak_normal_stress_time", "s", [](View run) { return run.observed.root_stress.time(); },
         "time of the peak stress"},
        {"", "root/peak_normal_stress_reached", "",
         [](View run) { return is_reached(run.observed.root_stress, run, run.is_pushed()); },
         "Root peak normal stress"},
        {"", "root/peak_moment", "N m", [](View run) { return run.observed.root_moment.value(); },
         "peak bending moment"},
        {"", "root/peak_moment_reached", "",
         [](View run) { return is_reached(run.observed.root_moment, run, run.is_pushed()); }, "Root peak moment"},
        {"", "root/peak_force", "N", [](View run) { return run.observed.root_force.value(); }, "peak force"},
        {"max_plastic_strain", "plastic/max_strain", "-",
         [](View run) { return find_largest(run.observed.plastic).value; }, "peak plastic strain",
         "Largest equivalent plastic strain of any integration point"},
        {"", "plastic/position", "m", [](View run) { return find_largest(run.observed.plastic).position; }},
        {"", "plastic/work", "J", [](View run) { return state(run).blade.plastic; }, "plastic work"},
      };
    }

    Quantities of_failure()
    {
      return {
        {"failed_elements", "failed/elements", "count", [](View run) { return run.observed.failure.n_elements; },
         "failed elements", "Elements that have failed so far"},
        {"", "failed/collapsed", "count", [](View run) { return run.observed.failure.n_collapsed; },
         "  of these, collapsed"},
        {"", "failed/at_root", "count", [](View run) { return run.observed.failure.n_at_root; },
         "failed at the root section"},
        {"", "failed/partly", "count", [](View run) { return run.observed.failure.n_partly; },
         "elements that carry on with failed points"},
        {"", "failed/points", "count", [](View run) { return run.observed.failure.n_points; },
         "  failed points of theirs"},
        {"", "failed/partly_at", "m", [](View run) { return run.observed.failure.partly_at; }},
        {"", "failed/mass", "kg", [](View run) { return run.observed.failure.mass; }},
        {"", "failed/free_mass", "kg", [](View run) { return run.observed.failure.free_mass; },
         "mass flying free of all elements"},
        {"", "failed/fibre_mass", "kg", [](View run) { return run.observed.failure.fibre_mass; },
         "plies whose fibres have failed"},
        {"", "failed/matrix_mass", "kg", [](View run) { return run.observed.failure.matrix_mass; },
         "plies whose matrix has failed"},
        {"", "failed/energy", "J", [](View run) { return state(run).blade.eroded; }, "energy eroded with them"},
      };
    }

    Quantities make_all()
    {
      Quantities all;
      const auto add = [&](const Subject subject, Quantities rows) {
        for (Quantity &row : rows)
          {
            row.subject = subject;
            all.push_back(std::move(row));
          }
      };
      add(Subject::run, of_the_run());
      add(Subject::run, energies_of(nullptr));
      add(Subject::blade, of_hourglass());
      add(Subject::bird, of_particles());
      add(Subject::bird, energies_of(&SystemState::bird));
      add(Subject::bird, of_bird());
      add(Subject::contact, of_force());
      add(Subject::contact, energies_of(&SystemState::contact));
      add(Subject::contact, of_penetration());
      add(Subject::blade, energies_of(&SystemState::blade));
      add(Subject::self_contact, energies_of(&SystemState::self_contact));
      add(Subject::blade, of_blade());
      add(Subject::failure, energies_of(&SystemState::blade, true));
      add(Subject::failure, of_failure());
      return all;
    }
  } // namespace

  bool Quantity::is_vector() const
  {
    return std::holds_alternative<std::array<double, 3> (*)(View)>(value);
  }

  double Quantity::number(const RunView &run, const unsigned int component) const
  {
    if (const auto *entry = std::get_if<const LedgerEntry *>(&value))
      return (*entry)->value(run.shown.state());
    if (const auto *of = std::get_if<double (*)(View)>(&value))
      return (*of)(run);
    if (const auto *of = std::get_if<std::size_t (*)(View)>(&value))
      return static_cast<double>((*of)(run));
    return std::get<std::array<double, 3> (*)(View)>(value)(run)[component];
  }

  const std::vector<Quantity> &quantities()
  {
    static const std::vector<Quantity> all = make_all();
    return all;
  }

  const Quantity &quantity(const std::string_view key)
  {
    for (const Quantity &each : quantities())
      if (each.key == key)
        return each;
    throw std::logic_error("There is no quantity '" + std::string(key) + "'.");
  }
} // namespace birdstrike
