#include "simulation/warnings/case_warnings.h"
#include "simulation/explain.h"
#include "simulation/scene.h"
#include "simulation/warnings/equilibrium_warning.h"
#include "simulation/warnings/mesh_warnings.h"
#include "simulation/warnings/stiff_target.h"
#include "simulation/warnings/unit_warnings.h"
#include "simulation/warnings/unused_entries.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/core/machine.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/text.h>
#include <birdstrike/structure/blade.h>

#include <fmt/format.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    const std::string by_table = "table"; ///< of entries that the named metal fills

    /// Of a shell: how many facets are thicker than `thickest` times their shortest side.
    std::size_t count_thick(const FacetsView &facets, const double thickest)
    {
      std::size_t n = 0;
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        {
          double     shortest = INFINITY;
          const auto x        = facet_nodes(facets, f);
          for (unsigned int k = 0; k < 4; ++k)
            if (const double side = (x[(k + 1) % 4] - x[k]).norm(); side > 0.)
              shortest = std::min(shortest, side);
          n += 2. * facets.half_thickness[f] > thickest * shortest;
        }
      return n;
    }

    void check_thick_shells(const Scene &scene, Warnings &warnings)
    {
      if (scene.blade->kind() != BladeKind::shell)
        return;
      const FacetsView facets = scene.blade->facets();
      if (const std::size_t n = count_thick(facets, 2.); n > 0)
        warnings.push_back(
          {"blade/thick_shell",
           fmt::format("{} of {} shell elements are thicker than twice their shortest side: shell theory does not "
                       "hold there, and contact on their faces loses a part of its moment about the mid-surface. Take "
                       "larger elements, or Blade/Kind = solid.",
                       n, facets.n_facets)});
    }

    /// Of the diameter, or of a thinner slice.
    double count_particles_across(const Projectile &projectile)
    {
      const BirdParameters &bird    = projectile.parameters;
      const Packing        &packing = projectile.bird->packing();
      return std::min(packing.diameter, bird.is_slice() ? packing.length : INFINITY) / bird.spacing;
    }

    void check_aim(const Projectile &projectile, Warnings &warnings)
    {
      const BirdParameters &bird  = projectile.parameters;
      const double          share = projectile.first_touch.share_in_the_way;
      if (is_cut_by_edge(share))
        warnings.push_back(
          {"bird/cut_by_edge",
           fmt::format("An edge of the blade cuts the bird: impulse, deflection and plastic work converge "
                       "slowly with the particle spacing ({:.0f} particles across section '{}'), are "
                       "mostly too large, and scatter with the offset of the particle lattice. Both are "
                       "estimated by 'birdstrike converge FILE.prm --vary particles --levels 6 --finer 4 "
                       "--ratio 1.2 --places 4'.",
                       count_particles_across(projectile), bird.section)});
      if (share < 0.98)
        warnings.push_back({"bird/misses_in_part",
                            "Only " + format_share(share) + " of the mass of section '" + bird.section +
                              "' is in the way of the blade, by straight paths to its outline." +
                              (bird.roll == 0. && bird.shape != BirdShape::slab
                                 ? " Rows of particles may lie along an edge and be caught or missed as a whole: see " +
                                     bird.section + "/Roll."
                                 : "")});
    }

    void check_arrival(const Projectile &projectile, const double end_time, Warnings &warnings)
    {
      const BirdParameters &bird = projectile.parameters;
      if (bird.arrival > 0. && !projectile.contact)
        warnings.push_back({"entry/unused", bird.section + "/Arrival time is set, and there is nothing to arrive at."});
      else if (bird.arrival >= end_time)
        warnings.push_back({"bird/late", fmt::format("{}/Arrival time = {:g} s is not before Time/End time = {:g} s: "
                                                     "this bird strikes nothing.",
                                                     bird.section, bird.arrival, end_time)});
    }

    /// Planes beyond the ends of a bird are a slice of its middle typed in another unit, or none.
    void check_slice(const Projectile &projectile, Warnings &warnings)
    {
      const BirdParameters &bird = projectile.parameters;
      if (!bird.is_slice() || projectile.bird->packing().mass() < (1. - 1e-6) * bird.mass)
        return;
      const double between = bird.slice_between[1] - bird.slice_between[0], length = projectile.bird->packing().length;
      warnings.push_back(
        {"bird/uncut", fmt::format("{}/Slice/Between, {:.4g} m wide, cuts nothing off a bird that is {:.4g} m long "
                                   "across its planes: the whole bird strikes.{}",
                                   bird.section, between, length,
                                   bird.slice_blades == 0 && 1e-3 * between < length
                                     ? fmt::format(" Was it meant in mm? That would be {:.4g} m.", 1e-3 * between)
                                     : "")});
    }

    void check_spacing(const Projectile &projectile, const double across, Warnings &warnings)
    {
      const BirdParameters &bird = projectile.parameters;
      if (bird.shape != BirdShape::slab && across < 8.)
        warnings.push_back(
          {"bird/coarse", fmt::format("{:.1f} particles across the bird: impulse and deflection of a thin blade struck "
                                      "on its face are within about two percent from ten on, of a stiff target from "
                                      "20 on; where an edge cuts the bird within ten percent at 16 ({}/Particle "
                                      "spacing).",
                                      across, bird.section)});
    }

    void check_projectile(const CaseParameters &parameters, const Scene &scene, const Projectile &projectile,
                          Warnings &warnings)
    {
      const double across = count_particles_across(projectile);
      if (projectile.contact)
        {
          check_aim(projectile, warnings);
          check_stiff_target(parameters.blade, *scene.blade, projectile, across, warnings);
        }
      check_arrival(projectile, parameters.time.end_time, warnings);
      check_slice(projectile, warnings);
      check_spacing(projectile, across, warnings);
    }

    /// A name that is changed from outside leaves what the file says beside it.
    void check_renamed_metals(const CaseParameters &parameters, Warnings &warnings)
    {
      for (const auto &[number, of_section] : parameters.blade.by_section())
        {
          const std::string section = "Blade/" + BladeParameters::section_path(number) + "Material";
          std::string       names;
          for (const std::string &name : parameters.file.set_before(section, "Name"))
            names += (names.empty() ? "" : ", ") + name;
          if (!names.empty() && !of_section.is_laminate())
            warnings.push_back(
              {"entry/of_another_metal", section + "/Name is now '" + of_section.material.name +
                                           "', but entries that were set for another name still apply: " + names +
                                           ". Reset them too ('table', 'default'), or repeat their values."});
        }
    }

    /// What a metal that is named alone does not do, for the table has a yield stress and no flow curve.
    std::string describe_perfect(const Metal &metal, const std::string &section)
    {
      const bool has_rates = metal.hardening.rate_factor > 0.;
      return fmt::format(
        "{0}: '{1}' has a yield stress of {2}, but no hardening{3}, neither in the table nor in the file. The metal "
        "flows "
        "at this stress, however far and fast it is strained: plastic strains and deflections come out too large, "
        "forces and moments too small. Give Hardening with its constants (linear with Hardening modulus, johnson-cook, "
        "curve){4} of {0}; or Hardening = perfect, if that is meant.",
        section, metal.name, format_quantity(metal.hardening.yield, "Pa"), has_rates ? "" : " and no strain rates",
        has_rates ? "" : " and Rate factor");
    }

    void check_hardening(const CaseParameters &parameters, Warnings &warnings)
    {
      for (const auto &[number, of_section] : parameters.blade.by_section())
        {
          const std::string section = "Blade/" + BladeParameters::section_path(number) + "Material";
          const std::string given   = parameters.file.given_value(section + "/Hardening");
          const bool        is_as_the_blade =
            number > 0 && parameters.blade.sections[number - 1].material.name == BladeParameters::Section::same;
          if (of_section.is_laminate() || is_as_the_blade || (!given.empty() && given != by_table))
            continue;
          if (const Metal metal = of_section.material.metal(section + "/");
              metal.hardening.law == HardeningLaw::perfect)
            warnings.push_back({"metal/no_hardening", describe_perfect(metal, section)});
        }
    }

    void check_threads(const TimeParameters &time, Warnings &warnings)
    {
      const std::size_t n_cores = usable_cores();
      if (time.threads <= n_cores)
        return;
      const std::string found = fmt::format("Time/Threads = {}, and this process may run on {}", time.threads,
                                            n_cores == 1 ? std::string("one core") : fmt::format("{} cores", n_cores));
      warnings.push_back({"run/threads", time.forces_threads
                                           ? found + " (Time/Force threads): threads that take turns on a core are "
                                                     "many times slower than one thread a core."
                                           : found + fmt::format(": {} are started. Time/Force threads = true starts "
                                                                 "all, which is many times slower.",
                                                                 time.n_threads())});
    }
  } // namespace

  Warnings find_input_warnings(const CaseParameters &parameters)
  {
    Warnings               warnings = find_unused_entries(parameters);
    const BladeParameters &blade    = parameters.blade;
    if (!parameters.file.says_anything())
      warnings.push_back({"case/empty", "The parameter file sets nothing: but for --set this is the default case."});
    if (blade.is_deformable())
      {
        check_renamed_metals(parameters, warnings);
        check_hardening(parameters, warnings);
      }
    if (blade.is_deformable() && blade.mesh.generator != MeshGenerator::flat_plate && Rotor(blade.spin).turns() &&
        !parameters.file.is_given("Blade/Spin/Axis"))
      warnings.push_back({"blade/axis_not_given",
                          std::string("Blade/Spin/Axis is not given: the blade turns about z") +
                            (blade.mesh.generator == MeshGenerator::blade
                               ? ", while stagger and sweep of Mesh/Profile are those of an engine whose axis is y."
                               : ", wherever the engine's axis lies in Mesh/File.")});
    for (const std::string &sentence : parameters.file.file_warnings())
      warnings.push_back({"entry/path", sentence});
    check_threads(parameters.time, warnings);
    check_units(parameters, warnings);
    return warnings;
  }

  Warnings find_scene_warnings(const CaseParameters &parameters, const Scene &scene)
  {
    Warnings warnings;
    if (scene.blade && scene.blade->is_deformable())
      {
        check_mesh(parameters, *scene.blade, warnings);
        check_thick_shells(scene, warnings);
        check_equilibrium(scene.blade->static_report(), scene.blade->rotor() != nullptr, warnings);
        check_constant_loads(parameters.blade, scene.blade->n_nodes(), warnings);
      }
    for (const Projectile &each : scene.birds)
      check_projectile(parameters, scene, each, warnings);
    warnings.insert(warnings.end(), scene.histories.warnings.begin(), scene.histories.warnings.end());
    constexpr double much = 20. * 1024. * 1024. * 1024.; // bytes, 20 GiB
    if (const double bytes = compute_field_bytes(parameters, scene); bytes > much)
      warnings.push_back({"output/large", "Field files may take " + format_bytes(bytes) +
                                            " before compression (Output/Field interval)."});
    return warnings;
  }
} // namespace birdstrike
