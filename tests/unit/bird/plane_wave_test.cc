#include "../record.h"
#include "bird_case.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

using namespace birdstrike;
using namespace birdstrike::test;

namespace
{
  struct ShockFigures
  {
    double plateau = 0., shock_speed = 0., overshoot = 0., energy_error = 0., momentum_error = 0.;
  };

  /// Two columns of N layers meet at +-v: each is the other's exact rigid wall. Figures relative to the exact state.
  ShockFigures collide(BirdParameters parameters, const std::string &law, const double v)
  {
    EosParameters eos_parameters;
    eos_parameters.type = eos_types().at(law);
    ThreadPool            pool(2);
    Bird                  bird(parameters, eos_parameters, pool);
    const EquationOfState eos(eos_parameters, parameters.density);
    const HugoniotState   exact  = eos.hugoniot(v);
    const double          length = 0.5 * parameters.slab_lengths[2], t_end = 0.6 * length / exact.shock_speed;
    bird.set_closing_speed(v);
    bird.set_state([&](Point3 &x, Point3 &u, double &) { u = Point3(0., 0., x[2] < 0. ? v : -v); });

    ShockFigures figures;
    const double initial = bird.energies().total();
    advance(bird, t_end, [&] {
      figures.energy_error = std::max(figures.energy_error, std::abs(bird.energies().total() / initial - 1.));
    });
    const Particles                       &state = bird.state();
    std::vector<std::pair<double, double>> profile; // z, p
    for (std::size_t p = 0; p < state.size(); ++p)
      if (state.x[2][p] > 0.)
        profile.emplace_back(state.x[2][p], std::max(0., eos.pressure(state.mu[p])) / exact.pressure);
    std::sort(profile.begin(), profile.end());
    const double front = (exact.shock_speed - v) * t_end;
    double       peak = 0., sum = 0., crossing = 0.;
    int          count = 0;
    for (std::size_t k = 0; k < profile.size(); ++k)
      {
        const auto &[z, p] = profile[k];
        peak               = std::max(peak, p);
        if (z > 0.2 * front && z < 0.7 * front)
          {
            sum += p;
            ++count;
          }
        if (k > 0 && profile[k - 1].second > 0.5 && p <= 0.5)
          crossing = profile[k - 1].first +
                     (z - profile[k - 1].first) * (profile[k - 1].second - 0.5) / (profile[k - 1].second - p);
      }
    figures.plateau        = sum / count - 1.;
    figures.shock_speed    = (crossing / t_end + v) / exact.shock_speed - 1.;
    figures.overshoot      = peak - 1.;
    figures.momentum_error = std::abs(bird.momenta().momentum[2]) / (state.mass * state.size() * v);
    return figures;
  }

  void expect_exact_shock(const BirdParameters &parameters, const double largest_overshoot,
                          const double largest_energy_error = 1e-3)
  {
    for (const char *law : {"murnaghan", "polynomial", "linear"})
      {
        const ShockFigures figures = collide(parameters, law, 177.4);
        SCOPED_TRACE(law);
        std::printf("  %-10s plateau %+.2f %%, shock speed %+.2f %%, overshoot %.1f %%, energy %.1e, momentum %.1e\n",
                    law, 100. * figures.plateau, 100. * figures.shock_speed, 100. * figures.overshoot,
                    figures.energy_error, figures.momentum_error);
        // published accuracy of SPH at h = 1.3 dx; momentum by construction; energy as densities and heat have it
        record(std::string(law) + " plateau", 1. + figures.plateau);
        record(std::string(law) + " shock speed", 1. + figures.shock_speed);
        record(std::string(law) + " overshoot", figures.overshoot);
        record(std::string(law) + " energy", figures.energy_error);
        record(std::string(law) + " momentum", figures.momentum_error);
        EXPECT_LT(std::abs(figures.plateau), 0.025);
        EXPECT_LT(std::abs(figures.shock_speed), 0.025);
        EXPECT_LT(figures.overshoot, largest_overshoot);
        EXPECT_LT(figures.momentum_error, 1e-12);
        EXPECT_LT(figures.energy_error, largest_energy_error);
      }
  }
} // namespace

// Rankine-Hugoniot state of three laws at 177.4 m/s.
TEST(PlaneWave, ShockOnASymmetryWallRiemann)
{
  expect_exact_shock(column(200, 1e-3), 0.10);
}

TEST(PlaneWave, ShockOnASymmetryWallRiemannReconstructed)
{
  BirdParameters parameters = column(200, 1e-3);
  parameters.reconstruction = Reconstruction::linear;
  parameters.courant_number = 0.5; // at the default 0.35 Murnaghan's overshoot is 11.2 %: less damping by the time step
  // so little in each step that no prediction is repeated, errors of prediction add up to 0.2-0.3 %
  expect_exact_shock(parameters, 0.10, 5e-3);
}

