#pragma once

#include <birdstrike/bird/parameters.h>
#include <birdstrike/bird/particles.h>

#include <array>

namespace birdstrike
{
  /// Deviatoric stress of the bird, xx yy zz xy xz yz in Pa: elastic, perfectly plastic beside the pressure of the
  /// liquid, as in hydrodynamic elastic-plastic metals (Wilkins 1964, "Calculation of elastic-plastic flow").
  ///
  /// State is s = S rho0/rho, S being Cauchy's: then the work S:D/rho per mass is s:D/rho0 and what shear stores
  /// s:s/(4 G rho0), without terms of the density. With L the velocity gradient, D and W its halves:
  ///   s' = 2 G dev D + W s - s W                            (Jaumann 1911)
  ///   |S| <= sqrt(2/3) Y                                    (von Mises), by radial return (Wilkins 1964)
  /// The rotation of a step is orthogonal, (1 - dt W/2)^-1 (1 + dt W/2) (Hughes & Winget 1980): it stores nothing.
  /// Liquid that has come apart, mu < -0.01 at zero pressure, has no strength left until it is compressed again.
  struct Strength
  {
    explicit Strength(const BirdParameters &parameters)
      : shear_modulus(parameters.shear_modulus)
      , yield_stress(parameters.yield_stress)
      , comes_apart(parameters.tension_cutoff)
    {
    }

    /// Square of sound speed that shear adds to the bulk's, 4 G/(3 rho0) at any density, m^2/s^2.
    double stiffening(const double reference_density) const
    {
      return yield_stress > 0. ? 4. / 3. * shear_modulus / reference_density : 0.;
    }

    double shear_modulus, yield_stress; ///< Pa
    bool   comes_apart;
  };

  inline constexpr double apart_mu = -0.01;

  template <class Number>
  Number contract(const std::array<Number, 6> &a, const std::array<Number, 6> &b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2. * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
  }

  /// R s R^T, R the orthogonal matrix of Hughes & Winget for the rotation vector `angle`.
  template <class Number>
  std::array<Number, 6> rotate(const std::array<Number, 6> &s, const std::array<Number, 3> &angle)
  {
    const auto &[x, y, z] = angle;
    const Number half     = Number(0.5) / (1. + 0.25 * (x * x + y * y + z * z)), one(1.);
    // 1 + (W + W W/2)/(1 + |angle|^2/4), W v = angle x v
    const Number R[3][3] = {{one - half * (y * y + z * z), half * (x * y - 2. * z), half * (x * z + 2. * y)},
                            {half * (x * y + 2. * z), one - half * (x * x + z * z), half * (y * z - 2. * x)},
                            {half * (x * z - 2. * y), half * (y * z + 2. * x), one - half * (x * x + y * y)}};
    const Number S[3][3] = {{s[0], s[3], s[4]}, {s[3], s[1], s[5]}, {s[4], s[5], s[2]}};
    const auto   entry   = [&](const int a, const int b) {
      Number sum = 0.;
      for (int c = 0; c < 3; ++c)
        sum += R[a][c] * (S[c][0] * R[b][0] + S[c][1] * R[b][1] + S[c][2] * R[b][2]);
      return sum;
    };
    return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
  }

  template <class Number>
  struct StressStep
  {
    std::array<Number, 6> stress;     ///< s at the end, Pa
    Number                dissipated; ///< J per undeformed m^3: what flows or comes apart
  };

  /// The step dt (s) of s at the strain rates (1/s, symmetric half of the velocity gradient) and the spin (rad/s, half
  /// the vorticity), to the compression mu at its end. Of the work (s_old + s)/2 : D dt what is not stored is
  /// dissipated, (s_old + s) : (s_trial - s)/(4 G), which is never negative where the radius of the yield surface has
  /// not shrunk.
  template <class Number>
  StressStep<Number> advance(const Strength &strength, const std::array<Number, 6> &stress,
                             const std::array<Number, 6> &rate, const std::array<Number, 3> &spin, const Number &mu,
                             const double dt)
  {
    const std::array<Number, 6> turned = rotate(stress, {dt * spin[0], dt * spin[1], dt * spin[2]});
    const Number                mean   = (rate[0] + rate[1] + rate[2]) * (1. / 3.);
    const double                G2     = 2. * strength.shear_modulus;
    std::array<Number, 6>       trial, sum, lost;
    for (int k = 0; k < 6; ++k)
      trial[k] = turned[k] + (G2 * dt) * (k < 3 ? rate[k] - mean : rate[k]);
    const Number radius  = std::sqrt(2. / 3.) * strength.yield_stress / (1. + mu);
    const Number squared = contract(trial, trial);
    Number       share   = select(squared > radius * radius, radius / sqrt(max(squared, Number(1e-300))), Number(1.));
    if (strength.comes_apart)
      share = select(mu < Number(apart_mu), Number(0.), share);
    StressStep<Number> step;
    for (int k = 0; k < 6; ++k)
      {
        step.stress[k] = share * trial[k];
        sum[k]         = turned[k] + step.stress[k];
        lost[k]        = trial[k] - step.stress[k];
      }
    step.dissipated = contract(sum, lost) * (0.5 / G2);
    return step;
  }

  /// Stress, strain rates and spin of particles p, p + 1, ..., the last two as the columns have them.
  template <class Number, class Rates, class Spin>
  StressStep<Number> advance(const Strength &strength, const Particles &particles, const Rates &rates,
                             const Spin &spins, const std::size_t p, const Number &mu, const double dt)
  {
    std::array<Number, 6> stress, rate;
    std::array<Number, 3> spin;
    for (int k = 0; k < 6; ++k)
      {
        stress[k] = load<Number>(&particles.stress[k][p]);
        rate[k]   = load<Number>(&rates[k][p]);
      }
    for (int d = 0; d < 3; ++d)
      spin[d] = load<Number>(&spins[d][p]);
    return advance(strength, stress, rate, spin, mu, dt);
  }
} // namespace birdstrike
