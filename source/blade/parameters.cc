#include "mesh_parameters.h"
#include "section_choices.h"

#include <birdstrike/blade/parameters.h>
#include <birdstrike/blade/text_lists.h>
#include <birdstrike/core/errors.h>

#include <deal.II/base/parameter_handler.h>

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
        const auto numbers = parse_numbers(given, 3, entry);
        std::copy(numbers.begin(), numbers.end(), member.begin());
      });
    }

    void declare_element(dealii::ParameterHandler &prm, BladeParameters::Element &p)
    {
      prm.enter_subsection("Element");
      prm.add_parameter(
        "Formulation", p.formulation,
        "Shell with one point in its plane: with physical stabilisation and warping correction, or plain "
        "Belytschko-Tsay with perturbation hourglass control; or fully integrated (2 x 2 points, MITC4), "
        "the reference for both. [-]",
        Selection(shell_formulations().selection()));
      prm.add_parameter("Points rule", p.rule,
                        "Integration through the thickness; Lobatto has points on both faces, Gauss is exacter. [-]",
                        Selection(thickness_rules().selection()));
      prm.add_parameter("Points through thickness", p.n_points,
                        "Number of points through the thickness: 3, 5 or 7. [-]", Integer(3, 7));
      prm.add_parameter("Hourglass coefficient", p.hourglass,
                        "Perturbation hourglass stiffness (Belytschko-Tsay only), membrane, transverse and rotation "
                        "alike. [-]",
                        Double(0., 1.));
      prm.add_parameter("Shear factor", p.shear_factor, "Reissner's transverse shear factor kappa. [-]",
                        Double(1e-3, 1.));
      prm.add_parameter("Thinning", p.has_thinning, "Whether the thickness follows the plane-stress strain. [-]");
      prm.leave_subsection();
    }

    void declare_supports(dealii::ParameterHandler &prm, BladeParameters::Supports &p)
    {
      prm.enter_subsection("Supports");
      prm.add_parameter("Clamped", p.clamped, "Boundary ids whose nodes are held in all six unknowns, e.g. '0, 2'. [-]",
                        Anything());
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
      prm.leave_subsection();
    }

    void declare_loads(dealii::ParameterHandler &prm, BladeParameters::Loads &p)
    {
      prm.enter_subsection("Loads");
      prm.add_parameter("Pressure", p.pressure,
                        "Follower pressure, a formula in x, y, z, t (reference position); positive pushes along the "
                        "surface normal, +z on the built-in plate. [Pa]",
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
      prm.add_parameter("Surface", p.surface, "Rigid surface: one rectangle, or the facets of the mesh. [-]",
                        Selection("rectangle|mesh"));
      declare_vector(prm, "Centre", p.centre, "Centre of the rectangle. [m]");
      declare_vector(prm, "Normal", p.normal,
                     "Normal of the rectangle, of any length; also the direction of the free motion. [-]");
      prm.add_parameter("Length", p.length, "Length of the rectangle, along x if the normal is z. [m]", Double(tiny));
      prm.add_parameter("Width", p.width, "Width of the rectangle, along y if the normal is z. [m]", Double(tiny));
      prm.add_parameter("Half thickness", p.half_thickness, "Material on either side of the surface. [m]", Double(0.));
      prm.add_parameter("Motion", p.motion, "Whether the surface is fixed or free to move along its normal. [-]",
                        Selection("fixed|free along normal"));
      prm.add_parameter("Mass", p.mass, "Mass of the free surface. [kg]", Double(tiny));
      prm.leave_subsection();
    }

    void require(const bool condition, const std::string &message)
    {
      if (!condition)
        throw InputError("Blade/" + message);
    }
  } // namespace

  void BladeParameters::declare(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Kind", kind,
                      "What the bird meets: a shell blade, a rigid surface without finite elements, or nothing. [-]",
                      Selection("shell|rigid|none|solid"));
    prm.add_parameter("Probes", probes, "Watched nodes, the nearest to each point: 'name: x y z; ...'. [m]",
                      Anything());
    declare_mesh(prm, mesh);
    declare_thickness(prm, thickness);
    declare_element(prm, element);
    prm.enter_subsection("Material");
    material.declare(prm);
    prm.leave_subsection();
    declare_supports(prm, supports);
    declare_loads(prm, loads);
    declare_rigid(prm, rigid);
  }

  void BladeParameters::check() const
  {
    require(kind == "shell" || kind == "rigid" || kind == "none",
            "Kind: blades of solid elements are not part of this version.\nAllowed now: shell, rigid, none.");
    if (kind == "none")
      return;
    if (kind == "shell" || rigid.surface == "mesh")
      require(
        mesh.generator != "file" || !mesh.file.empty(),
        "Mesh/File: the generator is 'file' but no file is named.\nName a .msh file, or set Generator = flat plate.");
    if (kind == "rigid")
      {
        require(std::hypot(rigid.normal[0], rigid.normal[1], rigid.normal[2]) > 0.,
                "Rigid/Normal: the normal has no length.\nAllowed: any three numbers that are not all zero.");
        return;
      }
    check_mesh(*this);
    require(element.n_points == 3 || element.n_points == 5 || element.n_points == 7,
            "Element/Points through thickness: " + std::to_string(element.n_points) + " was read.\nAllowed: 3, 5, 7.");
    material.check();
  }
} // namespace birdstrike
