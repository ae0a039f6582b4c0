#include "material/hardening_laws.h"
#include "material/table_entry.h"

#include "material/metal_table.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/material/metal_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <tuple>

namespace birdstrike
{
  namespace
  {
    namespace Patterns = dealii::Patterns;
  } // namespace

  const NamedChoices<HardeningLaw> &hardening_laws()
  {
    static const NamedChoices<HardeningLaw> laws{
      {"elastic", HardeningLaw::elastic}, {"perfect", HardeningLaw::perfect},
      {"linear", HardeningLaw::linear},   {"swift", HardeningLaw::swift},
      {"voce", HardeningLaw::voce},       {"johnson-cook", HardeningLaw::johnson_cook}};
    return laws;
  }

  void MetalParameters::declare(dealii::ParameterHandler &prm)
  {
    const Patterns::Anything text;
    const std::string        table = " or 'table', the value of the named metal. ";
    prm.add_parameter("Name", name,
                      "Metal whose data are taken where an entry below says 'table'; 'custom' has no data of its own. "
                      "[-]",
                      Patterns::Selection(metal_table().selection() + (metal_table().has(name) ? "" : "|" + name)));
    prm.add_parameter("Density", density, "Density" + table + "[kg/m^3]", text);
    prm.add_parameter("Young's modulus", young, "Young's modulus" + table + "[Pa]", text);
    prm.add_parameter("Poisson's ratio", poisson, "Poisson's ratio" + table + "[-]", text);
    prm.add_parameter("Hardening", hardening,
                      "Law of the flow stress: A (perfect), A + B p (linear), A (1 + p/e0)^n (swift), "
                      "A + B (1 - exp(-n p)) (voce), A + B p^n (johnson-cook), or 'table'. [-]",
                      Patterns::Selection("table|" + hardening_laws().selection()));
    prm.add_parameter("Yield stress", yield, "Initial yield stress A" + table + "[Pa]", text);
    prm.add_parameter("Hardening modulus", modulus, "Hardening modulus B" + table + "[Pa]", text);
    prm.add_parameter("Hardening exponent", exponent, "Hardening exponent n" + table + "[-]", text);
    prm.add_parameter("Hardening strain", strain, "Reference strain e0 of Swift's law" + table + "[-]", text);
    prm.add_parameter("Rate factor", rate_factor,
                      "Factor C of Johnson and Cook's rate term 1 + C ln(rate/reference)" + table + "[-]", text);
    prm.add_parameter("Reference rate", reference_rate,
                      "Plastic strain rate below which the rate term is one" + table + "[1/s]", text);
    prm.add_parameter("Adiabatic heating", is_adiabatic,
                      "Whether plastic work heats the metal and softens it by 1 - T*^m. [-]");
    prm.add_parameter("Softening exponent", softening_exponent, "Exponent m of the thermal softening" + table + "[-]",
                      text);
    prm.add_parameter("Heat capacity", heat_capacity, "Specific heat capacity" + table + "[J/(kg K)]", text);
    prm.add_parameter("Heat fraction", taylor_quinney, "Share of the plastic work that becomes heat. [-]",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Initial temperature", initial_temperature, "Temperature at the start. [K]",
                      Patterns::Double(0.));
    prm.add_parameter("Room temperature", room_temperature, "Temperature at which the metal does not soften. [K]",
                      Patterns::Double(0.));
    prm.add_parameter("Melting temperature", melting_temperature,
                      "Temperature at which no strength is left" + table + "[K]", text);
    prm.add_parameter("Elongation", elongation,
                      "Engineering strain at break of a tensile test" + table +
                        "A run warns where the metal is strained beyond it, ln(1 + elongation) in equivalent plastic "
                        "strain; 0: unknown. It fails nothing: see Failure. [-]",
                      text);
    failure.declare(prm);
  }

  void MetalParameters::set_heating(Hardening &h, const std::string &where) const
  {
    replace(h.heat_capacity, heat_capacity, where + "Heat capacity", 10., 1e5);
    replace(h.melting_temperature, melting_temperature, where + "Melting temperature", 0., 1e5);
    if (is_adiabatic)
      for (const auto &[value, text, entry] :
           {std::tuple(h.heat_capacity, heat_capacity, "Heat capacity"),
            std::tuple(h.melting_temperature, melting_temperature, "Melting temperature")})
        if (value == 0. && text == "table")
          throw InputError(where + entry + " is not given, and the table has none for '" + name +
                           "'.\nGive a number, or set Adiabatic heating = false.");
    if (is_adiabatic && h.melting_temperature <= std::max(room_temperature, initial_temperature))
      throw InputError(where + "Melting temperature: " + std::to_string(h.melting_temperature) +
                       " K is not above room and initial temperature.");
    if (!is_adiabatic)
      h.heat_capacity = 0.;
  }

  Metal MetalParameters::metal(const std::string &where) const
  {
    if (name == "custom")
      for (const auto &[value, entry] : {std::pair(density, "Density"), std::pair(young, "Young's modulus"),
                                         std::pair(poisson, "Poisson's ratio"), std::pair(yield, "Yield stress")})
        if (value == "table" && !(entry == std::string("Yield stress") && hardening == "elastic"))
          throw InputError(
            where + entry +
            " is not given, and the metal 'custom' has no data of its own.\nGive a number, or choose Name = " +
            metal_table().selection() + ".");
    Metal result     = metal_table().at(name);
    result.name      = name;
    Hardening   &h   = result.hardening;
    const double big = 1e30;
    replace(result.density, density, where + "Density", 1e-6, big);
    replace(result.elasticity.young, young, where + "Young's modulus", 1e-6, big);
    replace(result.elasticity.poisson, poisson, where + "Poisson's ratio", -0.999, 0.4999);
    replace(h.yield, yield, where + "Yield stress", 1e-6, big);
    replace(h.modulus, modulus, where + "Hardening modulus", 0., big);
    replace(h.exponent, exponent, where + "Hardening exponent", 1e-6, big);
    replace(h.strain, strain, where + "Hardening strain", 1e-12, big);
    replace(h.rate_factor, rate_factor, where + "Rate factor", 0., 10.);
    replace(h.reference_rate, reference_rate, where + "Reference rate", 1e-12, big);
    replace(h.softening_exponent, softening_exponent, where + "Softening exponent", 1e-6, 100.);
    replace(result.elongation, elongation, where + "Elongation", 0., 10.);
    if (hardening != "table")
      h.law = hardening_laws().at(hardening);
    h.density             = result.density;
    h.taylor_quinney      = taylor_quinney;
    h.initial_temperature = initial_temperature;
    h.room_temperature    = room_temperature;
    set_heating(h, where);
    const bool has_modulus =
      h.law == HardeningLaw::linear || h.law == HardeningLaw::voce || h.law == HardeningLaw::johnson_cook;
    if (has_modulus && modulus == "table" && h.modulus == 0.)
      throw InputError(where + "Hardening modulus is not given, and the table has none for '" + name +
                       "'.\nGive a number, or set Hardening = perfect.");
    if (h.law == HardeningLaw::swift && h.exponent > 1.)
      throw InputError(where + "Hardening exponent: " + std::to_string(h.exponent) +
                       " was read; Swift's law needs one from 0 to 1.");
    result.failure = failure.failure(result.failure, name, where);
    if (result.failure.can_fail() && h.law == HardeningLaw::elastic)
      throw InputError(where + "Failure: a metal that never yields never fails.\n"
                               "Set Hardening to another law than elastic, or Failure = none.");
    return result;
  }
} // namespace birdstrike
