#include "simulation/warnings/unused_entries.h"
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/material/unused_entries.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace birdstrike
{
  namespace
  {
    class Finder
    {
    public:
      explicit Finder(const CaseParameters &parameters) : parameters(parameters), blade(parameters.blade)
      {
      }

      Warnings find()
      {
        for (const std::string &entry : blade.unused_entries())
          warnings.push_back({"entry/unused", "Blade/" + entry + " is set, and means nothing for a blade of kind '" +
                                                blade_kinds().name(blade.kind) + "'."});
        for (std::size_t k = 1; k <= blade.sections.size(); ++k)
          if (const auto &section = blade.sections[k - 1];
              section.material_ids.empty() && section != BladeParameters::Section{})
            warnings.push_back({"entry/unused", "Blade/" + BladeParameters::section_path(k) +
                                                  "Material ids is empty: no other entry of this section is used."});
        if (blade.is_deformable())
          {
            add_mesh();
            add_profile();
            add_thickness();
            add_metals();
          }
        if (blade.kind == BladeKind::shell)
          add_shells();
        add_row();
        add_rigid();
        add_liquids();
        for (const BirdCase &each : parameters.birds())
          add_correction(each.bird);
        for (const CaseParameters::FurtherBird &each : parameters.further_birds)
          if (!each.bird.enabled && !parameters.is_blade_alone && parameters.file.is_changed(each.bird.section))
            warnings.push_back(
              {"entry/unused", each.bird.section + "/Enabled is false: no other entry of this section is used."});
        return warnings;
      }

    private:
      const CaseParameters  &parameters;
      const BladeParameters &blade;
      const BladeParameters  standard;
      Warnings               warnings;

      void add(const std::string &entry, const bool is_changed, const std::string &reason)
      {
        if (is_changed)
          warnings.push_back({"entry/unused", entry + " is set, and means nothing: " + reason + "."});
      }

      static bool differ(const double a, const double b) // beyond what a written file rounds
      {
        return std::abs(a - b) > 1e-5 * std::abs(b);
      }

      void add_mesh()
      {
        const MeshParameters &m = blade.mesh, &d = standard.mesh;
        if (m.generator != MeshGenerator::file)
          {
            add("Blade/Mesh/Top", !m.top.empty(), "Mesh/Generator is not file");
            add("Blade/Mesh/File scale", differ(m.file_scale, d.file_scale), "Mesh/Generator is not file");
            return;
          }
        add("Blade/Mesh/Top", !m.top.empty() && blade.kind == BladeKind::solid, "a solid has no top face");
        const std::string path = "Blade/Mesh/", reason = "Mesh/Generator is file";
        add(path + "Length", differ(m.length, d.length), reason);
        add(path + "Chord", differ(m.chord, d.chord), reason);
        add(path + "Elements along span", m.n_span != d.n_span, reason);
        add(path + "Elements along chord", m.n_chord != d.n_chord, reason);
        add(path + "Span grading", differ(m.span_grading, d.span_grading), reason);
        add(path + "Chord grading", differ(m.chord_grading, d.chord_grading), reason);
        add(path + "Layers", m.n_layers != d.n_layers, reason);
        add(path + "Layer grading", differ(m.layer_grading, d.layer_grading), reason);
      }

      void add_profile()
      {
        if (blade.mesh.generator == MeshGenerator::blade)
          return;
        const std::string reason =
          blade.mesh.generator == MeshGenerator::file ? "Mesh/Generator is file" : "Mesh/Generator is flat plate";
        const MeshParameters::Profile &p = blade.mesh.profile, &d = standard.mesh.profile;
        const std::string              path = "Blade/Mesh/Profile/";
        add(path + "Root radius", differ(p.root_radius, d.root_radius), reason);
        add(path + "Camber line", p.camber_line != d.camber_line, reason);
        add(path + "Stacking point", differ(p.stacking_point, d.stacking_point), reason);
        for (const auto &[name, text, usual] :
             {std::tuple("Chord law", &p.chord, &d.chord), std::tuple("Stagger", &p.stagger, &d.stagger),
              std::tuple("Camber", &p.camber, &d.camber), std::tuple("Sweep", &p.sweep, &d.sweep),
              std::tuple("Lean", &p.lean, &d.lean)})
          add(path + name, *text != *usual, reason);
      }

      void add_thickness()
      {
        const ThicknessParameters &t = blade.thickness, &d = standard.thickness;
        add("Blade/Thickness/Value",
            blade.kind == BladeKind::solid && blade.mesh.generator == MeshGenerator::file && t.value != d.value,
            "bricks of a file are as thick as the mesh");
        if (!t.maximum.empty())
          return;
        const std::string path = "Blade/Thickness/", reason = "Thickness/Maximum is empty";
        add(path + "Leading edge", t.leading_edge != d.leading_edge, reason);
        add(path + "Trailing edge", t.trailing_edge != d.trailing_edge, reason);
        add(path + "Maximum station", differ(t.maximum_station, d.maximum_station), reason);
      }

      void add_row()
      {
        const MeshParameters::Row &row = blade.mesh.row;
        add("Blade/Mesh/Row/Pitch", row.n_blades == 1 && differ(row.pitch, standard.mesh.row.pitch),
            "Mesh/Row/Blades is 1");
      }

      void add_rigid()
      {
        const BladeParameters::Rigid &r = blade.rigid, &d = standard.rigid;
        const std::string             path = "Blade/Rigid/";
        if (blade.kind == BladeKind::rigid)
          return add(path + "Mass", r.motion == RigidMotion::fixed && differ(r.mass, d.mass), "Rigid/Motion is fixed");
        const std::string reason = "Blade/Kind is " + blade_kinds().name(blade.kind);
        add(path + "Surface", r.surface != d.surface, reason);
        add(path + "Centre", r.centre != d.centre, reason);
        add(path + "Normal", r.normal != d.normal, reason);
        add(path + "Length", differ(r.length, d.length), reason);
        add(path + "Width", differ(r.width, d.width), reason);
        add(path + "Half thickness", differ(r.half_thickness, d.half_thickness), reason);
        add(path + "Motion", r.motion != d.motion, reason);
        add(path + "Mass", differ(r.mass, d.mass), reason);
      }

      void add_metals()
      {
        for (const auto &[number, of_section] : blade.by_section())
          if (!of_section.is_laminate() &&
              (number == 0 || blade.sections[number - 1].material.name != BladeParameters::Section::same))
            for (const UnusedEntry &entry : unused_entries(of_section.material))
              add("Blade/" + BladeParameters::section_path(number) + "Material/" + entry.name, true, entry.reason);
      }

      void add_shells()
      {
        const auto sections = blade.by_section();
        const auto none_has = [&](const auto &has) {
          return std::ranges::none_of(sections, [&](const auto &section) { return has(section.second); });
        };
        const BladeParameters::Element &e = blade.element, &d = standard.element;
        add("Blade/Element/Hourglass coefficient",
            differ(e.hourglass, d.hourglass) && none_has([](const BladeParameters &of_section) {
              return of_section.shell_formulation() == ShellFormulation::belytschko_tsay;
            }),
            "it is that of Belytschko-Tsay shells, and there are none");
        const bool        has_metal = !none_has([](const BladeParameters &of) { return !of.is_laminate(); });
        const std::string plies = "all sections are of plies, which are integrated exactly and keep their thickness";
        add("Blade/Element/Shear factor", differ(e.shear_factor, d.shear_factor) && !has_metal, plies);
        add("Blade/Element/Thinning", e.has_thinning != d.has_thinning && !has_metal, plies);
        add("Blade/Element/Points rule", e.rule != d.rule && !has_metal, plies);
        add("Blade/Element/Points through thickness", e.n_points != d.n_points && !has_metal, plies);
        for (const auto &[number, of_section] : sections)
          add("Blade/" + BladeParameters::section_path(number) + "Points through thickness",
              number > 0 && blade.sections[number - 1].n_points > 0 && of_section.is_laminate(),
              "the section is of plies, which are integrated exactly");
        MetalParameters only_named;
        only_named.name = blade.material.name; // of which BladeParameters::unused_entries tells
        add("Blade/Material", blade.laminate.is_given() && blade.material != only_named,
            "Laminate has Plies, so that no entry of it is used");
      }

      void add_correction(const BirdParameters &bird)
      {
        const std::string path = bird.section + "/Correction interval";
        if (!bird.enabled || bird.correction_interval == BirdParameters().correction_interval)
          return;
        add(path, !bird.is_riemann(), "Formulation is standard");
        add(path, bird.is_riemann() && !bird.gradient_correction, "Gradient correction is false");
        add(path, bird.reconstruction == Reconstruction::linear, "linear reconstruction renews the matrices at each");
        add(path, bird.has_strength(), "a bird with strength renews the matrices at each");
      }

      /// What a further bird has of the first one is told of that one alone.
      void add_liquids()
      {
        std::vector<UnusedEntry> of_first;
        for (const BirdCase &each : parameters.birds())
          {
            const std::vector<UnusedEntry> unused = unused_entries(each.liquid);
            for (const UnusedEntry &entry : unused)
              add(each.bird.section + "/Equation of state/" + entry.name,
                  std::ranges::none_of(of_first, [&](const UnusedEntry &other) { return other.name == entry.name; }),
                  entry.reason);
            if (each.number == 1)
              of_first = unused;
          }
      }
    };
  } // namespace

  Warnings find_unused_entries(const CaseParameters &parameters)
  {
    return Finder(parameters).find();
  }
} // namespace birdstrike