TEST(PlaneWave, ShockOnASymmetryWallStandard)
{
  BirdParameters parameters = column(200, 1e-3);
  parameters.formulation    = ParticleFormulation::standard;
  expect_exact_shock(parameters, 0.10);
}

// Liquid with pores: sound at rest is thirty times slower than the shock, and the front one spacing thick. Particles
// lose up to 0.2 % of their density there (riemann), 4 % of the pressure behind it, and ring once in the pores'
// closing.
TEST(PlaneWave, ShockInPorousLiquid)
{
  struct Case
  {
    ParticleFormulation formulation;
    double              v, largest_overshoot; // ringing of the pores' closing: measured 38, 24, 16; 84, 35, 33 %
  };
  for (const auto &[formulation, v, largest_overshoot] :
       {Case{ParticleFormulation::riemann, 50., 0.4}, Case{ParticleFormulation::riemann, 177.4, 0.26},
        Case{ParticleFormulation::riemann, 300., 0.18}, Case{ParticleFormulation::standard, 50., 0.9},
        Case{ParticleFormulation::standard, 177.4, 0.38}, Case{ParticleFormulation::standard, 300., 0.36}})
    {
      BirdParameters parameters  = column(200, 1e-3);
      parameters.density         = 900.;
      parameters.formulation     = formulation;
      const ShockFigures figures = collide(parameters, "porous", v);
      const std::string  name =
        particle_formulations().name(formulation) + " " + std::to_string(static_cast<int>(v)) + " m/s";
      std::printf("  %-18s plateau %+.2f %%, shock speed %+.2f %%, overshoot %.1f %%, energy %.1e, momentum %.1e\n",
                  name.c_str(), 100. * figures.plateau, 100. * figures.shock_speed, 100. * figures.overshoot,
                  figures.energy_error, figures.momentum_error);
      record("porous " + name + " plateau", 1. + figures.plateau);
      record("porous " + name + " shock speed", 1. + figures.shock_speed);
      record("porous " + name + " overshoot", figures.overshoot);
      record("porous " + name + " energy", figures.energy_error);
      EXPECT_LT(std::abs(figures.plateau), 0.04) << name;
      EXPECT_LT(std::abs(figures.shock_speed), 0.04) << name;
      EXPECT_LT(figures.overshoot, largest_overshoot) << name;
      EXPECT_LT(figures.momentum_error, 1e-12) << name;
      EXPECT_LT(figures.energy_error, 3e-3) << name;
    }
}

// Liquid shock tube, 100 MPa against 0: p* and u* of the exact Riemann solution.
TEST(PlaneWave, LiquidShockTube)
{
  struct Case
  {
    const char *law;
    double      rho_left, p_star, u_star, shock, tail;
  };
  for (const auto &[law, rho_left, p_star, u_star, shock, tail] :
       {Case{"murnaghan", 1021.2751, 45.9351e6, 42.6946, 1132.53, -1143.04},
        Case{"polynomial", 990.5470, 47.9113e6, 32.7880, 1538.15, -1538.10},
        Case{"linear", 993.1818, 49.4439e6, 33.8231, 1538.78, -1487.95}})
    {
      EosParameters eos_parameters;
      eos_parameters.type = eos_types().at(law);
      const EquationOfState eos(eos_parameters, 950.);
      ThreadPool            pool(2);
      Bird                  bird(column(300, 1e-3), eos_parameters, pool);
      bird.set_state([&](Point3 &x, Point3 &, double &mu) {
        if (x[2] < 0.)
          {
            mu = rho_left / 950. - 1.;
            x[2] /= 1. + mu;
          }
      });
      const double t_end = 0.045 / 1100.;
      advance(bird, t_end);
      const Particles &state = bird.state();
      double           p = 0., u = 0.;
      int              count = 0;
      for (std::size_t k = 0; k < state.size(); ++k)
        if (state.x[2][k] > 0.5 * tail * t_end && state.x[2][k] < 0.7 * shock * t_end)
          {
            p += eos.pressure(state.mu[k]);
            u += state.v[2][k];
            ++count;
          }
      std::printf("  %-10s p* %+.2f %%, u* %+.2f %%\n", law, 100. * (p / count / p_star - 1.),
                  100. * (u / count / u_star - 1.));
      record(std::string(law) + " p*", p / count);
      record(std::string(law) + " u*", u / count);
      EXPECT_NEAR(p / count, p_star, 0.02 * p_star) << law;
      EXPECT_NEAR(u / count, u_star, 0.02 * u_star) << law;
    }
}
