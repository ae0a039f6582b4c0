#include "structure/nodes/mass_scaling.h"
#include <birdstrike/mesh/parameters.h>

#include <birdstrike/core/declare_choice.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/structure/parameters.h>

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    using namespace dealii::Patterns;

    const double tiny = 1e-12, lightest = 1e-30; ///< smallest length (m) and mass (kg) that are told from zero

    /// Three numbers as a comma list.
    void declare_vector(dealii::ParameterHandler &prm, const std::string &entry, std::array<double, 3> &member,
                        const std::string &text)
    {
      const auto value = [](const double x) { return dealii::Utilities::to_string(x); };
      prm.declare_entry(entry, value(member[0]) + ", " + value(member[1]) + ", " + value(member[2]),
                        List(Double(), 3, 3, ","), text);
      prm.add_action(entry, [&member, entry](const std::string &given) {
        const auto numbers = parse_numbers(given, 3, "Blade/" + entry);
        std::copy(numbers.begin(), numbers.end(), member.begin());
      });
    }

    void declare_element(dealii::ParameterHandler &prm, BladeParameters::Element &p)
    {
      prm.enter_subsection("Element");
      declare_choice(
        prm, "Formulation", p.formulation, element_formulations(),
        "Element formulation of the blade. automatic for a shell: physical. automatic for a solid: solid-shell for "
        "each brick that alone makes up the thickness, if the metal cannot fail; otherwise one point. Shells: physical "
        "has one point and physical stabilisation. Belytschko-Tsay has one point and perturbation hourglass control; "
        "it couples no bending to membrane within a warped or bent element. fully integrated has 2 x 2 points (MITC4) "
        "and is the reference for both. Solids: one point has physical stabilisation; it bends correctly in a single "
        "layer but yields as a whole. solid-shell has additional points through the thickness, and a single layer "
        "yields gradually. B-bar is fully integrated and needs several layers. [-]");
      declare_choice(
        prm, "Points rule", p.rule, thickness_rules(),
        "Rule of integration through the thickness. Lobatto: points on both faces. Gauss: higher accuracy. [-]");
      prm.add_parameter("Points through thickness", p.n_points,
                        "Number of integration points through the thickness: odd, from 3 to 15. [-]", Integer(3, 15));
      prm.add_parameter("Hourglass coefficient", p.hourglass,
                        "Stiffness coefficient of the perturbation hourglass control (Belytschko-Tsay only). It is the "
                        "same for membrane, transverse and rotation modes. [-]",
                        Double(0., 1.));
      prm.add_parameter("Shear factor", p.shear_factor, "Transverse shear correction factor kappa (Reissner). [-]",
                        Double(1e-3, 1.));
      prm.add_parameter(
        "Thinning", p.has_thinning,
        "Thinning of shells: their thickness follows the plane-stress strain. false: it stays constant. [-]");
      prm.add_parameter("Linear viscosity", p.linear_viscosity,
                        "Linear bulk viscosity b1 of solids against ringing: rho l c b1 times the rate of dilatation. "
                        "b1 is the share of critical damping in the highest mode of a slab. In a cube the share is "
                        "twice b1. Its work is counted in the energy balance. [-]",
                        Double(0., 1.));
      prm.add_parameter("Quadratic viscosity", p.quadratic_viscosity,
                        "Quadratic bulk viscosity of solids in compression. It spreads shocks over some elements. Its "
                        "work is counted in the energy balance. [-]",
                        Double(0., 10.));
      prm.leave_subsection();
    }

    void declare_material(dealii::ParameterHandler &prm, MetalParameters &metal, LaminateParameters &laminate,
                          const bool is_of_blade)
    {
      prm.enter_subsection("Material");
      metal.declare(prm);
      prm.leave_subsection();
      prm.enter_subsection("Laminate");
      laminate.declare(prm);
      if (is_of_blade)
        laminate.declare_materials(prm);
      prm.leave_subsection();
    }

    void declare_section(dealii::ParameterHandler &prm, const std::string &name, BladeParameters::Section &p)
    {
      prm.enter_subsection(name);
      prm.add_parameter(
        "Material ids", p.material_ids,
        "Ids or names of the cells that have this section instead of the blade's own, e.g. '1, coating'. Entries below "
        "that are not set take the blade's values. Empty: the section is not used. [-]",
        Anything());
      declare_choice(
        prm, "Formulation", p.formulation, element_formulations(),
        "Element formulation of the section: see Element/Formulation. automatic: the blade's formulation. [-]");
      prm.add_parameter(
        "Points through thickness", p.n_points,
        "Number of integration points of the section: see Element/Points through thickness. 0: the blade's number. [-]",
        Integer(0, 15));
      prm.add_parameter("Thickness", p.thickness,
                        "Thickness of shells: a number or a formula in x, y, z. It takes precedence over Thickness/By "
                        "material. Empty: the blade's thickness. [m]",
                        Anything());
      declare_material(prm, p.material, p.laminate, false);
      prm.leave_subsection();
    }

    void declare_supports(dealii::ParameterHandler &prm, BladeParameters::Supports &p)
    {
      prm.enter_subsection("Supports");
      prm.add_parameter("Clamped", p.clamped,
                        "Boundary ids or names whose nodes are constrained in all degrees of freedom, e.g. '0, 2' or "
                        "'root'. Built-in parts have root (0), tip (1), leading_edge and trailing_edge. automatic: the "
                        "root of a built-in part. A mesh from a file needs this entry or Hub: names or ids of the "
                        "file, 0 for all sides without a name, or nothing. [-]",
                        Anything());
      prm.add_parameter("Hub", p.hub,
                        "Boundary ids or names on the hub. They are clamped, and the reported section forces are "
                        "theirs. Empty: the clamped ids are that section. [-]",
                        Anything());
      prm.add_parameter("Free", p.free, "Boundary ids or names that must exist and have no constraints. [-]",
                        Anything());
      prm.add_parameter("Tip", p.tip, "Boundary ids or names of the tip row, where the tip deflection is taken. [-]",
                        Anything());
      prm.add_parameter("Held", p.held,
                        "Constrained components on boundary ids or names: '3: ux uy rz; tip: hinged'. clamped: all six "
                        "components. hinged: ux uy uz, which clamps whole faces of a solid. [-]",
                        Anything());
      prm.add_parameter(
        "Held boxes", p.held_boxes,
        "Constrained components on all nodes in a box: 'xmin ymin zmin xmax ymax zmax: ux uy; ...'. [m]", Anything());
      prm.add_parameter("Driven", p.driven,
                        "Prescribed displacements (rotations: rad) on boundary ids or names: '3: uz = "
                        "1e-3*sin(2*pi*100*t); 2: ux uy = 5*t'. They are formulas of the time t that begin at 0. A "
                        "component that is constrained, or prescribed by an earlier piece, stays so. [m]",
                        Anything());
      prm.leave_subsection();
    }

    void declare_loads(dealii::ParameterHandler &prm, BladeParameters::Loads &p)
    {
      prm.enter_subsection("Loads");
      prm.add_parameter("Pressure", p.pressure,
                        "Follower pressure: a formula in x, y, z, t (reference position). Positive values push along "
                        "the surface normal, which is +z on the built-in plate. [Pa]",
                        Anything());
      prm.add_parameter("Pressure boundaries", p.pressure_boundaries,
                        "Boundary ids or names of a solid whose faces the pressure pushes inwards. 5, the built-in "
                        "face on the side opposite to the normal, makes it push as on the shell. [-]",
                        Anything());
      prm.add_parameter("Point loads", p.point_loads,
                        "Point loads with constant direction: 'x y z: fx; fy; fz | ...', formulas in t. Six formulas "
                        "add moments. A load acts on the nearest node, on a solid at the place itself. [N]",
                        Anything());
      prm.add_parameter("Damping", p.damping,
                        "Mass-proportional damping of all degrees of freedom, for dynamic relaxation. Its work is "
                        "counted in the energy balance. [1/s]",
                        Double(0.));
      prm.add_parameter("Initial velocity", p.initial_velocity,
                        "Velocity of the nodes at the start: three formulas in x, y, z, 'vx; vy; vz'. [m/s]",
                        Anything());
      prm.add_parameter(
        "Initial spin", p.initial_spin,
        "Rigid rotation about the origin at the start: 'wx; wy; wz'. It is added to Initial velocity. [rad/s]",
        Anything());
      prm.leave_subsection();
    }

    void declare_spin(dealii::ParameterHandler &prm, BladeParameters::Spin &p)
    {
      prm.enter_subsection("Spin");
      prm.add_parameter(
        "Speed", p.speed,
        "Speed of the hub, right-handed about the axis: a number ('5730 rpm' is allowed), or a formula of the time t "
        "in rad/s. A shaft that runs down has '600 - 2e3*t'. Clamped nodes follow the rotation. The blade starts in "
        "the equilibrium of its tension at t = 0. 0: the hub stands still. [rad/s]",
        Anything());
      declare_vector(prm, "Axis", p.axis, "Direction of the axis of rotation, of any length. [-]");
      declare_vector(prm, "Centre", p.centre, "Point on the axis of rotation. [m]");
      prm.add_parameter("Prestress", p.has_prestress,
                        "Static equilibrium under spin and the loads of t = 0 before the first step. false: the blade "
                        "starts unstressed and rings. [-]");
      prm.add_parameter("Load steps", p.n_load_steps,
                        "Number of steps in which the static solve applies spin and loads. A step that does not "
                        "converge is halved. [-]",
                        Integer(1, 1000));
      declare_choice(prm, "Linear solver", p.linear_solver, linear_solvers(),
                     "Linear solver of static equilibrium and modes. direct: factors. multigrid: Krylov's methods with "
                     "algebraic multigrid as preconditioner; their memory is proportional to the size of the mesh. "
                     "automatic: multigrid beyond 50 000 unknowns. [-]");
      prm.leave_subsection();
    }

    void declare_rigid(dealii::ParameterHandler &prm, BladeParameters::Rigid &p)
    {
      prm.enter_subsection("Rigid");
      declare_choice(prm, "Surface", p.surface, rigid_surfaces(),
                     "Kind of the rigid surface. rectangle: one rectangle. mesh: the facets of the mesh. [-]");
      declare_vector(prm, "Centre", p.centre, "Centre of the rectangle. [m]");
      declare_vector(prm, "Normal", p.normal,
                     "Normal of the rectangle, of any length. It is also the direction of the free motion. [-]");
      prm.add_parameter("Length", p.length, "Length of the rectangle, along x if the normal is z. [m]", Double(tiny));
      prm.add_parameter("Width", p.width, "Width of the rectangle, along y if the normal is z. [m]", Double(tiny));
      prm.add_parameter("Half thickness", p.half_thickness,
                        "Half of the rigid surface's thickness: the material on either side of it. [m]", Double(0.));
      declare_choice(prm, "Motion", p.motion, rigid_motions(),
                     "Motion of the rigid surface. fixed: none. free along normal: it moves along its normal. [-]");
      prm.add_parameter("Mass", p.mass, "Mass of the rigid surface that is free to move. [kg]", Double(lightest));
      prm.leave_subsection();
    }
  } // namespace

  bool BladeParameters::is_deformable() const
  {
    return kind == BladeKind::shell || kind == BladeKind::solid;
  }

  ShellFormulation BladeParameters::shell_formulation() const
  {
    const auto *named = std::get_if<ShellFormulation>(&element.formulation);
    return named != nullptr ? *named : ShellFormulation::one_point_physical;
  }

  SolidFormulation BladeParameters::solid_formulation(const unsigned int n_layers) const
  {
    if (const auto *named = std::get_if<SolidFormulation>(&element.formulation))
      return *named;
    return n_layers == 1 && !material.metal().failure.can_fail() ? SolidFormulation::solid_shell
                                                                 : SolidFormulation::one_point;
  }

  bool BladeParameters::may_be_solid_shell() const
  {
    const unsigned int fewest = mesh.generator == MeshGenerator::file ? 1 : mesh.n_layers;
    return kind == BladeKind::solid && solid_formulation(fewest) == SolidFormulation::solid_shell;
  }

  std::map<std::size_t, BladeParameters> BladeParameters::by_section() const
  {
    std::map<std::size_t, BladeParameters> result{{0, *this}};
    result[0].laminate = laminate.with_others(LaminateParameters::of_blade());
    for (std::size_t k = 0; k < n_sections; ++k)
      {
        const Section &section = sections[k];
        if (parse_words(section.material_ids).empty())
          continue;
        BladeParameters &changed = result[k + 1] = result[0];
        if (!std::holds_alternative<std::monostate>(section.formulation))
          changed.element.formulation = section.formulation;
        if (section.n_points > 0)
          changed.element.n_points = section.n_points;
        if (section.material.name != Section::same)
          {
            changed.material = section.material;
            changed.laminate.plies.clear();
          }
        if (section.laminate.is_given())
          changed.laminate = section.laminate.with_others(result[0].laminate);
      }
    return result;
  }

  bool BladeParameters::is_laminate() const
  {
    return laminate.is_given();
  }

  bool BladeParameters::material_can_fail() const
  {
    return is_laminate() ? laminate.can_fail() : material.metal().failure.can_fail();
  }

  double BladeParameters::density() const
  {
    return is_laminate() ? laminate.density() : material.metal().density;
  }

  std::string BladeParameters::section_path(const std::size_t section)
  {
    return section == 0 ? "" : "Section " + std::to_string(section) + "/";
  }

  void BladeParameters::declare(dealii::ParameterHandler &prm)
  {
    declare_choice(prm, "Kind", kind, blade_kinds(),
                   "Kind of the target. shell: a blade of shell elements. solid: a blade of solid elements. rigid: a "
                   "rigid surface without finite elements. none: no target. [-]");
    prm.add_parameter("Probes", probes,
                      "Watched nodes: 'name: x y z; ...'. Each name takes the node nearest to its point. [m]",
                      Anything());
    mesh.declare(prm);
    thickness.declare(prm);
    declare_element(prm, element);
    declare_mass_scaling(prm, mass_scaling);
    declare_material(prm, material, laminate, true);
    for (std::size_t k = 0; k < n_sections; ++k)
      declare_section(prm, "Section " + std::to_string(k + 1), sections[k]);
    declare_supports(prm, supports);
    declare_loads(prm, loads);
    declare_spin(prm, spin);
    declare_rigid(prm, rigid);
  }
} // namespace birdstrike
