#include "simulation/warnings/mesh_warnings.h"
#include "simulation/warnings/plausible.h"
#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/expression.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/structure/blade.h>
#include <birdstrike/structure/rotor.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    void check_layers(const BladeParameters &blade, const BladeCensus &census, Warnings &warnings)
    {
      if (blade.kind != BladeKind::solid)
        return;
      const bool is_file = blade.mesh.generator == MeshGenerator::file;
      const auto of      = blade.by_section();
      for (const FormulationCensus &each : census.formulations)
        {
          const BladeParameters &of_section = of.at(each.section);
          const bool             can_yield  = of_section.material.metal().hardening.law != HardeningLaw::elastic;
          const char            *why        = nullptr;
          if (each.formulation == ElementFormulation(SolidFormulation::b_bar) && each.n_layers < 4)
            why = "fully integrated bricks lock in bending (first frequency of a thin plate +23 % with two layers)";
          else if (each.formulation == ElementFormulation(SolidFormulation::one_point) && each.n_layers < 4 &&
                   can_yield)
            why = "such a section yields as few points or as a whole, not layer by layer";
          if (why != nullptr)
            warnings.push_back(
              {"blade/layers",
               fmt::format("{} = {} with Blade/{}Element/Formulation = {} ({} elements): {}. {} bend right.",
                           is_file ? "Layers of bricks in Blade/Mesh/File" : "Blade/Mesh/Layers", each.n_layers,
                           BladeParameters::section_path(each.section), element_formulations().name(each.formulation),
                           each.n_elements, why,
                           of_section.can_fail() ? "Four layers" : "One layer of solid-shells, or four layers,")});
        }
    }

    void check_sizes(const BladeParameters &blade, const BladeCensus &census, Warnings &warnings)
    {
      const auto of = blade.by_section();
      for (const SizeCensus &sizes : census.sizes)
        if (sizes.n_beyond > 0)
          {
            const SizeFactors &factors = of.at(sizes.number).material.metal().failure.size_factors;
            warnings.push_back(
              {"blade/beyond_size_factors",
               fmt::format("Blade/{}Material/Failure size factors: {} elements are outside of the "
                           "points, {:.4g} to {:.4g} mm, and take the factor of the nearer end; its "
                           "elements are of {:.4g} to {:.4g} mm.",
                           BladeParameters::section_path(sizes.number), sizes.n_beyond, 1e3 * factors.points[0].size,
                           1e3 * factors.points[factors.n - 1].size, 1e3 * sizes.smallest, 1e3 * sizes.largest)});
          }
    }

    /// Of a shell from a file: the default's, or an entry that the file leaves nothing to say.
    void check_source_of_thickness(const CaseParameters &parameters, const BladeCensus &census, Warnings &warnings)
    {
      const BladeParameters &blade    = parameters.blade;
      const auto             is_given = [&](const char *entry) {
        return parameters.file.is_given(std::string("Blade/Thickness/") + entry);
      };
      const bool has_more =
        is_given("Maximum") || is_given("By material") ||
        std::ranges::any_of(blade.sections, [](const auto &each) { return !each.thickness.empty(); });
      if (!is_given("Value") && !has_more && census.n_thickness_given < census.n_elements)
        warnings.push_back({"blade/thickness_not_given",
                            fmt::format("Blade/Thickness is not given: {} of {} elements of the shell are {:.4g} mm "
                                        "thick, as the default plate. Thickness and metal that a mesh file gives by "
                                        "section or property (*SECTION_SHELL, *Shell Section) are not read.",
                                        census.n_elements - census.n_thickness_given, census.n_elements,
                                        1e3 * std::stod(ThicknessParameters().value))});
      if (is_given("Value") && census.n_thickness_given == census.n_elements)
        warnings.push_back({"entry/unused", "Blade/Thickness/Value is set, and means nothing: file or table give the "
                                            "thickness of every element."});
    }

    void check_thickness(const CaseParameters &parameters, const Blade &blade, const BladeCensus &census,
                         Warnings &warnings)
    {
      if (blade.kind() != BladeKind::shell)
        return;
      const double size = std::sqrt(census.area), thickness = census.mass / (parameters.blade.density() * census.area);
      const auto   doubt = [&](const std::string &text) {
        warnings.push_back(
            {"unit/thickness",
           fmt::format("Mean thickness of the shell = {:.6g} m, {} its length "
                           "({:.3g} m, root of its area). {}",
                         thickness, thickness > size ? "more than" : "a ten-thousandth or less of", size, text)});
      };
      if (thickness > size)
        doubt("Was Blade/Thickness meant in mm?");
      else if (thickness < 1e-4 * size)
        doubt("Is Blade/Thickness right? It is in m, and 'mm' stands for 0.001.");
      if (parameters.blade.mesh.generator == MeshGenerator::file)
        check_source_of_thickness(parameters, census, warnings);
    }

    /// Of a shell from a file: pressure and plies go by its top face, which hardly looks upwards.
    void check_top(const BladeParameters &parameters, const FacetsView &facets, Warnings &warnings)
    {
      if (!parameters.mesh.top.empty() || !(is_present(parameters.loads.pressure) || parameters.laminate.is_given()))
        return;
      Point3 sum = Point3::Zero();
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        {
          const auto x = facet_nodes(facets, f);
          sum += (x[2] - x[0]).cross(x[3] - x[1]);
        }
      const Point3     mean = sum.normalized();
      constexpr double none = 0.01, little = 0.2; // the first as of the rule
      const double     by = std::abs(mean[2]) > none ? mean[2] : std::abs(mean[1]) > none ? mean[1] : mean[0];
      if (by < little)
        warnings.push_back(
          {"blade/top_by_little",
           fmt::format("The top face of the shell, {}, is found from a mean normal of ({:.3f}, {:.3f}, {:.3f}), which "
                       "hardly points up: a small rotation of the mesh would change the side. Set Blade/Mesh/Top.",
                       is_present(parameters.loads.pressure) ? "along whose normal pressure acts"
                                                             : "to which plies are stacked",
                       mean[0], mean[1], mean[2])});
    }

    void check_reference_direction(const CaseParameters &parameters, const Point3 &span, Warnings &warnings)
    {
      const std::string entry = "Blade/Laminate/Reference direction";
      const double      angle = std::acos(std::min(1., std::abs(span[0]))) * 180. / M_PI;
      if (parameters.blade.laminate.is_given() && !parameters.file.is_given(entry) && angle > 20.)
        warnings.push_back(
          {"laminate/direction_not_given", fmt::format("{} is not given: plies of 0 degrees lie along x, which is "
                                                       "{:.3g} degrees from the direction from root to tip.",
                                                       entry, angle)});
    }

    void check_axis(const BladeParameters::Spin &spin, const Point3 &span, Warnings &warnings)
    {
      const Point3 axis  = Point3(spin.axis.data()).normalized();
      const double angle = std::acos(std::min(1., std::abs(axis.dot(span)))) * 180. / M_PI;
      if (Rotor(spin).turns() && angle < 20.)
        warnings.push_back(
          {"blade/axis_along_span", fmt::format("Blade/Spin/Axis is {:.3g} degrees from the direction from root to "
                                                "tip: the blade turns about its own span.",
                                                angle)});
    }

    void check_supports(const CaseParameters &parameters, const Blade &blade, const BladeCensus &census,
                        Warnings &warnings)
    {
      std::size_t n_held = 0; // in all translations
      for (const SupportCensus &support : census.supports)
        n_held += support.is_held[0] && support.is_held[1] && support.is_held[2] ? support.n_nodes : 0;
      if (census.n_held_dofs == 0)
        warnings.push_back({"blade/free", "Nothing holds the blade: it flies off (Blade/Supports)."});
      else if (n_held == census.n_nodes)
        warnings.push_back(
          {"blade/all_held",
           "Every node of the blade is constrained (Blade/Supports: are coordinates of Held boxes in m?)."});
      for (const std::string &entry : census.held_faces)
        warnings.push_back(
          {"blade/hinge_is_clamp", entry + " constrains whole faces of the solid, and so their rotation. A hinge "
                                           "constrains one row of nodes (Held boxes); a clamp is 'clamped'."});
      const auto line = blade.span_line();
      if (!line && parameters.blade.mesh.generator == MeshGenerator::file &&
          !parameters.file.is_given("Blade/Supports/Tip"))
        warnings.push_back({"blade/no_tip", "Blade/Supports/Tip is not given, and no side of the mesh is known as its "
                                            "tip row, or none as its root: there is no tip deflection."});
      if (!line)
        return;
      const double length = (Point3(line->tip.data()) - Point3(line->root.data())).norm(),
                   size   = std::sqrt(census.area);
      if (length < 1e-6 * size)
        warnings.push_back({"blade/tip_is_root", "The tip row is the clamped root: there is no tip deflection "
                                                 "(Blade/Supports/Clamped, Hub and Tip)."});
      if (parameters.blade.mesh.generator == MeshGenerator::blade && length > 2. * parameters.blade.mesh.length)
        warnings.push_back(
          {"unit/stacking",
           fmt::format("Root and tip are {:.4g} m apart, {:.3g} times Blade/Mesh/Length: were Sweep and "
                       "Lean of Blade/Mesh/Profile meant in mm?",
                       length, length / parameters.blade.mesh.length)});
    }

    std::string describe(const OpenSeams::Found &found)
    {
      return found.largest_gap == 0.
               ? fmt::format("at the same place ({:.6g}, {:.6g}, {:.6g}) m", found.at[0], found.at[1], found.at[2])
               : fmt::format("{:.3g} mm apart ({:.2g} % of the elements there), at ({:.6g}, {:.6g}, {:.6g}) m",
                             1e3 * found.largest_gap, 1e2 * found.share, found.at[0], found.at[1], found.at[2]);
    }

    void check_joints(const OpenSeams &seams, Warnings &warnings)
    {
      const auto &[pairs, beside] = seams;
      if (pairs.n > 0)
        warnings.push_back(
          {"blade/not_joined",
           fmt::format("{} pairs of nodes lie on one another, within {:g} % of the elements there, and are not joined: "
                       "the blade is cut there. The farthest, nodes {} and {}, are {}. Merge such nodes in the mesh "
                       "program, with a tolerance above this, if the blade is not meant to be cut.",
                       pairs.n, 1e2 * OpenSeams::near, pairs.labels[0], pairs.labels[1], describe(pairs))});
      if (beside.n > 0)
        warnings.push_back(
          {"blade/not_joined",
           fmt::format("{} nodes lie beside an element that has no node there, within {:g} % of its size, and are not "
                       "joined to it: the blade is cut there. The farthest, node {} and element {}, are {}. Mesh both "
                       "sides alike there if the blade is not meant to be cut.",
                       beside.n, 1e2 * OpenSeams::near, beside.labels[0], beside.labels[1], describe(beside))});
    }

    void check_file_notes(const CaseParameters &parameters, const FileNotes &notes, Warnings &warnings)
    {
      const auto add = [&](const std::string &text) {
        warnings.push_back({"blade/not_read", "'" + parameters.blade.mesh.file + "': " + text});
      };
      std::ranges::for_each(notes.always, add);
      if (parameters.blade.laminate.is_given())
        std::ranges::for_each(notes.of_plies, add);
    }
  } // namespace

  void check_mesh(const CaseParameters &parameters, const Blade &blade, Warnings &warnings)
  {
    const BladeCensus census  = blade.census();
    const bool        is_file = parameters.blade.mesh.generator == MeshGenerator::file;
    const std::size_t before  = warnings.size();
    check({"blade_size",
           "Largest length of the blade (root of its area)",
           std::sqrt(census.area),
           "m",
           3e-3,
           3.,
           {{"mm", 1e-3}}},
          warnings);
    if (is_file && warnings.size() > before)
      warnings.back().text += " Blade/Mesh/File scale is the length of the file's unit in m: 0.001 of a mesh in mm.";
    check_thickness(parameters, blade, census, warnings);
    check({"blade_mass", "Mass of the blade", census.mass, "kg", 1e-4, 200., {{"g", 1e-3}}}, warnings);
    check_supports(parameters, blade, census, warnings);
    if (const auto line = blade.span_line(); line && line->tip != line->root)
      {
        const Point3 span = (Point3(line->tip.data()) - Point3(line->root.data())).normalized();
        check_axis(parameters.blade.spin, span, warnings);
        if (is_file)
          check_reference_direction(parameters, span, warnings);
      }
    if (is_file && blade.kind() == BladeKind::shell)
      check_top(parameters.blade, blade.facets(), warnings);
    if (is_file)
      check_joints(census.seams, warnings);
    check_file_notes(parameters, census.file_notes, warnings);
    check_layers(parameters.blade, census, warnings);
    check_sizes(parameters.blade, census, warnings);
    warnings.insert(warnings.end(), census.warnings.begin(), census.warnings.end());
  }
} // namespace birdstrike
