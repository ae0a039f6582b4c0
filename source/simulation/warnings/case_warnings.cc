#include "simulation/warnings/case_warnings.h"
#include "simulation/explain.h"
#include "simulation/scene.h"
#include "simulation/warnings/mesh_warnings.h"
#include "simulation/warnings/unit_warnings.h"
#include "simulation/warnings/unused_entries.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/text.h>
#include <birdstrike/structure/blade.h>

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <sstream>

namespace birdstrike
{
  namespace
  {
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

    void check_projectile(const Projectile &projectile, const double end_time, Warnings &warnings)
    {
      if (projectile.contact)
        check_aim(projectile, warnings);
      check_arrival(projectile, end_time, warnings);
      check_slice(projectile, warnings);
      const BirdParameters &bird   = projectile.parameters;
      const double          across = count_particles_across(projectile);
      if (bird.shape != BirdShape::slab && across < 8.)
        warnings.push_back({"bird/coarse", fmt::format("{:.1f} particles across the bird: impulse and deflection are "
                                                       "within a percent from about ten on, where an edge cuts the "
                                                       "bird within ten percent at 16 ({}/Particle spacing).",
                                                       across, bird.section)});
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
                                           "', and what was set beside another name still holds: " + names +
                                           ". Set it too ('table', 'default'), or once more to what it is."});
        }
    }

    /// Whether no line of a parameter file sets or includes anything.
    bool sets_nothing(const std::string &file)
    {
      static const std::set<std::string> statements{"set", "SET", "include", "INCLUDE"};
      std::istringstream                 lines(file);
      for (std::string line; std::getline(lines, line);)
        {
          std::istringstream words(line);
          std::string        first;
          words >> first;
          if (first.starts_with("\xEF\xBB\xBF")) // the mark of UTF-8
            first.erase(0, 3);
          if (statements.contains(first))
            return false;
        }
      return true;
    }
  } // namespace

  Warnings find_input_warnings(const CaseParameters &parameters)
  {
    Warnings               warnings = find_unused_entries(parameters);
    const BladeParameters &blade    = parameters.blade;
    if (sets_nothing(parameters.file.original()))
      warnings.push_back({"case/empty", "The parameter file sets nothing: but for --set this is the default case."});
    if (blade.is_deformable())
      check_renamed_metals(parameters, warnings);
    if (blade.is_deformable() && blade.mesh.generator != MeshGenerator::flat_plate && Rotor(blade.spin).turns() &&
        !parameters.file.is_given("Blade/Spin/Axis"))
      warnings.push_back({"blade/axis_not_given",
                          std::string("Blade/Spin/Axis is not given: the blade turns about z") +
                            (blade.mesh.generator == MeshGenerator::blade
                               ? ", while stagger and sweep of Mesh/Profile are those of an engine whose axis is y."
                               : ", wherever the engine's axis lies in Mesh/File.")});
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
      }
    for (const Projectile &each : scene.birds)
      check_projectile(each, parameters.time.end_time, warnings);
    warnings.insert(warnings.end(), scene.histories.warnings.begin(), scene.histories.warnings.end());
    constexpr double much = 20. * 1024. * 1024. * 1024.; // bytes, 20 GiB
    if (const double bytes = compute_field_bytes(parameters, scene); bytes > much)
      warnings.push_back({"output/large", "Field files may take " + format_bytes(bytes) +
                                            " before compression (Output/Field interval)."});
    return warnings;
  }
} // namespace birdstrike
