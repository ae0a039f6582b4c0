#pragma once

#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/number.h>

#include <array>
#include <cstdint>

namespace birdstrike
{
  /// State and rates of all particles, structure of arrays; index = position in memory, which sorting changes, `id`
  /// stays. All particles have one mass and one smoothing length. SI units.
  struct Particles
  {
    using Column  = AlignedVector<double>;
    using Column3 = std::array<Column, 3>;

    double      mass  = 0.; ///< kg, of each
    std::size_t n_ids = 0;

    AlignedVector<std::uint32_t> id;
    Column3                      x;               ///< m
    Column3                      v;               ///< m/s
    Column                       mu;              ///< rho/rho0 - 1
    Column                       internal_energy; ///< J
    Column3                      displacement;    ///< m, since the neighbour list was built

    // What the last evaluation of the rates left.
    Column3               force;                ///< N, of the particles on each other
    Column3               predicted_velocity;   ///< m/s, with which the rates were evaluated
    Column                compression_rate;     ///< 1/s, -div v
    Column                internal_energy_rate; ///< W, at the predicted velocity
    Column                signal_speed;         ///< m/s, c + 1.2 largest approach speed; 0 if isolated
    Column                largest_mu;           ///< of the particle and those within its support
    std::array<Column, 6> correction;           ///< B: xx yy zz xy xz yz
    std::array<Column, 6> velocity_gradient;    ///< 1/s, symmetric part, for the reconstruction

    // What contact sees and gives.
    Column  volume, density, sound_speed;
    Column3 contact_force; ///< N

    std::size_t size() const
    {
      return id.size();
    }

    /// Calls f(column) for every column of doubles.
    template <class Function>
    void for_each_column(const Function &f);

    void resize(std::size_t n);
  };

  /// mu after the time dt at a constant compression rate, 1 + mu' = (1 + mu) exp(rate dt), by the (2,2) Pade
  /// approximant of exp: positive for any rate, digits of a small mu kept.
  template <class Number>
  Number compress(const Number &mu, const Number &rate, const double dt)
  {
    const Number e = dt * rate;
    return mu + (1. + mu) * (12. * e / (12. - 6. * e + e * e));
  }

  template <class Function>
  void Particles::for_each_column(const Function &f)
  {
    for (Column3 *vector : {&x, &v, &displacement, &force, &predicted_velocity, &contact_force})
      for (Column &column : *vector)
        f(column);
    for (Column *column : {&mu, &internal_energy, &compression_rate, &internal_energy_rate, &signal_speed, &largest_mu,
                           &volume, &density, &sound_speed})
      f(*column);
    for (auto *tensor : {&correction, &velocity_gradient})
      for (Column &column : *tensor)
        f(column);
  }

  inline void Particles::resize(const std::size_t n)
  {
    id.resize(n);
    for_each_column([n](Column &column) {
      column.reserve(n + n_lanes); // loops may read, never write, one register past the end
      column.resize(n, 0.);
    });
  }
} // namespace birdstrike
