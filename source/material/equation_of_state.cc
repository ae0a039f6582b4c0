#include "material/porous_liquid.h"
#include "material/tabulated_liquid.h"
#include <birdstrike/core/declare_choice.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text/number_text.h>
#include <birdstrike/material/equation_of_state.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace birdstrike
{
  namespace
  {
    constexpr double air_over_pressure = 1. / (287.05 * 288.15); ///< kg/m^3/Pa, dry air at 15 degrees C

    double find_liquid_density(const EosParameters &parameters, const double reference_density)
    {
      const double z      = parameters.porosity;
      const double liquid = (reference_density - z * parameters.ambient_pressure * air_over_pressure) / (1. - z);
      if (parameters.liquid_density > 0. && std::abs(parameters.liquid_density / liquid - 1.) > 0.01)
        throw InputError(
          fmt::format("Section 'Equation of state', entry 'Liquid density': {:g} kg/m^3 with a porosity of {:g} makes "
                      "a bird of {:.5g} kg/m^3, and Bird/Density is {:g}.\nSet Bird/Density = {:.5g}, or Liquid "
                      "density = {:.5g}, or leave Liquid density out: it then follows from the other two.",
                      parameters.liquid_density, z, reference_density + (1. - z) * (parameters.liquid_density - liquid),
                      reference_density, reference_density + (1. - z) * (parameters.liquid_density - liquid), liquid));
      return liquid;
    }

    PressureTable make_porous(const EosParameters &parameters, const double liquid_density)
    {
      const double exponent = 4. * parameters.shock_slope - 1.;
      const double modulus  = liquid_density * parameters.sound_speed * parameters.sound_speed / exponent;
      return PorousLiquid{parameters.porosity, modulus, exponent, parameters.ambient_pressure}.tabulate();
    }
  } // namespace

  const NamedChoices<EosType> &eos_types()
  {
    static const NamedChoices<EosType> choices{{"linear", EosType::linear},         {"murnaghan", EosType::murnaghan},
                                               {"polynomial", EosType::polynomial}, {"us-up", EosType::us_up},
                                               {"porous", EosType::porous},         {"tabulated", EosType::tabulated}};
    return choices;
  }

  void EosParameters::declare(dealii::ParameterHandler &prm)
  {
    using namespace dealii;
    const Patterns::Double positive(1e-300);
    prm.enter_subsection("Equation of state");
    declare_choice(prm, "Type", type, eos_types(),
                   "Equation of state of the bird. linear: p = K(1/V - 1). murnaghan: p = B((rho/rho0)^gamma - 1). "
                   "polynomial: in mu = rho/rho0 - 1. us-up: shock speed linear in particle speed. porous: Wilbeck's "
                   "liquid with pores of air. tabulated: points of a table. [-]");
    prm.add_parameter("Bulk modulus", bulk_modulus, "Modulus K of the linear law. [Pa]", positive);
    prm.add_parameter("Murnaghan modulus", murnaghan_modulus, "Modulus B of the Murnaghan law. [Pa]", positive);
    prm.add_parameter("Murnaghan exponent", murnaghan_exponent, "Exponent gamma of the Murnaghan law. [-]",
                      Patterns::Double(1.));
    prm.add_parameter("Polynomial C1", c1, "Coefficient of mu in the polynomial law. [Pa]", positive);
    prm.add_parameter("Polynomial C2", c2, "Coefficient of mu squared in the polynomial law. [Pa]",
                      Patterns::Double(0.));
    prm.add_parameter("Polynomial C3", c3, "Coefficient of mu cubed in the polynomial law. [Pa]", Patterns::Double(0.));
    prm.add_parameter("Sound speed", sound_speed,
                      "Speed c0 in Us = c0 + k u of the us-up law, or of the liquid between the pores. [m/s]",
                      positive);
    prm.add_parameter("Shock slope", shock_slope,
                      "Slope k in Us = c0 + k u of the us-up law, or of the liquid between the pores. [-]",
                      Patterns::Double(0.));
    prm.add_parameter("Porosity", porosity,
                      "Volume share z of the pores in an undeformed porous liquid. The law is rho0/rho = (1 - z) (1 + "
                      "p/A)^(-1/B) + z (1 + p/p0)^(-1/1.4), with B = 4 k - 1 and A = rho_l c0^2/B. [-]",
                      Patterns::Double(0., 0.5));
    prm.add_parameter("Liquid density", liquid_density,
                      "Density rho_l of the liquid between the pores. It must agree with Bird/Density. 0: it follows "
                      "from Bird/Density. [kg/m^3]",
                      Patterns::Double(0.));
    prm.add_parameter("Ambient pressure", ambient_pressure, "Pressure p0 of the air in the pores at rest. [Pa]",
                      Patterns::Double(1.));
    prm.add_parameter(
      "Pressure table", pressure_table,
      "Points 'mu: pressure' of the tabulated law, e.g. '0: 0; 0.05: 130 MPa; 0.1: 320 MPa'. mu is rho/rho0 - 1, which "
      "is exp(-e) - 1 of a logarithmic volume strain e. Monotone cubics join the points. The table must reach the "
      "Hugoniot pressure of the strike. Beyond its last point it continues with its slope. [Pa]",
      Patterns::Anything());
    prm.leave_subsection();
  }

  void EosParameters::check() const
  {
    if (type != EosType::tabulated && !pressure_table.empty())
      throw InputError("Section 'Equation of state', entry 'Pressure table' is given, and Type is " +
                       eos_types().name(type) + ".\nSet Type = tabulated, or leave it empty.");
    if ((type == EosType::us_up || type == EosType::porous) && shock_slope < 0.5)
      throw InputError("Section 'Equation of state', entry 'Shock slope': " + number_text(shock_slope) +
                       " is too small.\nBelow 0.5 the liquid softens under compression and carries no shock."
                       "\nGive a slope of at least 0.5 (water and birds: 2).");
  }

  EquationOfState::EquationOfState(const EosParameters &parameters, const double reference_density)
    : type(parameters.type), rho0(reference_density)
  {
    switch (type)
      {
      case EosType::linear:
        a1 = parameters.bulk_modulus;
        break;
      case EosType::murnaghan:
        a1 = parameters.murnaghan_modulus;
        a2 = parameters.murnaghan_exponent;
        break;
      case EosType::polynomial:
        a1 = parameters.c1;
        a2 = parameters.c2;
        a3 = parameters.c3;
        break;
      case EosType::us_up:
        a1 = rho0 * parameters.sound_speed * parameters.sound_speed;
        a2 = parameters.shock_slope;
        break;
      case EosType::porous:
        a1    = find_liquid_density(parameters, rho0);
        a2    = parameters.porosity;
        table = std::make_shared<const PressureTable>(make_porous(parameters, a1));
        break;
      case EosType::tabulated:
        table = std::make_shared<const PressureTable>(read_pressure_table(parameters.pressure_table));
        break;
      }
  }

  double EquationOfState::table_pressure(const double mu) const
  {
    return table->pressure(mu);
  }

  Lanes EquationOfState::table_pressure(const Lanes mu) const
  {
    return table->pressure(mu);
  }

  double EquationOfState::table_slope(const double mu) const
  {
    return table->slope(mu);
  }

  Lanes EquationOfState::table_slope(const Lanes mu) const
  {
    return table->slope(mu);
  }

  double EquationOfState::energy(const double mu) const
  {
    const double eta = mu / (1. + mu), log = std::log1p(mu), first = log - eta;
    const double linear = a1 * first / rho0;
    switch (type)
      {
      case EosType::linear:
        return linear;
      case EosType::murnaghan:
        return a1 / rho0 * ((a2 == 1. ? log : compute_power_less_one(mu, a2 - 1.) / (a2 - 1.)) - eta);
      case EosType::polynomial:
        {
          const double second = mu - log - first, third = 0.5 * mu * mu - 2. * second - first;
          return mu > 0. ? (a1 * first + a2 * second + a3 * third) / rho0 : linear;
        }
      case EosType::us_up:
        return mu > 0. ? a1 / rho0 * (std::log1p(-a2 * eta) / (a2 * a2) + eta / (a2 * (1. - a2 * eta))) : linear;
      case EosType::porous:
      case EosType::tabulated:
        return table->energy(mu) / rho0;
      }
    return 0.;
  }

  double EquationOfState::reference_sound_speed() const
  {
    return std::sqrt(sound_speed_squared(0., 0.));
  }

  std::string EquationOfState::summary(const double v) const
  {
    std::string text = fmt::format("{}, sound speed {:.4g} m/s", eos_types().name(type), reference_sound_speed());
    if (const double struck = struck_sound_speed(v); struck > reference_sound_speed())
      text += fmt::format(" at rest, {:.4g} m/s as it is struck", struck);
    return type != EosType::porous ? text
                                   : text + fmt::format("; {:g} % of pores in liquid of {:.5g} kg/m^3", 100. * a2, a1);
  }

  HugoniotState EquationOfState::hugoniot(const double v) const
  {
    const auto excess = [&](const double mu) { return pressure(mu) * mu / (1. + mu) - rho0 * v * v; };
    // The us-up law has a pole at eta = 1/k; the state sought lies before it.
    double low = 0., high = type == EosType::us_up && a2 > 1.5 ? (1. - 1e-12) / (a2 - 1.) : 2.;
    if (is_table())
      high = table->last_mu();
    if (type == EosType::tabulated && excess(high) < 0.)
      throw InputError(fmt::format("Section 'Equation of state', entry 'Pressure table': it ends at {:.4g}: {:.4g} Pa, "
                                   "before the shock of {:g} m/s.\nGive points up to where p mu/(1 + mu) is at least "
                                   "{:.4g} Pa, or lower the speed.",
                                   high, pressure(high), v, rho0 * v * v));
    if (excess(high) < 0.)
      throw InputError("The equation of state carries no shock of " + number_text(v) +
                       " m/s below threefold compression.\nLower the speed or check the constants in section "
                       "'Equation of state'.");
    // Bisection: 60 halvings exhaust the digits of a double.
    for (int k = 0; k < 60; ++k)
      {
        const double mid                = 0.5 * (low + high);
        (excess(mid) < 0. ? low : high) = mid;
      }
    HugoniotState state;
    state.density_ratio = 1. + high;
    state.pressure      = pressure(high);
    state.shock_speed   = v * (1. + high) / high;
    return state;
  }

  double EquationOfState::struck_sound_speed(const double v) const
  {
    const double at_rest = reference_sound_speed();
    return is_table() ? std::max(at_rest, 0.5 * hugoniot(std::max(v, 1.)).shock_speed) : at_rest;
  }

  double EquationOfState::hugoniot_slope(const double v) const
  {
    // Below 1 m/s the secant is all round-off and the tangent is the same to 0.1 %.
    const double speed = v > 1. ? v : 1.;
    const double slope = (hugoniot(speed).shock_speed - struck_sound_speed(speed)) / speed;
    return is_table() ? std::max(slope, 0.) : slope; // of weak shocks between points it may be a little less
  }
} // namespace birdstrike
