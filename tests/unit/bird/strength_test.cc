#include "../record.h"
#include "bird/kernel.h"
#include "bird/strength.h"
#include "bird_case.h"
#include <birdstrike/core/errors.h>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

using namespace birdstrike;
using namespace birdstrike::test;

namespace
{
  constexpr double density = 950.;

  Strength make_strength(const double shear_modulus, const double yield_stress)
  {
    BirdParameters parameters;
    parameters.shear_modulus = shear_modulus;
    parameters.yield_stress  = yield_stress;
    return Strength(parameters);
  }

  double norm(const std::array<double, 6> &s)
  {
    return std::sqrt(contract(s, s));
  }

  /// Wave number that lattice sums of corrected gradients see in a wave along an axis of a cubic lattice of spacing 1:
  /// sum w z sin(k z)/sum w z^2.
  double lattice_wave_number(const double smoothing_ratio, const double k)
  {
    const int n    = static_cast<int>(2. * smoothing_ratio) + 1;
    double    seen = 0., moment = 0.;
    for (int x = -n; x <= n; ++x)
      for (int y = -n; y <= n; ++y)
        for (int z = -n; z <= n; ++z)
          {
            const double t = std::max(0., 1. - std::sqrt(double(x * x + y * y + z * z)) / (2. * smoothing_ratio));
            seen += t * t * t * z * std::sin(k * z);
            moment += t * t * t * z * z;
          }
    return seen / moment;
  }

  /// Extreme values of the stress over the particles within `reach` of the origin.
  struct Middle
  {
    double largest_norm = 0., smallest_shear = 1e300, largest_shear = -1e300; ///< Pa, undeformed; xz
  };

  Middle look_at_middle(const Particles &state, const double reach)
  {
    Middle middle;
    for (std::size_t p = 0; p < state.size(); ++p)
      {
        std::array<double, 6> s;
        for (int k = 0; k < 6; ++k)
          s[k] = state.stress[k][p];
        middle.largest_norm = std::max(middle.largest_norm, norm(s));
        if (std::hypot(state.x[0][p], state.x[1][p], state.x[2][p]) > reach)
          continue;
        middle.smallest_shear = std::min(middle.smallest_shear, s[4]);
        middle.largest_shear  = std::max(middle.largest_shear, s[4]);
      }
    return middle;
  }

  BirdParameters block(const double edge, const double spacing)
  {
    BirdParameters parameters;
    parameters.shape        = BirdShape::slab;
    parameters.slab_lengths = {edge, edge, edge};
    parameters.spacing      = spacing;
    parameters.velocity     = {0., 0., 0.};
    parameters.aim_point    = {0., 0., 0.};
    return parameters;
  }
} // namespace

// Simple shear at the rate r: tau = G r t up to Y/sqrt(3), then flow; all work that is not stored is dissipated.
TEST(Strength, ShearAtAConstantRateReachesYieldOverRootThree)
{
  const double          G = 5e6, Y = 2e4, rate = 100., dt = 1e-7;
  const Strength        strength = make_strength(G, Y);
  const double          t_yield  = Y / std::sqrt(3.) / (G * rate);
  std::array<double, 6> s{};
  double                dissipated = 0., work = 0.;
  for (double t = 0.; t < 3. * t_yield; t += dt)
    {
      const double before = s[4];
      const auto   step   = advance<double>(strength, s, {0., 0., 0., 0., 0.5 * rate, 0.}, {0., 0., 0.}, 0., dt);
      s                   = step.stress;
      dissipated += step.dissipated;
      work += 0.5 * (before + s[4]) * rate * dt;
      EXPECT_NEAR(s[4], std::min(G * rate * (t + dt), Y / std::sqrt(3.)), 1e-9 * Y);
    }
  EXPECT_NEAR(s[4], Y / std::sqrt(3.), 1e-9 * Y);
  EXPECT_NEAR(dissipated + contract(s, s) / (4. * G), work, 1e-9 * work);
  EXPECT_GT(dissipated, 0.5 * work);
}

