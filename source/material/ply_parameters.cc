#include <birdstrike/core/errors.h>
#include <birdstrike/material/ply_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <fmt/format.h>

namespace birdstrike
{
  namespace
  {
    struct Constant
    {
      const char *entry, *key, *unit, *text;
      double Ply::*value;
    };
    struct Strength
    {
      const char *entry, *key, *text;
      double PlyStrength::*value;
    };

    constexpr Constant constants[] = {
      {"Density", "density", "kg/m^3", "Density of the ply", &Ply::density},
      {"Young's modulus 1", "youngs_modulus_1", "Pa", "Young's modulus E1 along the fibres", &Ply::young_1},
      {"Young's modulus 2", "youngs_modulus_2", "Pa", "Young's modulus E2 across the fibres", &Ply::young_2},
      {"Poisson's ratio 12", "poissons_ratio_12", "-",
       "Poisson's ratio nu12: contraction across the fibres over extension along them", &Ply::poisson_12},
      {"Shear modulus 12", "shear_modulus_12", "Pa", "Shear modulus G12 in the plane", &Ply::shear_12},
      {"Shear modulus 13", "shear_modulus_13", "Pa", "Transverse shear modulus G13 along the fibres", &Ply::shear_13},
      {"Shear modulus 23", "shear_modulus_23", "Pa", "Transverse shear modulus G23 across the fibres", &Ply::shear_23}};

    constexpr Strength strengths[] = {
      {"Longitudinal tension", "longitudinal_tension", "Strength Xt along the fibres in tension",
       &PlyStrength::longitudinal_tension},
      {"Longitudinal compression", "longitudinal_compression", "Strength Xc along the fibres in compression",
       &PlyStrength::longitudinal_compression},
      {"Transverse tension", "transverse_tension", "Strength Yt across the fibres in tension",
       &PlyStrength::transverse_tension},
      {"Transverse compression", "transverse_compression", "Strength Yc across the fibres in compression",
       &PlyStrength::transverse_compression},
      {"Shear strength", "shear_strength", "Strength Sc in shear in the plane", &PlyStrength::shear}};
  } // namespace

  void declare_ply(dealii::ParameterHandler &prm, Ply &ply)
  {
    namespace Patterns = dealii::Patterns;
    for (const Constant &each : constants)
      prm.add_parameter(each.entry, ply.*each.value, fmt::format("{}. 0: not set. [{}]", each.text, each.unit),
                        Patterns::Double(0., 1e30));
    for (const Strength &each : strengths)
      prm.add_parameter(each.entry, ply.strength.*each.value,
                        fmt::format("{}. A ply fails where all five strengths are set. [Pa]", each.text),
                        Patterns::Double(0., 1e30));
    prm.add_parameter("Shear weight", ply.strength.shear_weight,
                      "Weight of the shear stress in the failure of fibres in tension. 0: only the stress along the "
                      "fibres counts. 1: Hashin's criterion. [-]",
                      Patterns::Double(0., 1.));
  }

  Ply with_others(const Ply &given, const Ply &others)
  {
    Ply result = given;
    for (const Constant &each : constants)
      if (result.*each.value == 0.)
        result.*each.value = others.*each.value;
    for (const Strength &each : strengths)
      if (result.strength.*each.value == 0.)
        result.strength.*each.value = others.strength.*each.value;
    if (result.strength.shear_weight == 0.)
      result.strength.shear_weight = others.strength.shear_weight;
    return result;
  }

  void check_ply(const Ply &ply, const std::string &where)
  {
    for (const Constant &each : constants)
      if (each.value != &Ply::poisson_12 && !(ply.*each.value > 0.))
        throw InputError(where + each.entry + " is not given: there is no table of plies.\nGive a number above 0.");
    if (!(ply.poisson_12 * ply.poisson_12 * ply.young_2 < ply.young_1))
      throw InputError(fmt::format(
        "{}Poisson's ratio 12: {:g} was read, and {:g} and {:g} Pa as Young's moduli 1 and 2: such a ply "
        "would store negative energy.\n"
        "Allowed: below the root of E1/E2, {:.4g} here. Is it nu21, are E1 and E2 exchanged, or of two units?",
        where, ply.poisson_12, ply.young_1, ply.young_2, std::sqrt(ply.young_1 / ply.young_2)));
    const Strength *missing = nullptr;
    bool            has_any = false;
    for (const Strength &each : strengths)
      if (ply.strength.*each.value > 0.)
        has_any = true;
      else
        missing = &each;
    if (has_any && missing != nullptr)
      throw InputError(where + missing->entry +
                       " is not given, but other strengths are: Chang and Chang's criteria need all five.\nGive a "
                       "number above 0, or leave them all out: the plies then never fail.");
    if (!has_any && ply.strength.shear_weight > 0.)
      throw InputError(where + "Shear weight is given, but no strength: the plies never fail.\nLeave it out.");
  }

  std::vector<MetalConstant> constants_in_use(const Ply &ply)
  {
    std::vector<MetalConstant> all;
    for (const Constant &each : constants)
      all.push_back({each.key, each.unit, ply.*each.value});
    if (ply.strength.can_fail())
      {
        for (const Strength &each : strengths)
          all.push_back({each.key, "Pa", ply.strength.*each.value});
        all.push_back({"shear_weight", "-", ply.strength.shear_weight});
      }
    return all;
  }

  std::string describe(const Ply &ply)
  {
    const PlyStrength &s = ply.strength;
    const std::string  text =
      fmt::format("{:.5g} kg/m^3, E1 {:.5g} GPa, E2 {:.5g} GPa, nu12 {:.4g}, G12, G13, G23 {:.4g}, {:.4g}, {:.4g} GPa",
                  ply.density, 1e-9 * ply.young_1, 1e-9 * ply.young_2, ply.poisson_12, 1e-9 * ply.shear_12,
                  1e-9 * ply.shear_13, 1e-9 * ply.shear_23);
    if (!s.can_fail())
      return text + ", never fails";
    return text + fmt::format(", fails by Chang and Chang's criteria (Xt {:.4g}, Xc {:.4g}, Yt {:.4g}, Yc {:.4g}, "
                              "Sc {:.4g} MPa)",
                              1e-6 * s.longitudinal_tension, 1e-6 * s.longitudinal_compression,
                              1e-6 * s.transverse_tension, 1e-6 * s.transverse_compression, 1e-6 * s.shear);
  }
} // namespace birdstrike
