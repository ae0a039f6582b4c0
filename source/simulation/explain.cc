#include "simulation/explain.h"
#include "simulation/explain_parts.h"
#include "simulation/scene.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/fields.h>
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
        table.add_detail("slice of it",
                         fmt::format("{:.5g} of {:.5g} kg, {} thick, its faces as large as circles of {} at most",
                                     shape.volume() * parameters.density, parameters.mass,
                                     format_quantity(shape.length(), "m"), format_quantity(shape.diameter(), "m")));
      if (parameters.slice_blades > 0)
        {
          const auto &n = parameters.slice_normal;
          table.add_detail("its planes",
                           fmt::format("paths of the edges of two of {} blades, normal ({:.4g}, {:.4g}, {:.4g})",
                                       parameters.slice_blades, n[0], n[1], n[2]));
        }
      table.add_detail("packing", bird.summary());
      table.add("liquid", liquid);
      if (parameters.has_strength())
        table.add("strength",
                  fmt::format("yields at {}, shear modulus {}", format_quantity(parameters.yield_stress, "Pa"),
                              format_quantity(parameters.shear_modulus, "Pa")));
      table.add_detail("kinetic energy", format_quantity(bird.energies().kinetic, "J"));
      table.add_detail("momentum", vector_text(bird.momenta().momentum, "N s"));
    }

    /// As the entry Angle to surface has it, or in words where the velocity has a part along the span.
    std::string describe_side(const Projectile &projectile)
    {
      const auto &surface = projectile.parameters.aimed_surface;
      if (!surface)
        return "";
      const Point3 n(surface->normal.data()), chord(surface->chord.data()), v(projectile.aim.velocity.data());
      const Point3 tangent = (chord - chord.dot(n) * n).normalized();
      const double across = v.dot(n), along = v.dot(tangent), of_span = (v - across * n - along * tangent).norm();
      if (of_span < 1e-3 * v.norm())
        return fmt::format("; Angle to surface = {:.4g}", std::atan2(across, along) * 180. / std::numbers::pi);
      return fmt::format("; {} the normal, from the {} edge on", across > 0. ? "with" : "against",
                         along > 0. ? "leading" : "trailing");
    }

    constexpr std::size_t most_lines = 27; ///< on the screen before the first step; warnings follow

    constexpr double least_distance = 1e-4; ///< m, of an aim point that is given with a few digits

    void add_aim(TextTable &table, const Projectile &projectile, const Blade &blade)
    {
      const bool       is_turning = blade.rotor() != nullptr;
      const StrikeAim &aim        = projectile.aim;
      std::string      where      = vector_text(aim.point, "m");
      if (!std::isnan(aim.span))
        where += ": " + format_share(aim.span) + " of the span, " + format_share(aim.chord) + " of the chord";
      if (const auto &surface = projectile.parameters.aimed_surface; surface && surface->distance > least_distance)
        where += ", " + format_quantity(surface->distance, "m") + " off the mid-surface";
      if (const Point3 place(aim.point.data());
          !projectile.parameters.aimed_place && blade.motion_of(place).displacement.norm() > least_distance)
        where += ", of the blade as it is built";
      table.add_heading("Strike");
      table.add("aim", where);
      if (const auto &moved = projectile.first_touch.moved_by; Point3(moved.data()).norm() > least_distance)
        table.add_detail("moved by spin and steady loads", vector_text(moved, "m"));
      table.add_detail("velocity", vector_text(projectile.parameters.velocity, "m/s"));
      if (const auto &position = projectile.parameters.position; !position.empty())
        table.add("position at t = 0", vector_text({{position[0], position[1], position[2]}}, "m"));
      if (projectile.parameters.arrival > 0.)
        table.add(projectile.parameters.position.empty() ? "arrival" : "first touch, from there",
                  projectile.parameters.arrival, "s");
      table.add("velocity relative to the blade",
                fmt::format("{:.5g} m/s, {}", aim.speed, vector_text(aim.velocity, "m/s")));
      table.add("angle to its surface", fmt::format("{:.4g} degrees, normal speed {:.5g} m/s{}", aim.angle,
                                                    aim.normal_speed, is_turning ? "" : describe_side(projectile)));
      if (const auto &surface = projectile.parameters.aimed_surface; surface && !is_turning)
        {
          table.add_detail("chord there, from its leading edge", vector_text(surface->chord, ""));
          table.add_detail("normal there, span x chord", vector_text(surface->normal, ""));
        }
      if (aim.normal_speed > 0.)
        table.add_detail("Hugoniot pressure of that", format_quantity(aim.hugoniot_pressure, "Pa"));
      table.add_detail("stagnation pressure", format_quantity(aim.stagnation_pressure, "Pa"));
      if (!std::isnan(aim.duration))
        table.add_detail(projectile.parameters.is_slice() ? "duration, extent along the velocity over speed"
                                                          : "duration, length over speed",
                         format_quantity(aim.duration, "s"));
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
      table.add_detail("flight skipped before first contact", format_quantity(scene.flight_time(), "s"));
      table.add("first time step", format_quantity(schedule.step, "s"));
      table.add("limited by", schedule.limiter.text());
      table.add_detail("subcycles in it", fmt::format("bird {}, blade {}", schedule.n_bird, schedule.n_blade));
      table.add_detail("time steps expected", format_count(static_cast<std::uint64_t>(n_macro)));
      table.add("run time on one core, about", format_duration(compute_run_time(parameters, scene)));
      table.add_detail("threads", std::to_string(parameters.time.n_threads()));
      if (const double bytes = compute_run_memory(parameters, scene); bytes > 0.)
        table.add("memory of the program and the run, about", format_bytes(bytes));
    }

    void add_files(TextTable &table, const CaseParameters &parameters, const Scene &scene)
    {
      const OutputParameters &output   = parameters.output;
      const double            end_time = parameters.time.end_time;
      const double            n_steps  = end_time / scene.last_plan().step; // an interval of 0 is every step
      const double n_rows = output.history_interval > 0. ? end_time / output.history_interval + 2. : n_steps + 1.;
      table.add_heading("Files");
      table.add("folder", parameters.run_directory());
      table.add_detail("history rows", format_count(static_cast<std::uint64_t>(n_rows)));
      if (scene.has_contact() && output.channel_class > 0.) // report/force_channel.h; a row is four numbers
        {
          const double n_filtered = 200. * output.channel_class * end_time + 800.;
          table.add_detail("rows of filtered.csv, at most", format_count(static_cast<std::uint64_t>(n_filtered)) +
                                                              ", " + format_bytes(75. * n_filtered));
        }
      table.add_detail("field files, before compression, at most",
                       format_bytes(compute_field_bytes(parameters, scene)));
    }
  } // namespace

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

  ToldText explain(const CaseParameters &parameters, const Scene &scene)
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
          add_aim(table, each, *scene.blade);
        if (each.contact)
          add_mass_in_the_way(table, each.first_touch.share_in_the_way, each.parameters);
      }
    add_steps(table, parameters, scene);
    add_files(table, parameters, scene);
    return {table.text(), table.brief(most_lines)};
  }
} // namespace birdstrike
