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
    using Column      = AlignedVector<double>;
    using Column3     = std::array<Column, 3>;
    using FloatColumn = AlignedVector<float>;

    double      mass                  = 0.; ///< kg, of each
    std::size_t n_ids                 = 0;
    bool        has_velocity_gradient = false;
    bool        has_strength          = false;

    AlignedVector<std::uint32_t> id;
    Column3                      x;               ///< m
    Column3                      v;               ///< m/s
    Column                       mu;              ///< rho/rho0 - 1
    Column                       internal_energy; ///< J, by the energy equation
    Column                       dissipated;      ///< J, of it: by what heats
    std::array<Column, 6>        stress;          ///< Pa, deviatoric, of undeformed areas (bird/strength.h); or empty

    // What the last evaluation of the rates left.
    Column3                    force;             ///< N, of the particles on each other
    Column                     compression_rate;  ///< 1/s, -div v
    Column                     power;             ///< W, internal energy rate + force . predicted velocity
    Column                     dissipation;       ///< W, of viscosity or Riemann flux
    Column                     signal_speed;      ///< m/s, c + 1.2 largest approach speed; 0 if isolated
    Column                     largest_mu;        ///< of the particle and those within its support
    Column                     prediction_error;  ///< J, see compute_prediction_error
    std::array<FloatColumn, 6> correction;        ///< B: xx yy zz xy xz yz
    std::array<Column, 6>      velocity_gradient; ///< 1/s, symmetric part; empty without reconstruction or strength
    Column3                    spin;              ///< rad/s, half the vorticity; empty without strength
    std::array<FloatColumn, 6> shear_correction;  ///< of stresses (bird/correction.h); empty without strength

    // What the last evaluation was predicted with: rates of the one before, or between those and its own (Bird).
    Column3 predicting_force;            ///< N
    Column  predicting_compression_rate; ///< 1/s

    // The same, empty without strength.
    std::array<Column, 6> predicting_velocity_gradient, earlier_velocity_gradient; ///< 1/s, of the evaluation before
    Column3               predicting_spin, earlier_spin;                           ///< rad/s

    // What contact sees and gives.
    Column  volume, density, sound_speed;
    Column3 contact_force;      ///< N
    double  contact_share = 1.; ///< of a half kick, for which contact acts in it

    std::size_t size() const
    {
      return id.size();
    }

    /// Calls f(column) for every column but `id`, of doubles or floats.
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

  /// Liquid at zero pressure remembers how far it has come apart, up to twice its volume: beyond, spray would weigh
  /// more and more in its neighbours' sums.
  template <class Number>
  Number expand_at_most(const Number &mu)
  {
    const Number thinnest(-0.5);
    return select(mu > Number(-1.) && mu < thinnest, thinnest, mu); // what is no density passes, to be reported
  }

  /// What the predicting rates foretell for the time dt later, at which the new ones are evaluated.
  template <class Number>
  struct Prediction
  {
    Prediction(const Particles &particles, const std::size_t p, const double dt)
      : mu(expand_at_most(
          compress(load<Number>(&particles.mu[p]), load<Number>(&particles.predicting_compression_rate[p]), dt)))
    {
      for (int d = 0; d < 3; ++d)
        velocity[d] = load<Number>(&particles.v[d][p]) +
                      (dt / particles.mass) * (load<Number>(&particles.predicting_force[d][p]) +
                                               particles.contact_share * load<Number>(&particles.contact_force[d][p]));
    }

    Vector3<Number> velocity; ///< m/s
    Number          mu;
  };

  /// Energy (J) that the evaluation makes by its prediction, m |dt df/m|^2 + m (c dt dr)^2, with df and dr what force
  /// and compression rate differ by from those that predicted. Over two half kicks of dt each the powers f.v and p V r
  /// are taken at velocity and mu that are wrong by dt df/m and (1 + mu) dt dr; of 2 f.df = |df|^2 + d(|f|^2), and of
  /// r dr likewise, later steps give the second part back. The sound speed c (m/s) is 0 where tension is cut off.
  template <class Number>
  Number compute_prediction_error(const Particles &particles, const std::size_t p, const double dt, const Number &c)
  {
    Number square = 0.;
    for (int d = 0; d < 3; ++d)
      {
        const Number change = load<Number>(&particles.force[d][p]) - load<Number>(&particles.predicting_force[d][p]);
        square += change * change;
      }
    const Number leap =
      c * (load<Number>(&particles.compression_rate[p]) - load<Number>(&particles.predicting_compression_rate[p]));
    return (dt * dt) * (square * (1. / particles.mass) + particles.mass * leap * leap);
  }

  template <class Function>
  void Particles::for_each_column(const Function &f)
  {
    for (Column3 *vector : {&x, &v, &force, &predicting_force, &contact_force})
      for (Column &column : *vector)
        f(column);
    for (Column *column :
         {&mu, &internal_energy, &dissipated, &compression_rate, &power, &dissipation, &signal_speed, &largest_mu,
          &prediction_error, &predicting_compression_rate, &volume, &density, &sound_speed})
      f(*column);
    for (FloatColumn &column : correction)
      f(column);
    if (has_velocity_gradient)
      for (Column &column : velocity_gradient)
        f(column);
    if (!has_strength)
      return;
    for (std::array<Column, 6> *tensor : {&stress, &predicting_velocity_gradient, &earlier_velocity_gradient})
      for (Column &column : *tensor)
        f(column);
    for (Column3 *vector : {&spin, &predicting_spin, &earlier_spin})
      for (Column &column : *vector)
        f(column);
    for (FloatColumn &column : shear_correction)
      f(column);
  }

  inline void Particles::resize(const std::size_t n)
  {
    id.resize(n);
    for_each_column([n](auto &column) {
      column.reserve(n + n_lanes); // loops may read, never write, one register past the end
      column.resize(n, 0);
    });
  }
} // namespace birdstrike
