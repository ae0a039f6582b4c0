#include "report/quantities.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
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
             "J", &entry});
      return rows;
    }

    Quantities of_the_run()
    {
      return {
        {"", "case", "", [](View run) { return run.parameters.name; }},
        {"", "program/version", "", [](View) { return program_identity().version; }},
        {"", "program/build", "", [](View) { return program_identity().build; }},
        {"time", "end/time", "s", [](View run) { return run.time; }, "end time"},
        {"", "end/reason", "", [](View run) { return end_reasons().name(run.end_reason); }, "ended"},
        {"step", "", "-", [](View run) { return static_cast<double>(run.n_steps); }},
        {"bird_step", "", "s", [](View run) { return run.bird ? run.bird_step : 0.; }},
        {"blade_step", "", "s", [](View run) { return run.blade_step; }},
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
        {"energy", "energy/final", "J", [](View run) { return run.shown.energy(); }},
        {"energy_error", "", "-", [](View run) { return run.shown.energy_error().now; }},
        {"", "energy/max_relative_error", "share", [](View run) { return run.balance.energy_error().largest; },
         "largest energy error"},
        {"momentum_error", "", "-", [](View run) { return run.shown.momentum_error().now; }},
        {"", "momentum/max_relative_error", "-", [](View run) { return run.balance.momentum_error().largest; },
         "largest momentum error"},
        {"angular_momentum_error", "", "-", [](View run) { return run.shown.angular_momentum_error().now; }},
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
        {"particles", "", "-", [](View run) { return run.bird ? double(run.bird->n_particles()) : 0.; }},
      };
    }

    Quantities of_bird()
    {
      return {
        {"bird_momentum", "", "N s", [](View run) { return state(run).bird_momentum.momentum; }},
        {"", "retired/particles", "count", [](View run) { return run.n_retired; }},
        {"", "retired/mass", "kg",
         [](View run) {
           const auto &all = run.bird_at_start;
           return all.particles > 0 ? all.mass * run.n_retired / all.particles : 0.;
         }},
        {"", "retired/energy", "J", [](View run) { return state(run).bird.retired; }},
      };
    }

    /// Peaks of the force are over every evaluation of contact, between rows too.
    Quantities of_force()
    {
      return {
        {"contact_force", "", "N", [](View run) { return run.observed.force; }},
        {"contact_force_peak", "", "N", [](View run) { return run.observed.contact.peak_since_row(); }},
        {"contact_impulse", "contact/impulse", "N s",
         [](View run) { return state(run).blade_momentum.contact_impulse; }, "impulse on the blade"},
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
        {"points_in_contact", "", "-",
         [](View run) { return run.contact ? double(run.contact->report().n_touching) : 0.; }},
        {"penetration", "", "m", [](View run) { return run.contact ? run.contact->report().penetration : 0.; }},
        {"", "contact/max_penetration", "m", [](View run) { return run.observed.contact.max_penetration(); },
         "largest penetration"},
        {"", "contact/max_penetration_over_spacing", "-",
         [](View run) { return run.observed.contact.max_penetration_over_spacing(); },
         "largest penetration over spacing"},
      };
    }

    /// Whether the curve has come down since: the largest value at the last instant may be on its way up. What has
    /// never left zero has no peak (null): a blade without this section, or one that holds it.
    template <class AnyPeak>
    std::optional<bool> is_reached(const AnyPeak &peak, View run)
    {
      return peak.value() == 0. ? std::nullopt : std::optional(peak.time() < run.time);
    }

    /// Signs and frames: structure/reports.h. Peaks are over all macro steps: of the tip the largest deflection either
    /// way, with its sign, of the root the largest absolute values.
    Quantities of_blade()
    {
      return {
        {"blade_momentum", "", "N s", [](View run) { return state(run).blade_momentum.momentum; }},
        {"support_impulse", "", "N s", [](View run) { return state(run).blade_momentum.support_impulse; }},
        {"", "tip/peak", "m", [](View run) { return run.observed.tip_peak.value(); }, "peak (mid-chord)"},
        {"", "tip/peak_time", "s", [](View run) { return run.observed.tip_peak.time(); }, "time of the peak"},
        {"", "tip/peak_reached", "", [](View run) { return is_reached(run.observed.tip_peak, run); }, "Tip peak"},
        {"tip_mid_chord", "", "m", [](View run) { return run.observed.tip.mid_chord; }},
        {"", "tip/final", "m", [](View run) { return run.observed.tip.mid_chord; }, "deflection at the end"},
        {"tip_leading", "", "m", [](View run) { return run.observed.tip.leading; }},
        {"tip_trailing", "", "m", [](View run) { return run.observed.tip.trailing; }},
        {"root_normal_force", "", "N", [](View run) { return run.observed.root.normal_force; }},
        {"root_transverse_force", "", "N", [](View run) { return run.observed.root.transverse_force; }},
        {"root_bending_moment", "", "N m", [](View run) { return run.observed.root.bending_moment; }},
        {"root_peak_normal_stress", "", "Pa", [](View run) { return run.observed.root.peak_stress(); }},
        {"", "root/peak_normal_stress", "Pa", [](View run) { return run.observed.root_stress.value(); },
         "peak normal stress"},
        {"", "root/peak_normal_stress_time", "s", [](View run) { return run.observed.root_stress.time(); },
         "time of the peak stress"},
        {"", "root/peak_normal_stress_reached", "", [](View run) { return is_reached(run.observed.root_stress, run); },
         "Root peak normal stress"},
        {"", "root/peak_moment", "N m", [](View run) { return run.observed.root_moment.value(); },
         "peak bending moment"},
        {"", "root/peak_moment_reached", "", [](View run) { return is_reached(run.observed.root_moment, run); },
         "Root peak moment"},
        {"", "root/peak_force", "N", [](View run) { return run.observed.root_force.value(); }, "peak force"},
        {"max_plastic_strain", "plastic/max_strain", "-", [](View run) { return run.observed.plastic.value; },
         "peak plastic strain"},
        {"", "plastic/position", "m", [](View run) { return run.observed.plastic.position; }},
        {"", "plastic/work", "J", [](View run) { return state(run).blade.plastic; }, "plastic work"},
      };
    }

    Quantities of_failure()
    {
      return {
        {"failed_elements", "failed/elements", "-", [](View run) { return run.observed.failure.n_elements; },
         "failed elements"},
        {"", "failed/collapsed", "count", [](View run) { return run.observed.failure.n_collapsed; },
         "  of these, collapsed"},
        {"", "failed/at_root", "count", [](View run) { return run.observed.failure.n_at_root; },
         "failed at the root section"},
        {"", "failed/partly", "count", [](View run) { return run.observed.failure.n_partly; },
         "elements that carry on with failed points"},
        {"", "failed/points", "count", [](View run) { return run.observed.failure.n_points; },
         "  failed points of theirs"},
        {"", "failed/mass", "kg", [](View run) { return run.observed.failure.mass; }},
        {"", "failed/free_mass", "kg", [](View run) { return run.observed.failure.free_mass; },
         "mass flying free of all elements"},
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

  const Quantity &quantity(const std::string &key)
  {
    for (const Quantity &each : quantities())
      if (each.key == key)
        return each;
    throw std::logic_error("There is no quantity '" + key + "'.");
  }
} // namespace birdstrike
