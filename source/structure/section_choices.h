#pragma once

#include "structure/elements/shell/elements.h"
#include "structure/elements/solid/elements.h"
#include <birdstrike/core/named_choices.h>

namespace birdstrike
{
  inline const NamedChoices<ShellFormulation> &shell_formulations()
  {
    static const NamedChoices<ShellFormulation> choices{{"physical", ShellFormulation::one_point_physical},
                                                        {"Belytschko-Tsay", ShellFormulation::belytschko_tsay},
                                                        {"fully integrated", ShellFormulation::fully_integrated}};
    return choices;
  }

  inline const NamedChoices<SolidFormulation> &solid_formulations()
  {
    static const NamedChoices<SolidFormulation> choices{{"one point", SolidFormulation::one_point},
                                                        {"solid-shell", SolidFormulation::solid_shell},
                                                        {"B-bar", SolidFormulation::b_bar}};
    return choices;
  }

  inline const NamedChoices<ThicknessRule> &thickness_rules()
  {
    static const NamedChoices<ThicknessRule> choices{{"Gauss", ThicknessRule::gauss},
                                                     {"Lobatto", ThicknessRule::lobatto}};
    return choices;
  }
} // namespace birdstrike
