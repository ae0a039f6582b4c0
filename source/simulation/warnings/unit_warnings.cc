#include "simulation/warnings/unit_warnings.h"
#include "simulation/warnings/plausible.h"
#include <birdstrike/core/text_lists.h>
#include <birdstrike/io/case_parameters.h>

#include <fmt/format.h>

#include <cmath>
#include <tuple>

namespace birdstrike
{
  namespace
  {
    using Units = std::vector<Plausible::Unit>;
    const Units of_density{{"g/cm^3", 1e3}, {"t/mm^3", 1e12}, {"kg/mm^3", 1e9}};
    const Units of_stress{{"GPa", 1e9}, {"MPa", 1e6}}; // the larger one first: 113.8 is no rubber
    const Units of_length{{"mm", 1e-3}};
    const Units of_strain{{"%", 1e-2}};

    /// Of plies; cores of foam have some that are small.
    void check_strength(const std::string &path, const PlyStrength &strength, Warnings &warnings)
    {
      for (const auto &[entry, value] : {std::pair("Longitudinal tension", strength.longitudinal_tension),
                                         std::pair("Longitudinal compression", strength.longitudinal_compression),
                                         std::pair("Transverse tension", strength.transverse_tension),
                                         std::pair("Transverse compression", strength.transverse_compression),
                                         std::pair("Shear strength", strength.shear)})
        if (value > 0.) // of a ply that fails
          check({"strength", path + entry, value, "Pa", 2e4, 2e10, of_stress}, warnings);
    }

    void check_flow(const Metal &metal, const MetalParameters &given, const std::string &where, Warnings &warnings)
    {
      const Hardening &h           = metal.hardening;
      const bool       has_modulus = h.law == HardeningLaw::linear || h.law == HardeningLaw::voce;
      if (has_modulus && h.modulus > 0.)
        check({"hardening_modulus", where + "Hardening modulus", h.modulus, "Pa", 1e5, 2e11, of_stress}, warnings);
      if (given.is_adiabatic && given.initial_temperature < 200.)
        warnings.push_back(
          {"unit/temperature", fmt::format("{}Initial temperature = {:.6g} K: a blade is warmer. Was it meant in degC? "
                                           "That would be {:.6g} K.",
                                           where, given.initial_temperature, given.initial_temperature + 273.15)});
      if (metal.failure.law == FailureLaw::johnson_cook && metal.failure.d[2] > 0.)
        warnings.push_back({"material/damage_d3",
                            fmt::format("{}Damage D3 = {:.4g} is above 0: the strain at failure would grow with "
                                        "tension. Codes that count pressure positive in compression have it with the "
                                        "other sign; here tension is positive, and metals have a negative one.",
                                        where, metal.failure.d[2])});
    }

    void check_metals(const BladeParameters &blade, Warnings &warnings)
    {
      for (const auto &[number, of_section] : blade.by_section())
        {
          const std::string path = "Blade/" + BladeParameters::section_path(number);
          if (of_section.is_laminate())
            {
              const std::string where = path + "Laminate/";
              for (const auto &[name, entries, ply] : of_section.laminate.stack().materials)
                {
                  const std::string of_ply = name.empty() ? where : "Blade/Laminate/" + entries;
                  // cores are of foam, balsa and honeycomb
                  check({"density", of_ply + "Density", ply.density, "kg/m^3", 20., 25e3, of_density}, warnings);
                  check({"young", of_ply + "Young's modulus 1", ply.young_1, "Pa", 5e5, 2e12, of_stress}, warnings);
                  check_strength(of_ply, ply.strength, warnings);
                }
              continue;
            }
          const std::string where    = path + "Material/";
          const Metal       metal    = of_section.material.metal(where);
          const std::size_t n_before = warnings.size();
          check({"density", where + "Density", metal.density, "kg/m^3", 500., 25e3, of_density}, warnings);
          check({"young", where + "Young's modulus", metal.elasticity.young, "Pa", 5e5, 2e12, of_stress}, warnings);
          if (metal.hardening.law == HardeningLaw::elastic)
            continue;
          check_flow(metal, of_section.material, where, warnings);
          const bool is_curve = metal.hardening.law == HardeningLaw::curve;
          check({"yield", where + (is_curve ? "Hardening curve: yield stress" : "Yield stress"), metal.hardening.yield,
                 "Pa", 1e5, 1e10, of_stress},
                warnings);
          if (metal.hardening.curve.n_segments > 0)
            {
              const auto &last = metal.hardening.curve.segments[metal.hardening.curve.n_segments - 1];
              check({"curve_strain", where + "Hardening curve: last strain", last.begin + last.length, "(true strain)",
                     1e-4, 3., of_strain},
                    warnings);
            }
          if (metal.failure.law == FailureLaw::plastic_strain)
            check({"failure_strain", where + "Failure strain", metal.failure.plastic_strain, "(true strain)", 1e-3, 3.,
                   of_strain},
                  warnings);
          const double strain = metal.hardening.yield / metal.elasticity.young;
          if (warnings.size() == n_before && strain > 0.1)
            warnings.push_back({"material/yield_strain",
                                fmt::format("{}Yield stress is {:.3g} of Young's modulus: no metal stays elastic to "
                                            "such strains.",
                                            where, strain)});
        }
    }