// A turn by 90 degrees in one step, and by a hundred small ones, of a stress that nothing strains: the stress of a
// turned body, to the second order of the turn of a step, and of the same norm to round-off.
TEST(Strength, TurnsWithTheBodyAndStoresNothing)
{
  const Strength              strength = make_strength(5e6, 1e9);
  const std::array<double, 6> start{2e4, -3e4, 1e4, 1.5e4, -7e3, 4e3};
  std::array<double, 6>       s = start;
  for (int k = 0; k < 100; ++k)
    {
      const auto step = advance<double>(strength, s, {}, {0., 0., 0.5 * std::numbers::pi / 100.}, 0., 1.);
      s               = step.stress;
      EXPECT_EQ(step.dissipated, 0.);
    }
  const std::array<double, 6> turned{start[1], start[0], start[2], -start[3], -start[5], start[4]};
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(s[k], turned[k], 1e-4 * norm(start)) << k;
  EXPECT_NEAR(norm(s) / norm(start), 1., 1e-13);
}

TEST(Strength, YieldsByCauchysStressAndComesApart)
{
  const Strength              strength = make_strength(5e6, 2e4);
  const std::array<double, 6> rate{1e3, -400., 2e3, 300., -100., 50.};
  for (const double mu : {-0.005, 0., 0.3})
    {
      const auto step = advance<double>(strength, {}, rate, {}, mu, 1.);
      EXPECT_NEAR(norm(step.stress) * (1. + mu) * std::sqrt(1.5), 2e4, 1e-8) << mu;
      EXPECT_NEAR(step.stress[0] + step.stress[1] + step.stress[2], 0., 1e-9) << mu;
    }
  const std::array<double, 6> held{1e3, -2e3, 1e3, 0., 0., 0.};
  const auto                  apart = advance<double>(strength, held, {}, {}, -0.02, 1.);
  EXPECT_EQ(norm(apart.stress), 0.);
  EXPECT_NEAR(apart.dissipated, contract(held, held) / (4. * 5e6), 1e-15) << "what was stored";
  const Lanes          mu([](const auto k) { return -0.02 + 0.011 * k; });
  std::array<Lanes, 6> rates;
  for (int k = 0; k < 6; ++k)
    rates[k] = rate[k];
  const auto lanes = advance<Lanes>(strength, {}, rates, {Lanes(0.1), Lanes(-0.2), Lanes(0.3)}, mu, 1e-3);
  for (std::size_t l = 0; l < n_lanes; ++l)
    {
      const double m    = mu[l];
      const auto   each = advance<double>(strength, {}, rate, {0.1, -0.2, 0.3}, m, 1e-3);
      EXPECT_NEAR(lanes.stress[4][l], each.stress[4], 1e-9);
      EXPECT_NEAR(lanes.dissipated[l], each.dissipated, 1e-9);
    }
}

