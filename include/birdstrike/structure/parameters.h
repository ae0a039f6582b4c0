#pragma once

#include <birdstrike/material/metal_parameters.h>
#include <birdstrike/mesh/parameters.h>
#include <birdstrike/structure/choices.h>
#include <birdstrike/structure/laminate_parameters.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  /// Section "Blade" of the parameter file: what the blade is, how it is held and loaded, and what is watched on it.
  ///
  /// Coordinates of the built-in flat plate: x = span from the root (x = 0), y = chord, centred, z = normal. Its
  /// boundary ids: 0 root, 1 tip, 2 leading edge (y = -chord/2), 3 trailing edge; as a solid also 5 and 6, the faces on
  /// the side of minus and plus the normal. The built-in blade has the same ids; see BladeShape. Lists and expressions
  /// are kept as text here; their syntax is checked where they are used, always before the first step.
  struct BladeParameters : GeometryParameters
  {
    using Mesh      = MeshParameters;
    using Thickness = ThicknessParameters;

    struct Element
    {
      ElementFormulation formulation; ///< automatic, see below; or one of the blade's kind
      ThicknessRule      rule             = ThicknessRule::gauss;
      unsigned int       n_points         = 7;
      double             hourglass        = 0.05; ///< perturbation control only
      double             shear_factor     = 5. / 6.;
      bool               has_thinning     = true;
      double             linear_viscosity = 0.06, quadratic_viscosity = 1.2; ///< bulk viscosity of solids
    };

    /// Of the cells with some material ids, instead of the blade's own; what is not given is the blade's.
    struct Section
    {
      static constexpr const char *same = "as the blade"; ///< name of a metal

      std::string        material_ids; ///< or names; none: the section is not used
      ElementFormulation formulation;  ///< automatic: the blade's
      unsigned int       n_points = 0; ///< through the thickness; 0: the blade's
      std::string        thickness;    ///< m, of shells, number or expression in x, y, z; empty: the blade's
      MetalParameters    material{same};
      LaminateParameters laminate; ///< with plies: instead of a metal

      bool operator==(const Section &) const = default;
    };
    static constexpr std::size_t n_sections = 3; ///< besides the blade's own

    struct MassScaling
    {
      MassScalingMethod method        = MassScalingMethod::off;
      double            largest_added = 0.01; ///< of the blade's smallest moment of inertia
      double            target_step   = 0.;   ///< s; 0: automatic
    };

    struct Supports
    {
      static constexpr const char *automatic = "automatic";

      std::string clamped = automatic; ///< boundary ids or names, as in all that follow; or see declare
      std::string hub;                 ///< clamped, and the section where root forces are reported
      std::string free;                ///< must exist and hold nothing
      std::string tip = "1";           ///< the tip row
      std::string held;                ///< "3: ux uy; 2: uz"
      std::string held_boxes;          ///< "xmin ymin zmin xmax ymax zmax: ux uy"
      std::string driven;              ///< "3: uz = 1e-3*sin(2*pi*100*t)", m and rad, expressions in t
    };

    struct Loads
    {
      std::string pressure;                  ///< Pa, expression in x, y, z, t
      std::string pressure_boundaries = "5"; ///< boundary ids of a solid that it acts on
      std::string point_loads;               ///< "x y z: fx; fy; fz | ..." , N, expressions in t
      double      damping = 0.;              ///< 1/s
      std::string initial_velocity;          ///< m/s, "vx; vy; vz" in x, y, z
      std::string initial_spin;              ///< rad/s, "wx; wy; wz": rigid rotation about the origin
    };

    struct Spin
    {
      std::string           speed = "0"; ///< rad/s, a number or a formula of t; 0: the hub stands still
      std::array<double, 3> axis{{0., 0., 1.}};
      std::array<double, 3> centre{{0., 0., 0.}}; ///< m, a point on the axis
      bool                  has_prestress = true;
      unsigned int          n_load_steps  = 4;
      LinearSolverChoice    linear_solver = LinearSolverChoice::automatic;
    };

    struct Rigid
    {
      RigidSurface          surface = RigidSurface::rectangle;
      std::array<double, 3> centre{{0., 0., 0.}};
      std::array<double, 3> normal{{0., 0., 1.}};
      double                length         = 0.4; ///< m, along the first in-plane direction
      double                width          = 0.4; ///< m
      double                half_thickness = 0.;  ///< m
      RigidMotion           motion         = RigidMotion::fixed;
      double                mass           = 1.; ///< kg
    };

    BladeKind                       kind = BladeKind::shell;
    Element                         element;
    MetalParameters                 material;
    LaminateParameters              laminate = LaminateParameters::of_blade(); ///< with plies: instead of the metal
    std::array<Section, n_sections> sections;
    MassScaling                     mass_scaling;
    Supports                        supports;
    Loads                           loads;
    Spin                            spin;
    Rigid                           rigid;
    std::string                     probes; ///< "name: x y z; ..."
    /// The bird that strikes gives reports their signs (orientation.h). Set by the case; none without a bird.
    struct StrikingBird
    {
      std::array<double, 3> target{}, velocity{}; ///< where it aims, m; m/s
    };
    std::optional<StrikingBird> bird;

    bool is_deformable() const; ///< of finite elements

    /// Automatic is physical.
    ShellFormulation shell_formulation() const;
    /// Automatic is a solid-shell where n_layers, bricks from skin to skin, is 1 and the metal does not fail, else one
    /// point. Throws InputError for an impossible metal.
    SolidFormulation solid_formulation(unsigned int n_layers) const;

    /// By section: 0 is the blade's own, k section k where it has material ids, its entries in the blade's places.
    std::map<std::size_t, BladeParameters> by_section() const;
    /// Of a section's entries: "", or "Section 1/".
    static std::string section_path(std::size_t section);
    bool               can_fail() const; ///< the material of some section

    /// Of the section whose entries stand in the blade's places, whatever its material.
    bool   is_laminate() const;
    bool   material_can_fail() const;
    double density() const; ///< kg/m^3

    /// Declares every entry in the handler's present section; the members' values are the defaults.
    void declare(dealii::ParameterHandler &prm);

    /// Rules between entries. Throws InputError.
    void check() const;

    /// Entries that were changed from their defaults and mean nothing for this kind of blade ("Element/Thinning"): one
    /// file may hold those of shell and solid.
    std::vector<std::string> unused_entries() const;

  private:
    void check_elements(std::size_t section) const;
    void check_laminate(std::size_t section) const;
    void check_spin() const;
    bool may_be_solid_shell() const; ///< some element of the section, whatever layers a mesh file has
    bool has_points_through_thickness() const;
  };
} // namespace birdstrike
