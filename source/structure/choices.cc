#include <birdstrike/structure/choices.h>

namespace birdstrike
{
  const NamedChoices<BladeKind> &blade_kinds()
  {
    static const NamedChoices<BladeKind> choices{
      {"shell", BladeKind::shell}, {"solid", BladeKind::solid}, {"rigid", BladeKind::rigid}, {"none", BladeKind::none}};
    return choices;
  }

  const NamedChoices<ElementFormulation> &element_formulations()
  {
    static const NamedChoices<ElementFormulation> choices{{"automatic", std::monostate()},
                                                          {"physical", ShellFormulation::one_point_physical},
                                                          {"Belytschko-Tsay", ShellFormulation::belytschko_tsay},
                                                          {"fully integrated", ShellFormulation::fully_integrated},
                                                          {"one point", SolidFormulation::one_point},
                                                          {"solid-shell", SolidFormulation::solid_shell},
                                                          {"B-bar", SolidFormulation::b_bar}};
    return choices;
  }

  const NamedChoices<ThicknessRule> &thickness_rules()
  {
    static const NamedChoices<ThicknessRule> choices{{"Gauss", ThicknessRule::gauss},
                                                     {"Lobatto", ThicknessRule::lobatto}};
    return choices;
  }

  const NamedChoices<MassScalingMethod> &mass_scaling_methods()
  {
    static const NamedChoices<MassScalingMethod> choices{{"off", MassScalingMethod::off},
                                                         {"selective", MassScalingMethod::selective}};
    return choices;
  }

  const NamedChoices<LinearSolverChoice> &linear_solvers()
  {
    static const NamedChoices<LinearSolverChoice> choices{{"automatic", LinearSolverChoice::automatic},
                                                          {"direct", LinearSolverChoice::direct},
                                                          {"multigrid", LinearSolverChoice::multigrid}};
    return choices;
  }

  const NamedChoices<RigidSurface> &rigid_surfaces()
  {
    static const NamedChoices<RigidSurface> choices{{"rectangle", RigidSurface::rectangle},
                                                    {"mesh", RigidSurface::mesh}};
    return choices;
  }

  const NamedChoices<RigidMotion> &rigid_motions()
  {
    static const NamedChoices<RigidMotion> choices{{"fixed", RigidMotion::fixed},
                                                   {"free along normal", RigidMotion::free_along_normal}};
    return choices;
  }
} // namespace birdstrike