// v_x = A cos(k z): a transverse wave at rest in space, w = sqrt(G/rho) k as the lattice sees k (0.6 % less than k at
// 32 particles a wave). It is neither damped nor driven, and total energy stays.
TEST(Strength, StandingShearWaveHasItsFrequencyAndEnergy)
{
  for (const auto precision : {PairPrecision::as_double, PairPrecision::as_float})
    {
      constexpr int    n  = 32;
      constexpr double dx = 1e-3, G = 2e8, A = 0.1, k = 2. * std::numbers::pi / (n * dx);
      BirdParameters   parameters = column(n, dx);
      parameters.is_periodic      = {{true, true, true}};
      parameters.slab_lengths[0] = parameters.slab_lengths[1] = 8. * dx;
      parameters.density                                      = density;
      parameters.shear_modulus                                = G;
      parameters.yield_stress                                 = 1e12;
      parameters.tension_cutoff                               = false;
      parameters.courant_number                               = 0.2;
      parameters.pair_precision                               = precision;
      ThreadPool pool(2);
      Bird       bird(parameters, EosParameters(), pool);
      bird.set_state([&](Point3 &x, Point3 &v, double &) { v = Point3(A * std::cos(k * x[2]), 0., 0.); });
      const auto amplitude = [&] {
        double sum = 0.;
        for (std::size_t p = 0; p < bird.state().size(); ++p)
          sum += bird.state().v[0][p] * std::cos(k * bird.state().x[2][p]);
        return 2. * sum / (A * bird.state().size());
      };
      const double seen  = lattice_wave_number(parameters.smoothing_ratio, k * dx) / dx;
      const double exact = std::sqrt(G / density) * seen, first = bird.energies().total();
      double       energy_error = 0., t = 0., before = 1., zero = 0., peak = 0.;
      int          n_zeros = 0;
      while (n_zeros < 8) // four periods
        {
          const double dt = bird.step_limit().value;
          step(bird, dt);
          t += dt;
          const double now = amplitude();
          if (now * before < 0.)
            {
              ++n_zeros;
              zero = t - dt * now / (now - before);
            }
          if (n_zeros >= 7)
            peak = std::max(peak, std::abs(now));
          before       = now;
          energy_error = std::max(energy_error, std::abs(bird.energies().total() / first - 1.));
        }
      const double      found = 7.5 * std::numbers::pi / zero; // the eighth zero of cos
      const std::string name  = precision == PairPrecision::as_double ? "double" : "float";
      std::printf(
        "  %-6s w/w_lattice %.5f, w/w_exact %.5f, amplitude after 4 periods %.4f, energy %.1e, momentum %.1e\n",
        name.c_str(), found / exact, found / (std::sqrt(G / density) * k), peak, energy_error,
        std::abs(bird.momenta().momentum[0]) / (A * density * 64. * n * dx * dx * dx));
      record(name + " frequency over exact", found / (std::sqrt(G / density) * k));
      record(name + " energy", energy_error);
      EXPECT_NEAR(found / exact, 1., 1e-3) << name;
      EXPECT_NEAR(found / (std::sqrt(G / density) * k), 1., 0.02) << name;
      EXPECT_NEAR(peak, 1., 0.01) << name;
      EXPECT_LT(energy_error, 1e-3) << name;
      EXPECT_LT(std::abs(bird.momenta().momentum[0]), 1e-12 * A) << name;
    }
}

// A free block that turns as a rigid body, an eighth of a turn: nothing strains it but its own centrifugal force, whose
// stress is of the order rho w^2 R^2. A strain of a thousandth of the turn would be ten times as much.
TEST(Strength, RigidRotationMakesNoStress)
{
  constexpr double G = 1e8, spin = 200., edge = 0.02;
  BirdParameters   parameters = block(edge, 2e-3);
  parameters.density          = density;
  parameters.shear_modulus    = G;
  parameters.yield_stress     = 1e12;
  parameters.tension_cutoff   = false;
  parameters.courant_number   = 0.2;
  ThreadPool pool(2);
  Bird       bird(parameters, EosParameters(), pool);
  bird.set_state([&](Point3 &x, Point3 &v, double &) { v = spin * Point3(0., 0., 1.).cross(x); });
  EXPECT_LT(look_at_middle(bird.state(), 0.).largest_norm, 1e-6 * G);
  const double moment = bird.momenta().angular_momentum[2], first = bird.energies().total();
  double       energy_error = 0.;
  advance(bird, 0.25 * std::numbers::pi / spin,
          [&] { energy_error = std::max(energy_error, std::abs(bird.energies().total() / first - 1.)); });
  const double largest  = look_at_middle(bird.state(), 0.).largest_norm,
               inertial = density * spin * spin * edge * edge / 2.;
  const double lost     = bird.momenta().angular_momentum[2] / moment - 1.;
  std::printf("  an eighth of a turn: |s| %.2e Pa, rho w^2 R^2 %.2e Pa, angular momentum %+.1e, energy %.1e\n", largest,
              inertial, lost, energy_error);
  record("stress over rho w^2 R^2", largest / inertial);
  record("angular momentum", lost);
  EXPECT_LT(largest, 2. * inertial);
  EXPECT_LT(std::abs(lost), 1e-3);
  EXPECT_LT(energy_error, 1e-3);
}

