#include "material/tabulated_liquid.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

#include <fmt/format.h>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t most_points  = 1000;
    constexpr double      largest_fall = 1e-3;
    const std::string     entry        = "Section 'Equation of state', entry 'Pressure table': ";

    [[noreturn]] void refuse(const std::vector<PressureTable::Point> &points, const std::size_t k,
                             const std::string &what)
    {
      throw InputError(fmt::format("{}{}\nRead: points {} and {}, {:g}: {:g} and {:g}: {:g}.", entry, what, k, k + 1,
                                   points[k - 1].mu, points[k - 1].pressure, points[k].mu, points[k].pressure));
    }
  } // namespace

  PressureTable read_pressure_table(const std::string &text)
  {
    std::vector<PressureTable::Point> points;
    for (const auto &[mu, pressure] : parse_pairs(text, "Bird/Equation of state/Pressure table"))
      points.push_back({parse_numbers(mu, 1, "Bird/Equation of state/Pressure table")[0],
                        parse_numbers(pressure, 1, "Bird/Equation of state/Pressure table")[0], 0.});
    if (points.size() < 2 || points.size() > most_points)
      throw InputError(fmt::format("{}{} points were read.\nGive 2 to {} points 'mu: pressure' from '0: 0' on, mu = "
                                   "rho/rho0 - 1: '0: 0; 0.05: 130 MPa; 0.1: 320 MPa'.",
                                   entry, points.size(), most_points));
    if (points[0].mu != 0. || points[0].pressure != 0.)
      throw InputError(fmt::format("{}the first point is {:g}: {:g}.\nBegin with '0: 0': at the bird's Density the "
                                   "pressure above that of the air is zero.",
                                   entry, points[0].mu, points[0].pressure));
    const auto stiffness = [&](const std::size_t k) { return points[k].pressure * (1. + points[k].mu) / points[k].mu; };
    for (std::size_t k = 1; k < points.size(); ++k)
      {
        if (!(points[k].mu > points[k - 1].mu) || !(points[k].pressure > points[k - 1].pressure))
          refuse(points, k, "from point to point mu and pressure must grow.");
        if (k > 1 && stiffness(k) < (1. - largest_fall) * stiffness(k - 1))
          refuse(points, k,
                 "the liquid softens: p (1 + mu)/mu, which is rho0 U_s^2, falls, and no shock can travel there. Let "
                 "the pressure rise faster, or leave out a first part that is stiffer than the rest.");
      }
    PressureTable::choose_slopes(points);
    return PressureTable(points);
  }
} // namespace birdstrike
