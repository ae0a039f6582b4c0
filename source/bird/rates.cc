#include "bird/riemann_rates.h"
#include "bird/standard_rates.h"
#include <birdstrike/bird/rates.h>
#include <birdstrike/core/errors.h>

#include <algorithm>

#include <fmt/format.h>

namespace birdstrike
{
  std::unique_ptr<Rates> make_rates(const BirdParameters &parameters, const EquationOfState &eos, const double spacing)
  {
    if (parameters.is_riemann())
      {
        if (parameters.pair_precision == PairPrecision::as_float)
          return std::make_unique<RiemannRates<float>>(parameters, eos, spacing);
        return std::make_unique<RiemannRates<double>>(parameters, eos, spacing);
      }
    return std::make_unique<StandardRates>(parameters, eos, spacing);
  }

  void report_failed_particle(const Particles &particles, const double dt, const std::size_t begin,
                              const std::size_t end)
  {
    std::size_t p = begin;
    while (p + 1 < std::min(end, particles.size()) && is_sound(particles, Prediction<double>(particles, p, dt), p))
      ++p;
    const Prediction<double> failed(particles, p, dt);
    throw NumericalFailure(fmt::format("Bird particle {} at ({:.6g}, {:.6g}, {:.6g}) m has lost its state:\n"
                                       "density over reference density {:.6g}, velocity ({:.6g}, {:.6g}, {:.6g}) m/s.\n"
                                       "Lower 'Courant number' in section 'Bird', or look at the contact there.",
                                       particles.id[p], particles.x[0][p], particles.x[1][p], particles.x[2][p],
                                       1. + failed.mu, failed.velocity[0], failed.velocity[1], failed.velocity[2]));
  }
} // namespace birdstrike