// A free block sheared as v_x = r z: before waves from its faces arrive, its middle carries G r t, then Y/sqrt(3) of
// the undeformed area, to the per cent.
TEST(Strength, BlockShearedAtAConstantRateFlowsAtYieldOverRootThree)
{
  constexpr double G = 5e6, Y = 2e4, rate = 200., edge = 0.03;
  BirdParameters   parameters = block(edge, 1.5e-3);
  parameters.density          = density;
  parameters.shear_modulus    = G;
  parameters.yield_stress     = Y;
  parameters.tension_cutoff   = false;
  parameters.courant_number   = 0.2;
  ThreadPool pool(2);
  Bird       bird(parameters, EosParameters(), pool);
  bird.set_state([&](Point3 &x, Point3 &v, double &) { v = Point3(rate * x[2], 0., 0.); });
  const double t_yield = Y / std::sqrt(3.) / (G * rate), first = bird.energies().total();
  double       energy_error = 0.;
  const auto   observe = [&] { energy_error = std::max(energy_error, std::abs(bird.energies().total() / first - 1.)); };
  advance(bird, 0.5 * t_yield, observe);
  const Middle elastic = look_at_middle(bird.state(), 3e-3);
  EXPECT_NEAR(elastic.smallest_shear, 0.5 * Y / std::sqrt(3.), 0.01 * Y);
  EXPECT_NEAR(elastic.largest_shear, 0.5 * Y / std::sqrt(3.), 0.01 * Y);
  advance(bird, t_yield, observe);
  const Middle plastic = look_at_middle(bird.state(), 3e-3);
  std::printf("  elastic %.4f to %.4f, plastic %.4f to %.4f of Y/sqrt(3); energy %.1e, momentum %.1e\n",
              elastic.smallest_shear / Y * std::sqrt(3.), elastic.largest_shear / Y * std::sqrt(3.),
              plastic.smallest_shear / Y * std::sqrt(3.), plastic.largest_shear / Y * std::sqrt(3.), energy_error,
              std::abs(bird.momenta().momentum[0]));
  EXPECT_NEAR(plastic.smallest_shear, Y / std::sqrt(3.), 0.01 * Y);
  EXPECT_NEAR(plastic.largest_shear, Y / std::sqrt(3.), 0.01 * Y);
  EXPECT_GT(bird.energies().dissipated, 0.);
  EXPECT_LT(energy_error, 1e-3);
  EXPECT_LT(std::abs(bird.momenta().momentum[0]), 1e-13 * density * edge * edge * edge * rate * edge);
}

TEST(Strength, RefusesWhatItIsNotWrittenFor)
{
  const auto refusal = [](const auto &spoil) -> std::string {
    BirdParameters parameters;
    parameters.shear_modulus = 1e7;
    parameters.yield_stress  = 1e5;
    spoil(parameters);
    try
      {
        parameters.check();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "accepted";
  };
  EXPECT_EQ(refusal([](BirdParameters &) {}), "accepted");
  EXPECT_NE(refusal([](BirdParameters &p) { p.shear_modulus = 0.; }).find("no Shear modulus"), std::string::npos);
  EXPECT_NE(refusal([](BirdParameters &p) { p.yield_stress = 0.; }).find("no Yield stress"), std::string::npos);
  EXPECT_NE(
    refusal([](BirdParameters &p) { p.formulation = ParticleFormulation::standard; }).find("standard formulation"),
    std::string::npos);
  EXPECT_NE(refusal([](BirdParameters &p) { p.gradient_correction = false; }).find("gradient correction"),
            std::string::npos);
}
