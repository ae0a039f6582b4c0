#include <birdstrike/core/declare_choice.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/material/equation_of_state.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace birdstrike
{
  const NamedChoices<EosType> &eos_types()
  {
    static const NamedChoices<EosType> choices{{"linear", EosType::linear},
                                               {"murnaghan", EosType::murnaghan},
                                               {"polynomial", EosType::polynomial},
                                               {"us-up", EosType::us_up}};
    return choices;
  }

  void EosParameters::declare(dealii::ParameterHandler &prm)
  {
    using namespace dealii;
    const Patterns::Double positive(1e-300);
    prm.enter_subsection("Equation of state");
    declare_choice(prm, "Type", type, eos_types(),
                   "Law of the bird's pressure: linear p = K(1/V - 1), murnaghan p = B((rho/rho0)^gamma - 1), "
                   "polynomial in mu = rho/rho0 - 1, or us-up (shock speed linear in particle speed). [-]");
    prm.add_parameter("Bulk modulus", bulk_modulus, "Modulus K of the linear law. [Pa]", positive);
    prm.add_parameter("Murnaghan modulus", murnaghan_modulus, "Modulus B of the Murnaghan law. [Pa]", positive);
    prm.add_parameter("Murnaghan exponent", murnaghan_exponent, "Exponent gamma of the Murnaghan law. [-]",
                      Patterns::Double(1.));
    prm.add_parameter("Polynomial C1", c1, "Coefficient of mu. [Pa]", positive);
    prm.add_parameter("Polynomial C2", c2, "Coefficient of mu squared. [Pa]", Patterns::Double(0.));
    prm.add_parameter("Polynomial C3", c3, "Coefficient of mu cubed. [Pa]", Patterns::Double(0.));
    prm.add_parameter("Sound speed", sound_speed, "Speed c0 in Us = c0 + k u of the us-up law. [m/s]", positive);
    prm.add_parameter("Shock slope", shock_slope, "Slope k in Us = c0 + k u of the us-up law. [-]",
                      Patterns::Double(0.));
    prm.leave_subsection();
  }

  void EosParameters::check() const
  {
    if (type == EosType::us_up && shock_slope < 0.5)
      throw InputError("Section 'Equation of state', entry 'Shock slope': " + std::to_string(shock_slope) +
                       " is too small.\nBelow 0.5 the us-up law softens under compression and carries no shock."
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
      }
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
      }
    return 0.;
  }

  double EquationOfState::reference_sound_speed() const
  {
    return std::sqrt(sound_speed_squared(0., 0.));
  }

  HugoniotState EquationOfState::hugoniot(const double v) const
  {
    const auto excess = [&](const double mu) { return pressure(mu) * mu / (1. + mu) - rho0 * v * v; };
    // The us-up law has a pole at eta = 1/k; the state sought lies before it.
    double low = 0., high = type == EosType::us_up && a2 > 1.5 ? (1. - 1e-12) / (a2 - 1.) : 2.;
    if (excess(high) < 0.)
      throw InputError("The equation of state carries no shock of " + std::to_string(v) +
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

  double EquationOfState::hugoniot_slope(const double v) const
  {
    // Below 1 m/s the secant is all round-off and the tangent is the same to 0.1 %.
    const double speed = v > 1. ? v : 1.;
    return (hugoniot(speed).shock_speed - reference_sound_speed()) / speed;
  }
} // namespace birdstrike
