#include "material/metal_table.h"
#include <birdstrike/material/equation_of_state.h>
#include <birdstrike/material/known_materials.h>
#include <birdstrike/material/metal_constants.h>

#include <deal.II/base/utilities.h>

#include <fmt/format.h>

namespace birdstrike
{
  namespace
  {
    std::string describe_liquid(const EosParameters &liquid)
    {
      switch (liquid.type)
        {
        case EosType::linear:
          return fmt::format("p = K mu, K = {:.4g} GPa", 1e-9 * liquid.bulk_modulus);
        case EosType::murnaghan:
          return fmt::format("p = B ((1 + mu)^gamma - 1), B = {:.4g} MPa, gamma = {:.4g}",
                             1e-6 * liquid.murnaghan_modulus, liquid.murnaghan_exponent);
        case EosType::polynomial:
          return fmt::format("p = C1 mu + C2 mu^2 + C3 mu^3, C = {:.4g}, {:.4g}, {:.4g} GPa", 1e-9 * liquid.c1,
                             1e-9 * liquid.c2, 1e-9 * liquid.c3);
        case EosType::us_up:
          return fmt::format("shock speed c0 + k u, c0 = {:.5g} m/s, k = {:.3g}", liquid.sound_speed,
                             liquid.shock_slope);
        case EosType::porous:
          return fmt::format("liquid with pores of air (Wilbeck 1978), porosity {:.3g}, c0 = {:.5g} m/s, k = {:.3g}",
                             liquid.porosity, liquid.sound_speed, liquid.shock_slope);
        case EosType::tabulated:
          break;
        }
      return "points of Pressure table";
    }
  } // namespace

  std::string list_metals()
  {
    std::string text = "Metals of Blade/Material/Name. An entry beside Name replaces a constant.\n";
    for (const std::string &name : dealii::Utilities::split_string_list(metal_table().selection(), '|'))
      if (Metal metal = metal_table().at(name); metal.name != Metal().name)
        {
          metal.hardening.heat_capacity = 0.; // plastic work heats it only where Adiabatic heating is set
          text += "\n" + describe(metal) + "\n  source: " + source_of(metal) + "\n";
        }
    return text +
           "\ncustom: no constants of its own; give Density, Young's modulus, Poisson's ratio and Yield stress.\n";
  }

  std::string list_liquids(const double density)
  {
    constexpr double speed = 200.; // m/s, of a strike at take-off
    std::string text = fmt::format("Liquids of Bird/Equation of state/Type at their defaults and {:g} kg/m^3, mu = "
                                   "rho/rho0 - 1.\n",
                                   density);
    for (const std::string &name : dealii::Utilities::split_string_list(eos_types().selection(), '|'))
      {
        EosParameters liquid;
        liquid.type = eos_types().at(name);
        text += "\n" + name + ": " + describe_liquid(liquid) + "\n";
        if (liquid.type == EosType::tabulated)
          continue;
        const EquationOfState eos(liquid, density);
        text += fmt::format("  speed of sound {:.4g} m/s, Hugoniot pressure at {:g} m/s {:.4g} MPa\n",
                            eos.reference_sound_speed(), speed, 1e-6 * eos.hugoniot(speed).pressure);
      }
    return text;
  }
} // namespace birdstrike
