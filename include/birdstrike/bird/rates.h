#pragma once

#include <birdstrike/bird/neighbor_list.h>
#include <birdstrike/bird/parameters.h>
#include <birdstrike/bird/particles.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/thread_pool.h>
#include <birdstrike/material/equation_of_state.h>

#include <memory>

namespace birdstrike
{
  /// The right-hand side of the particle equations at the positions, and at velocity and mu as the predicting rates
  /// foretell them for the time dt later (Prediction).
  ///
  /// `update` fills force, compression_rate, power, dissipation, signal_speed, prediction_error, largest_mu, volume,
  /// density and sound_speed. Each owner sums over all its neighbours, with formulas symmetric in the pair: forces
  /// cancel to round-off, and
  ///   sum_i power_i = 0  to round-off.
  /// Raises NumericalFailure if a density is not positive or a position or velocity not finite.
  class Rates
  {
  public:
    virtual ~Rates() = default;

    /// Density by summation overwrites particles.mu and ignores its prediction.
    virtual void update(Particles &particles, double dt, const NeighborList &list, ThreadPool &pool) = 0;

    /// Lets the next update renew what it would otherwise keep for some passes: the state was set, not computed.
    virtual void renew_correction()
    {
    }

    /// Sound speed (m/s) below which no particle's goes, in impedances, viscosity, signals and what contact sees
    /// (EquationOfState::struck_sound_speed); the pressure is that of its law all the same.
    void set_slowest_sound(const double speed)
    {
      slowest_sound = speed;
    }

    /// What is kept from one update to the next, besides what particles hold.
    virtual void archive(Archive &)
    {
    }

  protected:
    double slowest_sound = 0.;
  };

  std::unique_ptr<Rates> make_rates(const BirdParameters &parameters, const EquationOfState &eos, double spacing);

  /// Throws NumericalFailure naming the first particle in [begin, end) whose state is not finite or not compressible.
  [[noreturn]] void report_failed_particle(const Particles &particles, double dt, std::size_t begin, std::size_t end);

  /// Whether the numbers starting at particle p are all in order (finite motion, density > 0).
  template <class Number>
  bool is_sound(const Particles &particles, const Prediction<Number> &prediction, const std::size_t p)
  {
    const Number &mu  = prediction.mu;
    Number        sum = 0.;
    for (int d = 0; d < 3; ++d)
      sum += load<Number>(&particles.x[d][p]) + prediction.velocity[d];
    return all(mu > Number(-1.) && sum * 0. == Number(0.) && mu * 0. == Number(0.));
  }
} // namespace birdstrike
