#include "../record.h"
#include "bird_case.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

using namespace birdstrike;
using namespace birdstrike::test;

/// Plane sound waves of wave number k along an axis of a cubic lattice under the pressure P, standard particles without
/// viscosity (Morris 1996, here with sums over the lattice in space):
///   w^2 = (m/rho)^2 (c^2 - 2 P/rho) S^2 + 2 m P/rho^2 C,  S = sum_j W_z sin(k z_j),  C = sum_j W_zz (1 - cos(k z_j))
/// In tension the shortest waves grow (Swegle 1995), where pressures may be negative.
namespace
{
  constexpr double dx = 1e-3, rho_0 = 950., sound_speed = 1500.;

  /// w^2 (1/s^2) of the cubic spline W = (1 - 1.5 q^2 + 0.75 q^3)/(pi h^3), 0.25 (2 - q)^3/(pi h^3) beyond q = r/h = 1.
  double compute_dispersion(const double h, const double k, const double mu)
  {
    const double rho = rho_0 * (1. + mu), m = rho_0 * dx * dx * dx, P = rho_0 * sound_speed * sound_speed * mu;
    const int    n = int(2. * h / dx) + 1;
    double       S = 0., C = 0.;
    for (int i = -n; i <= n; ++i)
      for (int j = -n; j <= n; ++j)
        for (int l = -n; l <= n; ++l)
          {
            const double r = dx * std::sqrt(double(i * i + j * j + l * l)), z = dx * l, q = r / h;
            if (r == 0. || q >= 2.)
              continue;
            const double norm  = 1. / (std::numbers::pi * h * h * h * h);
            const double slope = norm * (q < 1. ? -3. * q + 2.25 * q * q : -0.75 * (2. - q) * (2. - q));
            const double curve = norm / h * (q < 1. ? -3. + 4.5 * q : 1.5 * (2. - q));
            S += slope * z / r * std::sin(k * z);
            C += (curve * z * z / (r * r) + slope * (1. / r - z * z / (r * r * r))) * (1. - std::cos(k * z));
          }
    return m * m / (rho * rho) * (sound_speed * sound_speed - 2. * P / rho) * S * S + 2. * m * P / (rho * rho) * C;
  }

  struct Wave
  {
    double exact, found; ///< w^2, 1/s^2
  };

  /// From rest displacement and a speed v0 cos(k z): v = v0 cos(w t), or v0 cosh where w^2 < 0, after one radian.
  Wave run(const double smoothing_ratio, const int n_layers, const double number, const double mu)
  {
    BirdParameters parameters  = column(n_layers, dx);
    parameters.is_periodic     = {{true, true, true}};
    parameters.density         = rho_0;
    parameters.formulation     = ParticleFormulation::standard;
    parameters.smoothing_ratio = smoothing_ratio;
    parameters.slab_lengths[0] = parameters.slab_lengths[1] = 8. * dx; // two ranges of 2 h
    parameters.alpha = parameters.beta = 0.;
    parameters.tension_cutoff          = false;
    parameters.courant_number          = 0.1;
    EosParameters eos;
    eos.type         = EosType::linear;
    eos.bulk_modulus = rho_0 * sound_speed * sound_speed;
    ThreadPool   pool(2);
    Bird         bird(parameters, eos, pool);
    const double k = number / dx, v0 = 1e-6;
    double       z0 = 0.;
    bird.set_state([&](Point3 &x, Point3 &v, double &m) {
      z0 = 0.5 * dx; // a layer's place: none lies in a node of the shortest wave
      v  = Point3(0., 0., v0 * std::cos(k * (x[2] - z0)));
      m  = mu;
    });
    const auto amplitude = [&] {
      double sum = 0., squares = 0.;
      for (std::size_t p = 0; p < bird.state().size(); ++p)
        {
          const double shape = std::cos(k * (bird.state().x[2][p] - z0));
          sum += shape * bird.state().v[2][p];
          squares += shape * shape;
        }
      return sum / squares;
    };
    const double exact = compute_dispersion(smoothing_ratio * dx, k, mu), t = 1. / std::sqrt(std::abs(exact));
    const double start = amplitude();
    advance(bird, t);
    const double ratio = amplitude() / start;
    const double angle = ratio > 1. ? std::acosh(ratio) : std::acos(ratio);
    return {exact, (ratio > 1. ? -1. : 1.) * angle * angle / (t * t)};
  }
} // namespace

// Rates of the shortest wave under P/(rho c^2) = -0.02 and -0.05; 5 % is asked, what remains is the step's error.
TEST(Dispersion, ShortestWavesGrowInTensionAtTheirRate)
{
  for (const double h : {1., 1.2, 1.3})
    for (const double tension : {-0.02, -0.05})
      {
        const Wave wave = run(h, 8, std::numbers::pi, tension / (1. - tension));
        ASSERT_LT(wave.exact, 0.) << "h " << h;
        EXPECT_NEAR(wave.found / wave.exact, 1., 0.01) << "h " << h << ", P " << tension;
        record("rate over exact, h " + std::to_string(h).substr(0, 3) + " P " + std::to_string(tension).substr(0, 5),
               std::sqrt(wave.found / wave.exact));
      }
}

// Sound of sixteen particles a wave: the lattice's own speed, 0.93 to 0.99 of c.
TEST(Dispersion, LongWavesHaveTheSpeedOfTheirLattice)
{
  for (const double h : {1., 1.2, 1.3, 1.5})
    {
      const double number = std::numbers::pi / 8.;
      const Wave   wave   = run(h, 16, number, 0.);
      EXPECT_NEAR(std::sqrt(wave.found / wave.exact), 1., 0.005) << "h " << h;
      record("speed over exact, h " + std::to_string(h).substr(0, 3), std::sqrt(wave.found / wave.exact));
      record("speed over c, h " + std::to_string(h).substr(0, 3), std::sqrt(wave.found) / (number / dx * sound_speed));
    }
}
