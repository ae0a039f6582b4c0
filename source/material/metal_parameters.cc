#include "material/hardening_laws.h"
#include "material/table_entry.h"

#include "material/metal_table.h"
#include <birdstrike/core/declare_choice.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text/number_text.h>
#include <birdstrike/core/text_lists.h>
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
      {"voce", HardeningLaw::voce},       {"johnson-cook", HardeningLaw::johnson_cook},
      {"curve", HardeningLaw::curve}};
    return laws;
  }

  const NamedChoices<RateLaw> &rate_laws()
  {
    static const NamedChoices<RateLaw> laws{{"johnson-cook", RateLaw::johnson_cook},
                                            {"cowper-symonds", RateLaw::cowper_symonds}};
    return laws;
  }

  void MetalParameters::declare(dealii::ParameterHandler &prm)
  {
    const Patterns::Anything text;
    const std::string        table = ": a number, or 'table' for the value of the named metal. ";
    prm.add_parameter(
      "Name", name,
      "Name of the metal. Its data are taken where an entry below says 'table'. 'custom' has no data of its own. [-]",
      Patterns::Selection(metal_table().selection() + (metal_table().has(name) ? "" : "|" + name)));
    prm.add_parameter("Density", density, "Density" + table + "[kg/m^3]", text);
    prm.add_parameter("Young's modulus", young, "Young's modulus" + table + "[Pa]", text);
    prm.add_parameter("Poisson's ratio", poisson, "Poisson's ratio" + table + "[-]", text);
    prm.add_parameter("Hardening", hardening,
                      "Law of the flow stress over the plastic strain p. elastic: no yielding. perfect: A. linear: A + "
                      "B p. swift: A (1 + p/e0)^n. voce: A + B (1 - exp(-n p)). johnson-cook: A + B p^n. curve: points "
                      "of a test. table: the law of the named metal. [-]",
                      Patterns::Selection("table|" + hardening_laws().selection()));
    prm.add_parameter("Yield stress", yield, "Initial yield stress A" + table + "[Pa]", text);
    prm.add_parameter("Hardening modulus", modulus, "Hardening modulus B" + table + "[Pa]", text);
    prm.add_parameter("Hardening exponent", exponent, "Hardening exponent n" + table + "[-]", text);
    prm.add_parameter("Hardening strain", strain, "Reference strain e0 of Swift's law" + table + "[-]", text);
    prm.add_parameter(
      "Hardening curve", curve,
      "Flow stress at plastic strains: 'plastic strain: stress; ...', e.g. '0: 880e6; 0.02: 915e6; 0.1: 970e6'. Up to "
      "16 points are joined by straight lines. The strains increase from 0 on. Beyond the last point the stress is "
      "constant. Stresses are true stresses, strains are logarithmic. The first stress is the yield stress. [Pa]",
      text);
    declare_choice(
      prm, "Rate law", rate_law, rate_laws(),
      "Law of the flow stress over the plastic strain rate r. johnson-cook: factor 1 + C ln(r/reference) above the "
      "reference rate. cowper-symonds: factor 1 + (r/D)^(1/P) with the reference rate D and the rate exponent P. [-]");
    prm.add_parameter("Rate exponent", rate_exponent, "Exponent P of the Cowper-Symonds law. [-]",
                      Patterns::Double(0.1, 100.));
    prm.add_parameter("Rate factor", rate_factor,
                      "Factor C of the Johnson-Cook rate term 1 + C ln(rate/reference)" + table + "[-]", text);
    prm.add_parameter("Reference rate", reference_rate,
                      "Reference plastic strain rate of the rate law" + table +
                        "johnson-cook: below it the rate terms of strength and of Failure = Johnson-Cook are one. "
                        "cowper-symonds: D, of strength alone. [1/s]",
                      text);
    prm.add_parameter("Adiabatic heating", is_adiabatic,
                      "Heating of the metal by plastic work, and its softening by 1 - T*^m. [-]");
    prm.add_parameter("Softening exponent", softening_exponent, "Exponent m of the thermal softening" + table + "[-]",
                      text);
    prm.add_parameter("Heat capacity", heat_capacity, "Specific heat capacity" + table + "[J/(kg K)]", text);
    prm.add_parameter("Heat fraction", taylor_quinney,
                      "Share of the plastic work that becomes heat (Taylor-Quinney coefficient). [-]",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Initial temperature", initial_temperature, "Temperature of the metal at the start. [K]",
                      Patterns::Double(0.));
    prm.add_parameter("Room temperature", room_temperature, "Room temperature, at which the metal does not soften. [K]",
                      Patterns::Double(0.));
    prm.add_parameter("Melting temperature", melting_temperature,
                      "Temperature at which the metal has no strength left" + table + "[K]", text);
    prm.add_parameter("Elongation", elongation,
                      "Engineering strain at break in a tensile test" + table +
                        "The run warns where the equivalent plastic strain exceeds ln(1 + elongation). The entry makes "
                        "nothing fail: see Failure. 0: unknown. Johnson-Cook damage constants, if present, then set "
                        "the limit, the failure strain in tension D1 + D2 exp(D3/3). [-]",
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
      throw InputError(where + "Melting temperature: " + number_text(h.melting_temperature) +
                       " K is not above room and initial temperature.");
    if (!is_adiabatic)
      h.heat_capacity = 0.;
  }

  void MetalParameters::set_curve(Hardening &h, const double young, const std::string &where) const
  {
    const std::string here = where + "Hardening curve";
    if (h.law != HardeningLaw::curve)
      {
        if (!curve.empty())
          throw InputError(here + " is given, and Hardening is " + hardening_laws().name(h.law) +
                           ".\nSet Hardening = curve, or leave it empty.");
        return;
      }
    if (!curve.empty() && curve.find(':') == std::string::npos)
      throw InputError(here + ": '" + curve +
                       "' has no points. A file is not read here.\nGive the points themselves: '0: 880e6; 0.02: 915e6; "
                       "0.1: 970e6' (plastic strain: true stress in Pa).");
    std::vector<std::array<double, 2>> points;
    for (const auto &[strain_text, stress_text] : parse_pairs(curve, here))
      points.push_back({parse_numbers(strain_text, 1, here)[0], parse_numbers(stress_text, 1, here)[0]});
    if (points.size() < 2 || points.size() > HardeningCurve::most_points || points[0][0] != 0. || !(points[0][1] > 0.))
      throw InputError(
        here + ": " + std::to_string(points.size()) +
        " points were read.\nAllowed: 2 to 16 points 'plastic strain: stress', the first at strain 0 with "
        "a stress above 0: '0: 880e6; 0.1: 970e6'.");
    if (yield != "table" && h.yield != points[0][1]) // the same: as written files have it
      throw InputError(where +
                       "Yield stress: with Hardening = curve it is the first stress of the curve.\nLeave it out.");
    h.yield            = points[0][1];
    h.curve.n_segments = points.size() - 1;
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      {
        const double length = points[k + 1][0] - points[k][0], slope = (points[k + 1][1] - points[k][1]) / length;
        if (!(length > 0.) || !(slope >= 0.) || !(slope < young))
          throw InputError(fmt::format("{}: from point {} to {} {}.\nRead: {:g}: {:g} Pa; {:g}: {:g} Pa.", here, k + 1,
                                       k + 2,
                                       !(length > 0.)   ? "the strain does not grow"
                                       : !(slope >= 0.) ? "the stress falls"
                                                        : fmt::format("the slope, {:.4g} Pa, is no less than Young's "
                                                                      "modulus, {:.4g} Pa",
                                                                      slope, young),
                                       points[k][0], points[k][1], points[k + 1][0], points[k + 1][1]));
        h.curve.segments[k] = {points[k][0], length, slope};
      }
  }

  void MetalParameters::set_rate(Hardening &h, const std::string &where) const
  {
    replace(h.rate_factor, rate_factor, where + "Rate factor", 0., 10.);
    replace(h.reference_rate, reference_rate, where + "Reference rate", 1e-12, 1e30);
    h.rate_law      = rate_law;
    h.rate_exponent = rate_exponent;
    if (rate_law != RateLaw::cowper_symonds)
      return;
    h.rate_factor = 1.;
    if (reference_rate == "table")
      throw InputError(where + "Reference rate is not given: Cowper and Symonds need their D.\nGive a number, 40.4 1/s "
                               "for mild steel, or set Rate law = johnson-cook.");
    if (rate_factor != "table")
      throw InputError(where + "Rate factor is Johnson and Cook's; Rate law is cowper-symonds.\nLeave it out.");
  }

  Metal MetalParameters::metal(const std::string &where) const
  {
    if (name == "custom")
      for (const auto &[value, entry] : {std::pair(density, "Density"), std::pair(young, "Young's modulus"),
                                         std::pair(poisson, "Poisson's ratio"), std::pair(yield, "Yield stress")})
        if (value == "table" &&
            !(entry == std::string("Yield stress") && (hardening == "elastic" || hardening == "curve")))
          throw InputError(
            where + entry +
            " is not given, and the metal 'custom' has no data of its own.\nGive a number, or choose Name = " +
            metal_table().selection() + ".");
    Metal result     = metal_table().at(name);
    result.name      = name;
    Hardening   &h   = result.hardening;
    const double big = 1e30;
    if (Patterns::Double(1e-10, 1e-7).match(density)) // no matter is that light
      throw InputError(where + "Density: " + density + " kg/m^3 was read.\nWas it meant in t/mm^3? Give '" + density +
                       " t/mm^3'; a number without a unit is in kg/m^3.");
    replace(result.density, density, where + "Density", 1e-6, big);
    replace(result.elasticity.young, young, where + "Young's modulus", 1e-6, big);
    replace(result.elasticity.poisson, poisson, where + "Poisson's ratio", -0.999, 0.4999);
    replace(h.yield, yield, where + "Yield stress", 1e-6, big);
    replace(h.modulus, modulus, where + "Hardening modulus", 0., big);
    replace(h.exponent, exponent, where + "Hardening exponent", 1e-6, big);
    replace(h.strain, strain, where + "Hardening strain", 1e-12, big);
    set_rate(h, where);
    replace(h.softening_exponent, softening_exponent, where + "Softening exponent", 1e-6, 100.);
    replace(result.elongation, elongation, where + "Elongation", 0., 10.);
    if (hardening != "table")
      h.law = hardening_laws().at(hardening);
    set_curve(h, result.elasticity.young, where);
    h.density             = result.density;
    h.taylor_quinney      = taylor_quinney;
    h.initial_temperature = initial_temperature;
    h.room_temperature    = room_temperature;
    set_heating(h, where);
    const bool has_modulus =
      h.law == HardeningLaw::linear || h.law == HardeningLaw::voce || h.law == HardeningLaw::johnson_cook;
    // a table of another law has none of these: its B, or the usual exponent of 1, would be another metal
    const bool is_of_table   = metal_table().at(name).hardening.law == h.law;
    const auto require_given = [&](const std::string &value, const std::string &entry, const std::string &what) {
      if (value == "table" && !is_of_table)
        throw InputError(where + entry + " is not given, and the table has none of this law for '" + name +
                         "'.\nGive " + what + ", or set Hardening = perfect.");
    };
    if (has_modulus && is_of_table && modulus == "table" && h.modulus == 0.)
      throw InputError(where + "Hardening modulus is not given, and the table has none for '" + name +
                       "'.\nGive a number, or set Hardening = perfect.");
    if (h.law == HardeningLaw::linear)
      require_given(modulus, "Hardening modulus", "B of A + B p");
    if (h.law == HardeningLaw::johnson_cook)
      {
        require_given(modulus, "Hardening modulus", "B of A + B p^n");
        require_given(exponent, "Hardening exponent", "n of A + B p^n");
      }
    if (h.law == HardeningLaw::swift)
      {
        require_given(exponent, "Hardening exponent", "n of A (1 + p/e0)^n");
        require_given(strain, "Hardening strain", "e0 of A (1 + p/e0)^n");
      }
    if (h.law == HardeningLaw::voce)
      {
        require_given(modulus, "Hardening modulus", "B of A + B (1 - exp(-n p))");
        require_given(exponent, "Hardening exponent", "n of A + B (1 - exp(-n p))");
      }
    if (h.law == HardeningLaw::swift && h.exponent > 1.)
      throw InputError(where + "Hardening exponent: " + number_text(h.exponent) +
                       " was read; Swift's law needs one from 0 to 1.");
    result.failure = failure.failure(result.failure, name, where);
    if (result.failure.can_fail() && h.law == HardeningLaw::elastic)
      throw InputError(where + "Failure: a metal that never yields never fails.\n"
                               "Set Hardening to another law than elastic, or Failure = none.");
    return result;
  }
} // namespace birdstrike
