#include "bird/riemann_rates.h"
#include "bird/standard_rates.h"
#include <birdstrike/bird/rates.h>
#include <birdstrike/core/numerical_failure.h>

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
    FailureFacts             facts{"A bird particle has lost its state",
                       "density over reference density",
                       1. + failed.mu,
                       "-",
                       0.,
                       "allowed: more than"};
    facts.where   = {"particle", particles.id[p], {{particles.x[0][p], particles.x[1][p], particles.x[2][p]}}};
    facts.details = fmt::format("Its velocity is ({:.6g}, {:.6g}, {:.6g}) m/s.", failed.velocity[0], failed.velocity[1],
                                failed.velocity[2]);
    facts.advice  = "Reduce Bird/Courant number or Time/Bird step scale, and check the contact there.";
    throw NumericalFailure(std::move(facts));
  }
} // namespace birdstrike
