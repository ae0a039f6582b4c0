#include "simulation/explain_parts.h"
#include "simulation/warnings/equilibrium_warning.h"
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/material/metal_constants.h>
#include <birdstrike/structure/blade.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike
{
  std::string vector_text(std::array<double, 3> a, const char *unit)
  {
    const double round_off = 1e-14 * std::hypot(a[0], a[1], a[2]);
    for (double &x : a)
      x = std::abs(x) > round_off ? x : 0.;
    return fmt::format("({:.4g}, {:.4g}, {:.4g}) {}", a[0], a[1], a[2], unit);
  }

  namespace
  {
    void add_mass_scaling(TextTable &table, const MassScalingReport &scaling, const std::size_t n_elements)
    {
      if (scaling.step == 0.)
        return;
      table.add("selective mass scaling",
                fmt::format("stable step {} instead of {}, {} of {} elements scaled",
                            format_quantity(scaling.step, "s"), format_quantity(scaling.step_before, "s"),
                            format_count(scaling.n_scaled), format_count(n_elements)));
      table.add_detail("inertia through the thickness",
                       fmt::format("times {:.3g} at most; translation has its mass", scaling.largest_factor));
      table.add_detail("rotary inertia of the blade",
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

    /// "solid-shell and one point", of the elements of a section.
    std::string formulations_of(const std::size_t section, const BladeCensus &census)
    {
      std::string text;
      for (const FormulationCensus &each : census.formulations)
        if (each.section == section)
          text += (text.empty() ? "" : " and ") + element_formulations().name(each.formulation);
      return text;
    }

    /// Of a solid from a file that `automatic` makes of two kinds of bricks.
    void add_mixtures(TextTable &table, const BladeCensus &census)
    {
      for (const FormulationCensus &one : census.formulations)
        for (const FormulationCensus &other : census.formulations)
          if (one.section == other.section && one.n_layers == 1 && other.n_layers != 1)
            table.add_detail("bricks alone in the thickness",
                             fmt::format("{} ({}); {} others ({})", format_count(one.n_elements),
                                         element_formulations().name(one.formulation), format_count(other.n_elements),
                                         element_formulations().name(other.formulation)));
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
                  fmt::format("from static equilibrium, {}, {} unknowns, {} iterations; root {}, tip {} off its mesh",
                              describe_stability(found), format_count(found.n_unknowns), found.n_iterations,
                              format_quantity(blade.root_section().normal_force, "N"),
                              format_quantity(blade.tip_deflection().mid_chord, "m")));
    }
  } // namespace

  void add_blade(TextTable &table, const Blade &blade, const BladeParameters &parameters)
  {
    const BladeCensus census = blade.census();
    table.add_heading("Blade: " + blade_kinds().name(blade.kind()) +
                      (blade.is_deformable() ? ", " + formulations_of(census.formulations[0].section, census) : ""));
    table.add("elements, nodes", format_count(blade.n_elements()) + ", " + format_count(blade.n_nodes()));
    if (!blade.is_deformable())
      return;
    table.add("mass", census.mass, "kg");
    table.add_detail(blade.kind() == BladeKind::solid ? "area of the skin" : "area",
                     fmt::format("{:.4g} m^2", census.area));
    if (census.thickest > 0.)
      table.add(
        "thickness",
        format_quantity(census.thinnest, "m") +
          (census.thickest > census.thinnest * (1. + 1e-9) ? " to " + format_quantity(census.thickest, "m") : "") +
          (census.n_thickness_given == 0 ? std::string()
           : census.n_thickness_given == census.n_elements
             ? ", given by file or table"
             : ", of " + format_count(census.n_thickness_given) + " elements given by file or table"));
    table.add("smallest element edge",
              format_quantity(census.smallest_edge, "m") + " at " + vector_text(census.smallest_at, "m"));
    table.add_detail("largest over smallest element", fmt::format("{:.3g}", census.largest_edge_ratio));
    table.add_detail("centre of mass", vector_text(census.centre_of_mass, "m"));
    add_span(table, blade);
    table.add_detail("held unknowns", format_count(census.n_held_dofs));
    for (const SupportCensus &support : census.supports)
      table.add("support", describe(support, blade.kind() == BladeKind::solid ? 3 : 6));
    add_spin(table, blade);
    const auto of = parameters.by_section();
    for (const SectionCensus &section : census.sections)
      table.add(section.number == 0 ? "the blade's own section" : "section " + std::to_string(section.number),
                fmt::format("{} elements ({}) of {}, {:.4g} kg", format_count(section.n_elements),
                            formulations_of(section.number, census),
                            of.at(section.number).is_laminate() ? "a laminate" : of.at(section.number).material.name,
                            section.mass));
    for (const auto &[number, of_section] : of)
      {
        const bool is_laminate = of_section.is_laminate();
        table.add((is_laminate ? "laminate" : "metal") +
                    (of.size() == 1 ? "" : " of section " + std::to_string(number)),
                  is_laminate ? describe(of_section.laminate) : describe(of_section.material.metal()));
      }
    for (const SizeCensus &sizes : census.sizes)
      table.add_detail("failure strain by size" + (of.size() == 1 ? "" : " of section " + std::to_string(sizes.number)),
                       fmt::format("times {:.4g} to {:.4g}, elements of {} to {}", sizes.lowest, sizes.highest,
                                   format_quantity(sizes.smallest, "m"), format_quantity(sizes.largest, "m")));
    add_mixtures(table, census);
    add_mass_scaling(table, census.mass_scaling, census.n_elements);
    table.add_detail("memory", format_bytes(census.bytes));
  }
} // namespace birdstrike
