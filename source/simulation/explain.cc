#include "simulation/explain.h"
#include "simulation/scene.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/core/prices.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/fields.h>
#include <birdstrike/material/metal_constants.h>
#include <birdstrike/report/text.h>
#include <birdstrike/structure/blade.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike
{
  namespace
  {
    std::string vector_text(std::array<double, 3> a, const char *unit)
    {
      const double round_off = 1e-14 * std::hypot(a[0], a[1], a[2]);
      for (double &x : a)
        x = std::abs(x) > round_off ? x : 0.;
      return fmt::format("({:.4g}, {:.4g}, {:.4g}) {}", a[0], a[1], a[2], unit);
    }

    void add_mass_scaling(TextTable &table, const MassScalingReport &scaling, const std::size_t n_elements)
    {
      if (scaling.step == 0.)
        return;
      table.add("selective mass scaling",
                fmt::format("stable step {} instead of {}, {} of {} elements scaled",
                            format_quantity(scaling.step, "s"), format_quantity(scaling.step_before, "s"),
                            format_count(scaling.n_scaled), format_count(n_elements)));
      table.add("inertia through the thickness",
                fmt::format("times {:.3g} at most; translation has its mass", scaling.largest_factor));
      table.add("rotary inertia of the blade",
                fmt::format("+{} about its slenderest axis: first torsion -{}, bending less",
                            format_share(scaling.added_rotary_inertia),
                            format_share(0.5 * scaling.added_rotary_inertia)));
    }

    void add_span(TextTable &table, const Blade &blade)
    {
      const std::optional<SpanLine> line = blade.span_line();
      if (!line)
        return;
      const Point3 span = Point3(line->tip.data()) - Point3(line->root.data()), along = span.normalized();
      table.add("from root to tip",
                format_quantity(span.norm(), "m") + " along " + vector_text({{along[0], along[1], along[2]}}, ""));
    }

    /// "19 nodes: ux uy uz rx ry rz held; x 0, y -0.04445 to 0.04445, z 0 m".
    std::string describe(const SupportCensus &support, const std::size_t n_unknowns)
    {
      static constexpr std::array<const char *, 6> components{{"ux", "uy", "uz", "rx", "ry", "rz"}};
      std::string                                  text = format_count(support.n_nodes) + " nodes:";
      for (const auto &[are_there, what] :
           {std::pair(support.is_held, " held;"), std::pair(support.is_driven, " driven;")})
        if (std::find(are_there.begin(), are_there.end(), true) != are_there.end())
          {
            for (std::size_t c = 0; c < n_unknowns; ++c)
              text += are_there[c] ? std::string(" ") + components[c] : "";
            text += what;
          }
      for (std::size_t d = 0; d < 3; ++d)
        {
          text += (d > 0 ? ", " : " ") + std::string(1, "xyz"[d]) + fmt::format(" {:.4g}", support.low[d]);
          text += support.low[d] < support.high[d] ? fmt::format(" to {:.4g}", support.high[d]) : "";
        }
      return text + " m";
    }

    void add_spin(TextTable &table, const Blade &blade)
    {
      const Rotor *const rotor = blade.rotor();
      if (rotor == nullptr)
        return;
      const HubMotion motion = rotor->motion(0.);
      const double    sign = motion.speed < 0. ? -1. : 1., speed = sign * motion.speed;
      table.add("turns with its hub at",
                fmt::format("{:.4g} rad/s, {:.4g} rpm{}, about {}", speed, speed * 30. / std::numbers::pi,
                            rotor->is_steady() ? "" : " at t = 0 and changing",
                            vector_text({{sign * motion.axis[0], sign * motion.axis[1], sign * motion.axis[2]}}, "")));
      const StaticReport found = blade.static_report();
      if (found.n_unknowns == 0)
        table.add("centrifugal tension", motion.speed == 0. ? "none at the start: the hub is at rest"
                                                            : "none at the start: Blade/Spin/Prestress is false");
      else
        table.add("centrifugal tension",
                  fmt::format("from static equilibrium, {} unknowns, {} iterations; root {}, tip {} off its mesh",
                              format_count(found.n_unknowns), found.n_iterations,
                              format_quantity(blade.root_section().normal_force, "N"),
                              format_quantity(blade.tip_deflection().mid_chord, "m")));
    }

    void add_blade(TextTable &table, const Blade &blade, const BladeParameters &parameters)
    {
      const BladeCensus census = blade.census();
      table.add_heading("Blade: " + blade_kinds().name(blade.kind()) +
                        (blade.is_deformable() ? ", " + parameters.formulation_name() : ""));
      table.add("elements, nodes", format_count(blade.n_elements()) + ", " + format_count(blade.n_nodes()));
      if (!blade.is_deformable())
        return;
      table.add("mass", census.mass, "kg");
      table.add(blade.kind() == BladeKind::solid ? "area of the skin" : "area", fmt::format("{:.4g} m^2", census.area));
      table.add("smallest element edge",
                format_quantity(census.smallest_edge, "m") + " at " + vector_text(census.smallest_at, "m"));
      table.add("largest over smallest element", fmt::format("{:.3g}", census.largest_edge_ratio));
      table.add("centre of mass", vector_text(census.centre_of_mass, "m"));
      add_span(table, blade);
      table.add("held unknowns", format_count(census.n_held_dofs));
      for (const SupportCensus &support : census.supports)
        table.add("support", describe(support, blade.kind() == BladeKind::solid ? 3 : 6));
      add_spin(table, blade);
      const auto of = parameters.by_section();
      for (const SectionCensus &section : census.sections)
        table.add(section.number == 0 ? "the blade's own section" : "section " + std::to_string(section.number),
                  fmt::format("{} elements ({}) of {}, {:.4g} kg", format_count(section.n_elements),
                              of.at(section.number).formulation_name(),
                              of.at(section.number).is_laminate() ? "a laminate" : of.at(section.number).material.name,
                              section.mass));
      for (const auto &[number, of_section] : of)
        {
          const bool is_laminate = of_section.is_laminate();
          table.add((is_laminate ? "laminate" : "metal") +
                      (of.size() == 1 ? "" : " of section " + std::to_string(number)),
                    is_laminate ? describe(of_section.laminate) : describe(of_section.material.metal()));
        }
      add_mass_scaling(table, census.mass_scaling, census.n_elements);
      table.add("memory", format_bytes(census.bytes));
    }

    void add_bird(TextTable &table, const Bird &bird, const BirdParameters &parameters, const std::string &liquid)
    {
      table.add_heading(parameters.section + ": " + bird_shapes().name(parameters.shape) + ", " +
                        particle_formulations().name(parameters.formulation));
      table.add("particles", format_count(bird.n_particles()));
      table.add("mass", fmt::format("{:.9g} kg", bird.packing().mass()));
      const Shape shape(parameters);
      table.add(shape.is_slice() ? "length, diameter of the whole bird" : "length, diameter",
                format_quantity(shape.whole_length(), "m") + ", " + format_quantity(shape.whole_diameter(), "m"));
      if (shape.is_slice())
        table.add("slice of it",
                  fmt::format("{:.5g} of {:.5g} kg, {} thick, its faces as large as circles of {} at most",
                              shape.volume() * parameters.density, parameters.mass,
                              format_quantity(shape.length(), "m"), format_quantity(shape.diameter(), "m")));
      table.add("packing", bird.summary());
      table.add("liquid", liquid);
      if (parameters.has_strength())
        table.add("strength",
                  fmt::format("yields at {}, shear modulus {}", format_quantity(parameters.yield_stress, "Pa"),
                              format_quantity(parameters.shear_modulus, "Pa")));
      table.add("kinetic energy", bird.energies().kinetic, "J");
      table.add("momentum", vector_text(bird.momenta().momentum, "N s"));
      table.add("memory, about", format_bytes(prices::bytes_per_particle * static_cast<double>(bird.state().size())));
    }

    void add_aim(TextTable &table, const Projectile &projectile)
    {
      const StrikeAim &aim   = projectile.aim;
      std::string      where = vector_text(aim.point, "m");
      if (!std::isnan(aim.span))
        where += ": " + format_share(aim.span) + " of the span, " + format_share(aim.chord) + " of the chord";
      table.add_heading("Strike");
      table.add("aim", where);
      table.add("velocity", vector_text(projectile.parameters.velocity, "m/s"));
      if (projectile.parameters.arrival > 0.)
        table.add("arrival", projectile.parameters.arrival, "s");
      table.add("velocity relative to the blade",
                fmt::format("{:.5g} m/s, {}", aim.speed, vector_text(aim.velocity, "m/s")));
      table.add("angle to its surface",
                fmt::format("{:.4g} degrees, normal speed {:.5g} m/s", aim.angle, aim.normal_speed));
      if (aim.normal_speed > 0.)
        table.add("Hugoniot pressure of that", aim.hugoniot_pressure, "Pa");
      table.add("stagnation pressure", aim.stagnation_pressure, "Pa");
      if (!std::isnan(aim.duration))
        table.add(projectile.parameters.is_slice() ? "duration, extent along the velocity over speed"
                                                   : "duration, length over speed",
                  aim.duration, "s");
    }

    void add_mass_in_the_way(TextTable &table, const double share, const BirdParameters &bird)
    {
      const bool is_cut = is_cut_by_edge(share), may_lie_along = bird.roll == 0. && bird.shape != BirdShape::slab;
      table.add("mass in the way of the blade",
                format_share(share) + ", by straight paths to its outline" +
                  (is_cut && may_lie_along ? "; rows of particles may lie along an edge: see Roll" : ""));
    }

    void add_steps(TextTable &table, const CaseParameters &parameters, const Scene &scene)
    {
      const Schedule &schedule = scene.last_plan();
      const double    n_macro  = std::ceil(parameters.time.end_time / schedule.step);
      table.add_heading("Time");
      table.add("end time", parameters.time.end_time, "s");
      table.add("flight skipped before first touch", scene.flight_time(), "s");
      table.add("first time step", format_quantity(schedule.step, "s"));
      table.add("limited by", schedule.limiter.text());
      table.add("subcycles in it", fmt::format("bird {}, blade {}", schedule.n_bird, schedule.n_blade));
      table.add("time steps expected", format_count(static_cast<std::uint64_t>(n_macro)));
      table.add("run time on one core, about", format_duration(compute_run_time(parameters, scene)));
      table.add("threads", std::to_string(parameters.time.n_threads()));
    }

    void add_files(TextTable &table, const CaseParameters &parameters, const Scene &scene)
    {
      const OutputParameters &output   = parameters.output;
      const double            end_time = parameters.time.end_time;
      const double            n_steps  = end_time / scene.last_plan().step; // an interval of 0 is every step
      const double n_rows = output.history_interval > 0. ? end_time / output.history_interval + 2. : n_steps + 1.;
      table.add_heading("Files");
      table.add("folder", parameters.run_directory());
      table.add("history rows", format_count(static_cast<std::uint64_t>(n_rows)));
      if (scene.has_contact() && output.channel_class > 0.) // report/force_channel.h; a row is four numbers
        {
          const double n_filtered = 200. * output.channel_class * end_time + 800.;
          table.add("rows of filtered.csv, at most",
                    format_count(static_cast<std::uint64_t>(n_filtered)) + ", " + format_bytes(75. * n_filtered));
        }
      table.add("field files, before compression, at most", format_bytes(compute_field_bytes(parameters, scene)));
    }

    /// How long a particle is computed in the mean, s: it arrives, and crosses the blade at the bird's speed before it
    /// is removed. Measured with coarse particles: frontal 2.1 ms (here 2.05), oblique 1.4 (1.2).
    double compute_bird_time(const Projectile &projectile, const Scene &scene, const double end_time)
    {
      const BirdParameters &bird  = projectile.parameters;
      const StrikeAim      &aim   = projectile.aim;
      const double          whole = std::max(end_time - bird.arrival, 0.);
      if (!projectile.contact || !bird.retire || !(aim.speed > 0.) || std::isnan(aim.duration))
        return whole;
      const Box    blade = scene.compute_reach_of_blade(0., 0.);
      const double across =
        std::hypot(blade.high[0] - blade.low[0], blade.high[1] - blade.low[1], blade.high[2] - blade.low[2]);
      return std::min(whole, 0.5 * aim.duration + across / aim.speed);
    }
  } // namespace

  double compute_run_time(const CaseParameters &parameters, const Scene &scene)
  {
    const Schedule &schedule = scene.last_plan();
    double          ns       = 0.; // over the time of a step
    for (const Projectile &each : scene.birds)
      ns += compute_bird_time(each, scene, parameters.time.end_time) * schedule.n_bird * each.bird->step_price();
    if (scene.blade)
      ns += parameters.time.end_time * schedule.n_blade * scene.blade->prices().of_step;
    return 1e-9 * ns / schedule.step;
  }

  double compute_field_bytes(const CaseParameters &parameters, const Scene &scene)
  {
    const OutputParameters &output   = parameters.output;
    const double            interval = std::max(output.field_interval, scene.last_plan().step); // one a step at most
    const double n_fields = 2. + (output.field_interval > 0. ? std::floor(parameters.time.end_time / interval) : 0.);
    double       bytes    = 0.;
    if (scene.blade && output.blade_fields)
      bytes += n_fields * static_cast<double>(compute_field_file_bytes(scene.blade->snapshot()));
    for (const Projectile &each : scene.birds)
      if (output.bird_fields)
        bytes += n_fields * static_cast<double>(compute_field_file_bytes(each.bird->snapshot()));
    return bytes;
  }

  std::string explain(const CaseParameters &parameters, const Scene &scene)
  {
    TextTable table(parameters.name + (parameters.description.empty() ? "" : ": " + parameters.description));
    if (parameters.has_symmetry_plane)
      table.add_heading("Symmetry plane y = 0: half of the scene is computed; steps, memory and files are the half's, "
                        "all else is of the "
                        "whole.");
    if (scene.blade)
      add_blade(table, *scene.blade, parameters.blade);
    for (const Projectile &each : scene.birds)
      {
        const double speed =
          each.contact ? each.first_touch.closing_speed : Point3(each.parameters.velocity.data()).norm();
        add_bird(table, *each.bird, each.parameters,
                 EquationOfState(each.liquid, each.parameters.density).summary(speed));
        if (each.contact)
          add_aim(table, each);
        if (each.contact)
          add_mass_in_the_way(table, each.first_touch.share_in_the_way, each.parameters);
      }
    add_steps(table, parameters, scene);
    add_files(table, parameters, scene);
    return table.text();
  }
} // namespace birdstrike
