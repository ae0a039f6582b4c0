#include "material/porous_liquid.h"

#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double      tolerance = 1e-7;
    constexpr std::size_t n_coarse = 32, most_halvings = 12;

    double middle(const PressureTable::Point &a, const PressureTable::Point &b, const double unit)
    {
      return std::sqrt((a.pressure + unit) * (b.pressure + unit)) - unit;
    }

    void refine(const PorousLiquid &liquid, const PressureTable::Point &a, const PressureTable::Point &b,
                const std::size_t n_halvings, std::vector<PressureTable::Point> &points)
    {
      const auto   exact = liquid.at(middle(a, b, liquid.ambient_pressure));
      const double h = b.mu - a.mu, t = (exact.mu - a.mu) / h, r = 1. - t;
      const double cubic = r * r * (1. + 2. * t) * a.pressure + t * t * (3. - 2. * t) * b.pressure +
                           h * r * t * (r * a.slope - t * b.slope);
      if (n_halvings < most_halvings && std::abs(cubic - exact.pressure) > tolerance * exact.pressure)
        {
          refine(liquid, a, exact, n_halvings + 1, points);
          refine(liquid, exact, b, n_halvings + 1, points);
        }
      else
        points.push_back(b);
    }
  } // namespace

  PressureTable::Point PorousLiquid::at(const double pressure) const
  {
    const double in_liquid = std::log1p(pressure / liquid_modulus), in_pores = std::log1p(pressure / ambient_pressure);
    // 1 - rho0/rho without cancellation
    const double lost =
      -(1. - porosity) * std::expm1(-in_liquid / liquid_exponent) - porosity * std::expm1(-in_pores / gamma);
    const double rest = 1. - lost;
    const double rate =
      (1. - porosity) / (liquid_modulus * liquid_exponent) * std::exp(-in_liquid * (1. + 1. / liquid_exponent)) +
      porosity / (ambient_pressure * gamma) * std::exp(-in_pores * (1. + 1. / gamma));
    return {lost / rest, pressure, rest * rest / rate};
  }

  PressureTable PorousLiquid::tabulate() const
  {
    const double highest =
      liquid_modulus * std::expm1(liquid_exponent * std::log(3. * (1. - porosity))); // of rho/rho0 = 3, pores closed
    const double                      ratio = std::log1p(highest / ambient_pressure) / n_coarse;
    std::vector<PressureTable::Point> points{at(0.)};
    for (std::size_t k = 1; k <= n_coarse; ++k)
      {
        const auto from = points.back(), to = at(ambient_pressure * std::expm1(static_cast<double>(k) * ratio));
        refine(*this, from, to, 0, points);
      }
    return PressureTable(points);
  }
} // namespace birdstrike
