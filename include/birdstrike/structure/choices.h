#pragma once

#include <birdstrike/core/named_choices.h>

#include <variant>

/// The choices of section "Blade" of the parameter file, and how they are spelt there.
namespace birdstrike
{
  enum class BladeKind
  {
    shell,
    solid,
    rigid, ///< a surface without finite elements
    none
  };

  enum class ShellFormulation
  {
    one_point_physical, ///< covariant one-point quadrilateral with physical stabilisation (default)
    belytschko_tsay,    ///< Belytschko, Lin & Tsay (1984) with perturbation hourglass control
    fully_integrated    ///< 2 x 2 points, MITC4 shear, assumed membrane strain: the reference
  };

  enum class SolidFormulation
  {
    one_point,  ///< mean gradient and assumed-strain (physical) stabilisation; bends right with one layer (default)
    b_bar,      ///< 2 x 2 x 2 points with mean dilatation: the reference, which locks in the bending of thin bricks
    solid_shell ///< the one-point brick with points through its thickness once it yields: one layer yields as a shell
  };

  /// std::monostate: automatic.
  using ElementFormulation = std::variant<std::monostate, ShellFormulation, SolidFormulation>;

  /// Integration through the thickness.
  enum class ThicknessRule
  {
    gauss,
    lobatto
  };

  enum class MassScalingMethod
  {
    off,
    selective ///< of solids
  };

  /// Of equations of static equilibrium and modes.
  enum class LinearSolverChoice
  {
    automatic, ///< by the number of unknowns
    direct,
    multigrid
  };

  enum class RigidSurface
  {
    rectangle,
    mesh
  };

  enum class RigidMotion
  {
    fixed,
    free_along_normal
  };

  const NamedChoices<BladeKind>          &blade_kinds();
  const NamedChoices<ElementFormulation> &element_formulations();
  const NamedChoices<ThicknessRule>      &thickness_rules();
  const NamedChoices<MassScalingMethod>  &mass_scaling_methods();
  const NamedChoices<LinearSolverChoice> &linear_solvers();
  const NamedChoices<RigidSurface>       &rigid_surfaces();
  const NamedChoices<RigidMotion>        &rigid_motions();
} // namespace birdstrike
