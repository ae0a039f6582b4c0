#include "structure/nodes/mass_scaling.h"
#include <birdstrike/mesh/parameters.h>

#include <birdstrike/core/declare_choice.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/structure/parameters.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    using namespace dealii::Patterns;

    const double tiny = 1e-12; ///< smallest length and mass that is told from zero

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
        "Automatic: physical for a shell; solid-shell for a built-in part of one layer whose metal does not fail, "
        "one point for all other solids. Shells: one point with physical "
        "stabilisation and warping correction, or plain Belytschko-Tsay with perturbation hourglass "
        "control; or fully integrated (2 x 2 points, MITC4), the reference for both. Solids: one point with "
        "physical stabilisation, which bends right in a single layer but flows as a whole; solid-shell, the same "
        "with points through the thickness, which yields layer by layer in a single one; or B-bar, fully "
        "integrated, which needs layers. [-]");
      declare_choice(prm, "Points rule", p.rule, thickness_rules(),
                     "Integration through the thickness; Lobatto has points on both faces, Gauss is exacter. [-]");
      prm.add_parameter("Points through thickness", p.n_points,
                        "Number of points through the thickness: 3, 5 or 7. [-]", Integer(3, 7));
      prm.add_parameter("Hourglass coefficient", p.hourglass,
                        "Perturbation hourglass stiffness (Belytschko-Tsay only), membrane, transverse and rotation "
                        "alike. [-]",
                        Double(0., 1.));
      prm.add_parameter("Shear factor", p.shear_factor, "Reissner's transverse shear factor kappa. [-]",
                        Double(1e-3, 1.));
      prm.add_parameter("Thinning", p.has_thinning, "Whether the thickness follows the plane-stress strain. [-]");
      prm.add_parameter("Linear viscosity", p.linear_viscosity,
                        "Factor b1 of the bulk viscosity of solids against ringing, rho l c b1 times the rate of "
                        "dilatation: the share of critical damping in the highest mode of a slab, twice that in a "
                        "cube; its work is booked. [-]",
                        Double(0., 1.));
      prm.add_parameter("Quadratic viscosity", p.quadratic_viscosity,
                        "Bulk viscosity of solids in compression, which spreads shocks over some elements; its work is "
                        "booked. [-]",
                        Double(0., 10.));
      prm.leave_subsection();
    }

    void declare_supports(dealii::ParameterHandler &prm, BladeParameters::Supports &p)
    {
      prm.enter_subsection("Supports");
      prm.add_parameter("Clamped", p.clamped,
                        "Boundary ids whose nodes are held in all their unknowns, e.g. '0, 2'. [-]", Anything());
      prm.add_parameter("Hub", p.hub,
                        "Boundary ids that sit on the hub: clamped, and the section whose forces are reported (without "
                        "them the clamped ids are). [-]",
                        Anything());
      prm.add_parameter("Free", p.free, "Boundary ids that must exist and are held by nothing. [-]", Anything());
      prm.add_parameter("Tip", p.tip, "Boundary ids of the tip row, where the tip deflection is taken. [-]",
                        Anything());
      prm.add_parameter(
        "Held", p.held,
        "Components held on boundary ids: '3: ux uy rz; 2: hinged'; clamped is all six, hinged is ux uy "
        "uz. [-]",
        Anything());
      prm.add_parameter("Held boxes", p.held_boxes,
                        "Components held on all nodes in a box: 'xmin ymin zmin xmax ymax zmax: ux uy; ...'. [m]",
                        Anything());
      prm.add_parameter("Driven", p.driven,
                        "Displacements (rotations: rad) on boundary ids as formulas of the time t that begin at 0: '3: "
                        "uz = 1e-3*sin(2*pi*100*t); 2: ux uy = 5*t'. A component that is held, or driven by an earlier "
                        "piece, stays so. [m]",
                        Anything());
      prm.leave_subsection();
    }

    void declare_loads(dealii::ParameterHandler &prm, BladeParameters::Loads &p)
    {
      prm.enter_subsection("Loads");
      prm.add_parameter("Pressure", p.pressure,
                        "Follower pressure, a formula in x, y, z, t (reference position); positive pushes along the "
                        "surface normal, +z on the built-in plate. [Pa]",
                        Anything());
      prm.add_parameter("Pressure boundaries", p.pressure_boundaries,
                        "Boundary ids of a solid whose faces the pressure pushes inwards; 5, the built-in face on the "
                        "side of minus the normal, makes it push as on the shell. [-]",
                        Anything());
      prm.add_parameter("Point loads", p.point_loads,
                        "Dead forces, and if six formulas are given moments, on the nearest node: 'x y z: fx; fy; fz | "
                        "...', formulas in t. [N]",
                        Anything());
      prm.add_parameter("Damping", p.damping,
                        "Mass-proportional damping of every unknown, for dynamic relaxation; its work is booked. [1/s]",
                        Double(0.));
      prm.add_parameter("Initial velocity", p.initial_velocity,
                        "Velocity of the nodes at the start, three formulas in x, y, z: 'vx; vy; vz'. [m/s]",
                        Anything());
      prm.add_parameter("Initial spin", p.initial_spin,
                        "Rigid rotation about the origin at the start, added to the velocity: 'wx; wy; wz'. [rad/s]",
                        Anything());
      prm.leave_subsection();
    }

    void declare_rigid(dealii::ParameterHandler &prm, BladeParameters::Rigid &p)
    {
      prm.enter_subsection("Rigid");
      declare_choice(prm, "Surface", p.surface, rigid_surfaces(),
                     "Rigid surface: one rectangle, or the facets of the mesh. [-]");
      declare_vector(prm, "Centre", p.centre, "Centre of the rectangle. [m]");
      declare_vector(prm, "Normal", p.normal,
                     "Normal of the rectangle, of any length; also the direction of the free motion. [-]");
      prm.add_parameter("Length", p.length, "Length of the rectangle, along x if the normal is z. [m]", Double(tiny));
      prm.add_parameter("Width", p.width, "Width of the rectangle, along y if the normal is z. [m]", Double(tiny));
      prm.add_parameter("Half thickness", p.half_thickness, "Material on either side of the surface. [m]", Double(0.));
      declare_choice(prm, "Motion", p.motion, rigid_motions(),
                     "Whether the surface is fixed or free to move along its normal. [-]");
      prm.add_parameter("Mass", p.mass, "Mass of the free surface. [kg]", Double(tiny));
      prm.leave_subsection();
    }

    void require(const bool condition, const std::string &message)
    {
      if (!condition)
        throw InputError("Blade/" + message);
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

  SolidFormulation BladeParameters::solid_formulation() const
  {
    if (const auto *named = std::get_if<SolidFormulation>(&element.formulation))
      return *named;
    const bool is_one_layer = mesh.generator != "file" && mesh.n_layers == 1;
    return is_one_layer && !material.metal().failure.can_fail() ? SolidFormulation::solid_shell
                                                                : SolidFormulation::one_point;
  }

  std::string BladeParameters::formulation_name() const
  {
    return kind == BladeKind::shell   ? element_formulations().name(shell_formulation())
           : kind == BladeKind::solid ? element_formulations().name(solid_formulation())
                                      : "";
  }

  void BladeParameters::declare(dealii::ParameterHandler &prm)
  {
    declare_choice(prm, "Kind", kind, blade_kinds(),
                   "What the bird meets: a blade of shell or of solid elements, a rigid surface without finite "
                   "elements, or nothing. [-]");
    prm.add_parameter("Probes", probes, "Watched nodes, the nearest to each point: 'name: x y z; ...'. [m]",
                      Anything());
    mesh.declare(prm);
    thickness.declare(prm);
    declare_element(prm, element);
    declare_mass_scaling(prm, mass_scaling);
    prm.enter_subsection("Material");
    material.declare(prm);
    prm.leave_subsection();
    declare_supports(prm, supports);
    declare_loads(prm, loads);
    declare_rigid(prm, rigid);
  }

  void BladeParameters::check() const
  {
    if (kind == BladeKind::none)
      return;
    if (is_deformable() || rigid.surface == RigidSurface::mesh)
      require(
        mesh.generator != "file" || !mesh.file.empty(),
        "Mesh/File: the generator is 'file' but no file is named.\nName a .msh file, or set Generator = flat plate.");
    if (kind == BladeKind::rigid)
      {
        require(std::hypot(rigid.normal[0], rigid.normal[1], rigid.normal[2]) > 0.,
                "Rigid/Normal: the normal has no length.\nAllowed: any three numbers that are not all zero.");
        return;
      }
    check_geometry();
    const bool is_solid = kind == BladeKind::solid;
    require(is_solid ? !std::holds_alternative<ShellFormulation>(element.formulation)
                     : !std::holds_alternative<SolidFormulation>(element.formulation),
            "Element/Formulation: '" + element_formulations().name(element.formulation) + "' is no element of a " +
              blade_kinds().name(kind) + ".\nAllowed for it: automatic|" +
              (is_solid ? "one point|solid-shell|B-bar" : "physical|Belytschko-Tsay|fully integrated") +
              ". Set one of them, or change Blade/Kind.");
    require(element.n_points == 3 || element.n_points == 5 || element.n_points == 7,
            "Element/Points through thickness: " + std::to_string(element.n_points) + " was read.\nAllowed: 3, 5, 7.");
    material.check();
    require(!is_solid || mass_scaling.method == MassScalingMethod::off || !material.metal().failure.can_fail(),
            "Mass scaling/Method: inertia that is added between nodes is not taken out again with elements that fail.\n"
            "Set it to off, or Material/Failure to none.");
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
    const auto     differ = [](const double a, const double b) { return std::abs(a - b) > 1e-5 * b; }; // printed digits
    if (kind != BladeKind::solid || solid_formulation() != SolidFormulation::solid_shell)
      {
        add(BladeKind::shell, "Element/Points rule", e.rule != d.rule);
        add(BladeKind::shell, "Element/Points through thickness", e.n_points != d.n_points);
      }
    add(BladeKind::shell, "Element/Hourglass coefficient", differ(e.hourglass, d.hourglass));
    add(BladeKind::shell, "Element/Shear factor", differ(e.shear_factor, d.shear_factor));
    add(BladeKind::shell, "Element/Thinning", e.has_thinning != d.has_thinning);
    add(BladeKind::solid, "Element/Linear viscosity", differ(e.linear_viscosity, d.linear_viscosity));
    add(BladeKind::solid, "Element/Quadratic viscosity", differ(e.quadratic_viscosity, d.quadratic_viscosity));
    add(BladeKind::solid, "Loads/Pressure boundaries", loads.pressure_boundaries != defaults.loads.pressure_boundaries);
    add(BladeKind::solid, "Mesh/Layers", mesh.n_layers != defaults.mesh.n_layers);
    add(BladeKind::solid, "Mesh/Layer grading", differ(mesh.layer_grading, defaults.mesh.layer_grading));
    const MassScaling &m = mass_scaling, &n = defaults.mass_scaling;
    add(BladeKind::solid, "Mass scaling/Method", m.method != n.method);
    add(BladeKind::solid, "Mass scaling/Largest added inertia", differ(m.largest_added, n.largest_added));
    add(BladeKind::solid, "Mass scaling/Target step", m.target_step != n.target_step);
    return unused;
  }
} // namespace birdstrike
