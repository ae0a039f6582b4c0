#pragma once

#include <birdstrike/core/named_choices.h>
#include <birdstrike/core/number.h>
#include <birdstrike/material/power_law.h>

#include <memory>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  class PressureTable;

  enum class EosType
  {
    linear,
    murnaghan,
    polynomial,
    us_up,
    porous,
    tabulated
  };

  const NamedChoices<EosType> &eos_types();

  /// User entries of the bird's equation of state. The reference density belongs to the bird (section "Bird").
  struct EosParameters
  {
    EosType type               = EosType::murnaghan;
    double  bulk_modulus       = 2.2e9;   ///< Pa, linear
    double  murnaghan_modulus  = 128.e6;  ///< Pa, B
    double  murnaghan_exponent = 7.98;    ///< gamma
    double  c1                 = 2060.e6; ///< Pa, polynomial
    double  c2                 = 6190.e6;
    double  c3                 = 10300.e6;
    double  sound_speed        = 1482.9; ///< m/s, linear Us-up; of the liquid between pores
    double  shock_slope        = 2.;     ///< k in Us = c0 + k u
    double  porosity           = 0.1;
    double  liquid_density     = 0.;      ///< kg/m^3; 0: what gives the bird's density
    double  ambient_pressure   = 101325.; ///< Pa

    std::string pressure_table; ///< mu: Pa; ...

    void declare(dealii::ParameterHandler &prm);
    void check() const;
  };

  /// State behind a plane shock that brings liquid of speed v to rest at a rigid wall.
  struct HugoniotState
  {
    double density_ratio = 1.; ///< rho_1/rho_0
    double pressure      = 0.; ///< Pa
    double shock_speed   = 0.; ///< m/s, relative to the undisturbed liquid
  };

  /// Pressure of a liquid from its compression mu = rho/rho0 - 1 alone (barotropic, gauge pressure, p(0) = 0).
  ///
  ///   linear      p = K (1/V - 1) = K mu                                     (V = rho0/rho)
  ///   Murnaghan   p = B ((1 + mu)^gamma - 1)                                 (Murnaghan 1944)
  ///   polynomial  p = C1 mu + C2 mu^2 + C3 mu^3
  ///   us-up       p = rho0 c0^2 eta/(1 - k eta)^2, eta = mu/(1 + mu)         (the Hugoniot of Us = c0 + k u itself)
  ///   porous      rho0/rho of p: Wilbeck's liquid with pores of air (material/porous_liquid.h), tabulated
  ///   tabulated   points that somebody gives (material/tabulated_liquid.h)
  ///
  /// In tension (mu < 0) all but linear and Murnaghan continue with their slope at zero, where cubic, pole and table
  /// mean nothing. Sound speed c = sqrt(dp/drho). Units: Pa, m/s, kg/m^3. No temperature: shock heat does not change p.
  /// It does not cut tension off; the bird does.
  class EquationOfState
  {
  public:
    EquationOfState(const EosParameters &parameters, double reference_density);

    template <class Number>
    Number pressure(const Number &mu) const;

    /// Square of the sound speed, m^2/s^2; `pressure` is p(mu), which both formulas share.
    template <class Number>
    Number sound_speed_squared(const Number &mu, const Number &pressure) const;

    /// Energy stored per mass (J/kg), e(mu) = integral of p/rho^2 d rho from the reference density, in closed form,
    /// with V = rho0/rho = 1/(1 + mu), eta = mu/(1 + mu):
    ///   linear      rho0 e = K (ln(1 + mu) - eta)
    ///   Murnaghan   rho0 e = B (((1 + mu)^(gamma - 1) - 1)/(gamma - 1) - eta)
    ///   polynomial  rho0 e = C1 I1 + C2 I2 + C3 I3,  I1 = ln(1 + mu) - eta,  I2 = mu - ln(1 + mu) - I1,
    ///               I3 = mu^2/2 - 2 I2 - I1
    ///   us-up       rho0 e = rho0 c0^2 (ln(1 - k eta)/k^2 + eta/(k (1 - k eta)))
    /// and of a table by the integral of its own cubics. Below 1 % of compression closed forms lose digits by
    /// cancellation, at mu = 1e-6 ten of sixteen; the energy there is nothing.
    double energy(double mu) const;

    double reference_density() const
    {
      return rho0;
    }
    double reference_sound_speed() const;

    /// Rankine-Hugoniot for a barotropic liquid: p(rho1)(1 - rho0/rho1) = rho0 v^2, U_s = v rho1/(rho1 - rho0).
    /// Throws InputError if no compression up to threefold, or up to the end of a table, carries the speed v (m/s, >
    /// 0).
    HugoniotState hugoniot(double v) const;

    /// The sound speed (m/s) that the undisturbed liquid shows to a strike of the speed v: that at zero pressure, and
    /// of a table at least U_s/2. A porous liquid has 40 m/s there and 1100 m/s in the shock, whose waves never see the
    /// 40: impedances, contact springs and steps taken from it would belong to another liquid. A spring of rho0 U_s^2/4
    /// with the slope that goes with it carries the shock at nine tenths of its compression (ContactSpring), an
    /// acoustic liquid's at about one.
    double struck_sound_speed(double v) const;

    /// Secant slope s of U_s = c + s v at the speed v from its struck_sound_speed() c, as the contact law
    /// p = rho c u (1 + s u/c) wants it.
    double hugoniot_slope(double v) const;

    /// "murnaghan, sound speed 1037 m/s", and what else there is to say of a liquid that is struck at the speed v
    /// (m/s).
    std::string summary(double v) const;

  private:
    bool is_table() const
    {
      return table != nullptr;
    }
    // out of line: no loop over another law carries them
    double table_pressure(double mu) const;
    Lanes  table_pressure(Lanes mu) const;
    double table_slope(double mu) const;
    Lanes  table_slope(Lanes mu) const;

    EosType type;
    double  rho0;
    double  a1 = 0.; ///< Pa: K, B, C1 or rho0 c0^2; kg/m^3: liquid between pores
    double  a2 = 0.; ///< -: gamma, k or porosity; Pa: C2
    double  a3 = 0.; ///< Pa: C3

    std::shared_ptr<const PressureTable> table; ///< of porous and tabulated, shared by copies
  };

  template <class Number>
  Number EquationOfState::pressure(const Number &mu) const
  {
    switch (type)
      {
      case EosType::linear:
        return a1 * mu;
      case EosType::murnaghan:
        return a1 * compute_power_less_one(mu, a2);
      case EosType::polynomial:
        return select(mu > Number(0.), mu * (a1 + mu * (a2 + mu * a3)), a1 * mu);
      case EosType::us_up:
        {
          const Number eta = mu / (1. + mu), gap = 1. - a2 * eta;
          return select(mu > Number(0.), a1 * eta / (gap * gap), a1 * mu);
        }
      case EosType::porous:
      case EosType::tabulated:
        return table_pressure(mu);
      }
    return Number(0.);
  }

  template <class Number>
  Number EquationOfState::sound_speed_squared(const Number &mu, const Number &pressure) const
  {
    switch (type)
      {
      case EosType::linear:
        return Number(a1 / rho0);
      case EosType::murnaghan:
        return a2 * (pressure + a1) / (rho0 * (1. + mu));
      case EosType::polynomial:
        return select(mu > Number(0.), (a1 + mu * (2. * a2 + mu * 3. * a3)) / rho0, Number(a1 / rho0));
      case EosType::us_up:
        {
          // d eta/d mu = 1/(1 + mu)^2, dp/d eta = a1 (1 + k eta)/(1 - k eta)^3
          const Number eta = mu / (1. + mu), gap = 1. - a2 * eta, v = 1. + mu;
          return select(mu > Number(0.), a1 / rho0 * (1. + a2 * eta) / (gap * gap * gap * v * v), Number(a1 / rho0));
        }
      case EosType::porous:
      case EosType::tabulated:
        return table_slope(mu) / rho0;
      }
    return Number(0.);
  }
} // namespace birdstrike
