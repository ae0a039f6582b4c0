#include <birdstrike/core/errors.h>
#include <birdstrike/core/expression.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/structure/parameters.h>
#include <birdstrike/structure/rotor.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace birdstrike
{
  namespace
  {
    void require(const bool condition, const std::string &message)
    {
      if (!condition)
        throw InputError("Blade/" + message);
    }
  } // namespace

  bool BladeParameters::has_points_through_thickness() const
  {
    return kind != BladeKind::solid || may_be_solid_shell();
  }

  bool BladeParameters::can_fail() const
  {
    const auto in_use = by_section();
    return std::any_of(in_use.begin(), in_use.end(),
                       [](const auto &section) { return section.second.material_can_fail(); });
  }

  void BladeParameters::check_spin() const
  {
    if (!Rotor(spin).turns())
      return;
    const auto refuse = [](const bool is_there, const std::string &entry, const std::string &why) {
      require(!is_there, entry + " does not go with Spin/Speed: " + why);
    };
    require(std::hypot(spin.axis[0], spin.axis[1], spin.axis[2]) > 0.,
            "Spin/Axis: the axis has no length.\nAllowed: any three numbers that are not all zero.");
    require(is_deformable(), "Spin/Speed: a rigid surface does not turn.\nSet it to 0, or Kind to shell or solid.");
    require(!is_halved, "Spin/Speed: a blade that turns has no plane of symmetry.\nSet Symmetry to none.");
    refuse(is_present(supports.driven), "Supports/Driven", "constrained nodes follow the hub.\nLeave it empty.");
    refuse(is_present(loads.initial_velocity), "Loads/Initial velocity", "the blade starts turning.\nLeave it empty.");
    refuse(is_present(loads.initial_spin), "Loads/Initial spin", "the hub turns with the blade.\nLeave one of them.");
    refuse(loads.damping != 0., "Loads/Damping", "it would brake the rotation.\nSet it to 0.");
    refuse(mass_scaling.method != MassScalingMethod::off, "Mass scaling/Method",
           "it does not know driven supports.\nSet it to off.");
  }

  void BladeParameters::check() const
  {
    if (kind == BladeKind::none)
      return;
    check_spin();
    check_row();
    require(mesh.row.n_blades == 1 || std::hypot(spin.axis[0], spin.axis[1], spin.axis[2]) > 0.,
            "Spin/Axis: the axis of the row has no length.\nAllowed: any three numbers that are not all zero.");
    require(mesh.generator == MeshGenerator::file || mesh.file.empty() ||
              !(is_deformable() || rigid.surface == RigidSurface::mesh),
            "Mesh/File: a file is named, and Generator takes another mesh.\nSet Mesh/Generator = file, or leave File "
            "empty.");
    require(mesh.row.n_blades == 1 || mass_scaling.method == MassScalingMethod::off,
            "Mass scaling/Method: it knows one blade, not a row.\nSet it to off, or Mesh/Row/Blades to 1.");
    if (is_deformable() || rigid.surface == RigidSurface::mesh)
      require(
        mesh.generator != MeshGenerator::file || !mesh.file.empty(),
        "Mesh/File: the generator is 'file' but no file is named.\nName a .msh file, or set Generator = flat plate.");
    if (kind == BladeKind::rigid)
      {
        require(std::hypot(rigid.normal[0], rigid.normal[1], rigid.normal[2]) > 0.,
                "Rigid/Normal: the normal has no length.\nAllowed: any three numbers that are not all zero.");
        require(by_section().size() == 1, "Section 1 to 3/Material ids: a rigid surface has no elements.\nLeave them "
                                          "empty, or set Kind to shell or solid.");
        return;
      }
    std::set<std::string> names;
    for (const auto &[probe, place] : parse_pairs(probes, "Blade/Probes"))
      {
        std::string column = probe; // as histories spell it
        std::replace_if(
          column.begin(), column.end(), [](const char c) { return c == ' ' || c == ',' || c == '/' || c == '\t'; },
          '_');
        require(names.insert(column).second,
                "Probes: two are called '" + probe + "'.\nGive each a name of its own: it names their curves.");
      }
    check_geometry();
    require(kind != BladeKind::solid || thickness.by_material.empty(),
            "Thickness/By material: bricks are as thick as the mesh, built-in ones as Value or Maximum say.\nLeave it "
            "empty, or set Kind = shell.");
    require(kind != BladeKind::solid || thickness.table.empty(),
            "Thickness/Table: bricks are as thick as the mesh.\nLeave it empty, or set Kind = shell.");
    require(kind != BladeKind::solid || mesh.generator != MeshGenerator::file || thickness.maximum.empty(),
            "Thickness/Maximum: bricks of a file are as thick as the mesh.\nLeave it empty, or set Kind = shell.");
    for (const auto &[number, of_section] : by_section())
      of_section.check_elements(number);
  }

  void BladeParameters::check_elements(const std::size_t section) const
  {
    const bool        is_solid = kind == BladeKind::solid;
    const std::string where    = section_path(section);
    if (section > 0)
      {
        const Section &given = sections[section - 1];
        require(given.material.name != Section::same || given.material == MetalParameters{Section::same},
                where + "Material: entries are set, but no Name.\nName the metal that they change.");
        require(given.laminate.is_given() || given.laminate == LaminateParameters(),
                where + "Laminate: entries are set, but no Plies.\nGive the plies that they belong to, or set them in "
                        "Blade/Laminate.");
        require(!given.laminate.is_given() || given.material.name == Section::same,
                where + "Laminate/Plies and " + where +
                  "Material/Name are both given.\nLeave one of them out: a section is of plies or of a metal.");
        require(!is_solid || given.thickness.empty(),
                where + "Thickness: bricks are as thick as the mesh.\nLeave it empty, or set Kind = shell.");
      }
    require(is_solid ? !std::holds_alternative<ShellFormulation>(element.formulation)
                     : !std::holds_alternative<SolidFormulation>(element.formulation),
            where + (where.empty() ? "Element/Formulation: '" : "Formulation: '") +
              element_formulations().name(element.formulation) + "' is no element of a " + blade_kinds().name(kind) +
              ".\nAllowed for it: automatic|" +
              (is_solid ? "one point|solid-shell|B-bar" : "physical|Belytschko-Tsay|fully integrated") +
              ". Set one of them, or change Blade/Kind.");
    require(element.n_points % 2 == 1, where + (where.empty() ? "Element/" : "") +
                                         "Points through thickness: " + std::to_string(element.n_points) +
                                         " was read.\nAllowed: odd numbers from 3 to 15.");
    if (is_laminate())
      return check_laminate(section);
    const bool can_fail = material.metal("Blade/" + where + "Material/").failure.can_fail();
    require(!can_fail || !may_be_solid_shell(),
            where +
              "Material/Failure is not there for solid-shells.\nSet it to none, or Formulation to another element.");
    require(!is_solid || !can_fail || mass_scaling.method == MassScalingMethod::off,
            "Mass scaling/Method: inertia that is added between nodes is not taken out again with elements that fail.\n"
            "Set it to off, or " +
              where + "Material/Failure to none.");
  }

  void BladeParameters::check_laminate(const std::size_t section) const
  {
    require(mesh.row.n_blades == 1,
            "Mesh/Row/Blades: the reference direction of plies is that of one blade, not of a row.\nSet it to 1, or "
            "leave Laminate/Plies empty.");
    const std::string where = section_path(section) + "Laminate/";
    require(kind != BladeKind::solid,
            where + "Plies: there are no laminates of bricks.\nSet Blade/Kind = shell, or leave Plies empty.");
    laminate.check("Blade/" + where);
    require(!is_halved || laminate.is_symmetric_about_y(),
            where + "Plies: half a blade stands for a whole one whose plies are mirrored about y = 0, and only those "
                    "along and across a Reference direction in or across that plane are their own mirror images.\n"
                    "Set Symmetry to none.");
  }

  std::vector<std::string> BladeParameters::unused_entries() const
  {
    const BladeParameters    defaults;
    std::vector<std::string> unused;
    const auto               add = [&](const BladeKind of_kind, const std::string &name, const bool is_changed) {
      if (is_changed && kind != of_kind && is_deformable())
        unused.push_back(name);
    };
    const Element &e = element, &d = defaults.element;
    const auto     sections_in_use = by_section();
    const auto     differ = [](const double a, const double b) { return std::abs(a - b) > 1e-5 * b; }; // printed digits
    if (std::none_of(sections_in_use.begin(), sections_in_use.end(),
                     [](const auto &section) { return section.second.has_points_through_thickness(); }))
      {
        add(BladeKind::shell, "Element/Points rule", e.rule != d.rule);
        add(BladeKind::shell, "Element/Points through thickness", e.n_points != d.n_points);
      }
    for (const auto &[number, of_section] : sections_in_use)
      add(BladeKind::shell, section_path(number) + "Points through thickness",
          number > 0 && sections[number - 1].n_points > 0 && !of_section.has_points_through_thickness());
    add(BladeKind::shell, "Element/Hourglass coefficient", differ(e.hourglass, d.hourglass));
    add(BladeKind::shell, "Element/Shear factor", differ(e.shear_factor, d.shear_factor));
    add(BladeKind::shell, "Element/Thinning", e.has_thinning != d.has_thinning);
    add(BladeKind::solid, "Element/Linear viscosity", differ(e.linear_viscosity, d.linear_viscosity));
    add(BladeKind::solid, "Element/Quadratic viscosity", differ(e.quadratic_viscosity, d.quadratic_viscosity));
    add(BladeKind::solid, "Loads/Pressure boundaries", loads.pressure_boundaries != defaults.loads.pressure_boundaries);
    add(BladeKind::solid, "Mesh/Layers", mesh.n_layers != defaults.mesh.n_layers);
    add(BladeKind::solid, "Mesh/Layer grading", differ(mesh.layer_grading, defaults.mesh.layer_grading));
    if (is_deformable() && !laminate.is_given() && laminate != defaults.laminate)
      unused.emplace_back("Laminate (there are no Plies)");
    if (is_deformable() && laminate.is_given() && material.name != defaults.material.name)
      unused.emplace_back("Material/Name (Laminate has Plies)");
    const MassScaling &m = mass_scaling, &n = defaults.mass_scaling;
    add(BladeKind::solid, "Mass scaling/Method", m.method != n.method);
    add(BladeKind::solid, "Mass scaling/Largest added inertia", differ(m.largest_added, n.largest_added));
    add(BladeKind::solid, "Mass scaling/Target step", m.target_step != n.target_step);
    return unused;
  }
} // namespace birdstrike