    void check_bird(const BirdParameters &bird, Warnings &warnings)
    {
      const auto &v = bird.velocity;
      if (bird.shape != BirdShape::slab)
        check({"bird_mass", bird.section + "/Mass", bird.mass, "kg", 1e-3, 20., {{"g", 1e-3}}}, warnings);
      check({"bird_density", bird.section + "/Density", bird.density, "kg/m^3", 300., 3e3, of_density}, warnings);
      check({"speed",
             "Norm of " + bird.section + "/Velocity",
             std::hypot(v[0], v[1], v[2]),
             "m/s",
             5.,
             1500.,
             {{"mm/s", 1e-3}, {"km/s", 1e3}}},
            warnings);
      if (!bird.angle_to_surface.empty())
        check({"angle",
               bird.section + "/Angle to surface",
               std::abs(bird.angle_to_surface[0]),
               "degrees",
               1.6,
               180.,
               {{"rad", 57.29577951}}},
              warnings);
      check({"spacing", bird.section + "/Particle spacing", bird.spacing, "m", 1e-4, 0.05, of_length}, warnings);
    }

    /// What the liquid's sound speed follows from.
    void check_liquid(const EosParameters &liquid, const std::string &section, Warnings &warnings)
    {
      const std::string path = section + "/Equation of state/";
      const Units       of_modulus{{"GPa", 1e9}, {"MPa", 1e6}, {"kPa", 1e3}};
      const double      softest = 1e7, stiffest = 3e10; // Pa; water 2.2e9
      if (liquid.type == EosType::linear)
        check({"bulk_modulus", path + "Bulk modulus", liquid.bulk_modulus, "Pa", softest, stiffest, of_modulus},
              warnings);
      if (liquid.type == EosType::murnaghan)
        check({"bulk_modulus", path + "Murnaghan modulus", liquid.murnaghan_modulus, "Pa",
               softest / liquid.murnaghan_exponent, stiffest / liquid.murnaghan_exponent, of_modulus},
              warnings);
      if (liquid.type == EosType::polynomial)
        check({"bulk_modulus", path + "Polynomial C1", liquid.c1, "Pa", softest, stiffest, of_modulus}, warnings);
      if (liquid.type == EosType::us_up || liquid.type == EosType::porous)
        check(
          {"sound_speed", path + "Sound speed", liquid.sound_speed, "m/s", 30., 6e3, {{"km/s", 1e3}, {"mm/s", 1e-3}}},
          warnings);
    }

    /// Radii of patches and discs.
    void check_patches(const CaseParameters &parameters, Warnings &warnings)
    {
      const auto check_radius = [&](const std::string &entry, const double radius) {
        check({"radius", entry + ": radius", radius, "m", 1e-5, 2., of_length}, warnings);
      };
      for (const auto &[name, where] : parse_pairs(parameters.output.histories.patches, "Output/Histories/Patches"))
        if (parse_words(where).size() == 4)
          check_radius("Output/Histories/Patches '" + name + "'",
                       parse_numbers(where, 4, "Output/Histories/Patches")[3]);
      for (const PressurePatch &patch : parameters.contact.pressure_patches())
        check_radius("Contact/Pressure patches '" + patch.name + "'", patch.radius);
    }
  } // namespace

  void check_units(const CaseParameters &parameters, Warnings &warnings)
  {
    const TimeParameters &time = parameters.time;
    const Units           of_time{{"ms", 1e-3}, {"us", 1e-6}};
    if (parameters.blade.is_deformable())
      check_metals(parameters.blade, warnings);
    for (const BirdCase &each : parameters.birds())
      {
        check_bird(each.bird, warnings);
        check_liquid(each.liquid, each.bird.section, warnings);
      }
    check({"friction", "Contact/Friction", parameters.contact.friction, "-", 0., 2., {{"%", 1e-2}}}, warnings);
    check_patches(parameters, warnings);
    check({"end_time", "Time/End time", time.end_time, "s", 0., 0.5, of_time}, warnings);
    check({"history_interval", "Output/History interval", parameters.output.history_interval, "s", 0., time.end_time,
           of_time},
          warnings);
  }
} // namespace birdstrike
