#include "../record.h"
#include "bird_case.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

using namespace birdstrike;
using namespace birdstrike::test;

/// Plane flows of a liquid with exact solutions: a drop in a central field, a square that spins, the vortex of Gresho.
/// Two dimensions are six layers that repeat themselves along z.
namespace
{
  BirdParameters plane_flow(const double spacing, const std::string &formulation)
  {
    BirdParameters parameters;
    parameters.density     = 1000.;
    parameters.spacing     = spacing;
    parameters.velocity    = {0., 0., 0.};
    parameters.aim_point   = {0., 0., 0.};
    parameters.is_periodic = {{false, false, true}};
    parameters.formulation = particle_formulations().at(formulation);
    parameters.alpha       = 0.05;
    parameters.beta        = 0.;
    return parameters;
  }

  EosParameters liquid(const double sound_speed)
  {
    EosParameters eos;
    eos.type         = EosType::linear;
    eos.bulk_modulus = 1000. * sound_speed * sound_speed;
    return eos;
  }

  double root_mean_square(const Particles &state, const int d)
  {
    double sum = 0.;
    for (const double x : state.x[d])
      sum += x * x;
    return std::sqrt(sum / state.size());
  }

  /// A step in the field -omega^2 (x, y), which acts as contact's forces do.
  void step_in_field(Bird &bird, const double dt, const double omega)
  {
    bird.kick(0.5 * dt, HalfKick::first);
    bird.drift(dt);
    bird.update_neighbor_list();
    const PointForces field = bird.clear_contact_forces();
    const Particles  &state = bird.state();
    for (std::size_t k = 0; k < state.size(); ++k)
      for (int d = 0; d < 2; ++d)
        field.component[d][k] += -omega * omega * state.mass * state.x[d][k];
    bird.compute_rates();
    bird.kick(0.5 * dt, HalfKick::second);
  }

  struct Oscillation
  {
    double period, largest_axis, loss; ///< s; over the radius; dissipated within a period, over the kinetic energy
  };

  /// A round drop of radius 1 m in the field, strained by (A x, -A y), for half a period; the second half is its mirror
  /// image with x and y exchanged.
  Oscillation oscillate(const double omega, const double strain_rate, const std::string &formulation)
  {
    constexpr double dx = 0.06, sound_speed = 1000.;
    BirdParameters   parameters   = plane_flow(dx, formulation);
    parameters.length_to_diameter = 3. * dx;
    parameters.mass               = parameters.density * std::numbers::pi * 6. * dx;
    ThreadPool pool(2);
    Bird       bird(parameters, liquid(sound_speed), pool);
    bird.set_state([&](Point3 &x, Point3 &v, double &mu) {
      const double r2 = x[0] * x[0] + x[1] * x[1];
      v               = Point3(strain_rate * x[0], -strain_rate * x[1], 0.);
      mu = 0.5 * (omega * omega + strain_rate * strain_rate) * std::max(0., 1. - r2) / (sound_speed * sound_speed);
    });
    const double radius = root_mean_square(bird.state(), 0), kinetic = bird.energies().kinetic;
    double       largest = 0., before = 0., t = 0.;
    while (t < 3. / omega)
      {
        const double dt = bird.step_limit().value;
        step_in_field(bird, dt, omega);
        t += dt;
        const double a = root_mean_square(bird.state(), 0) / radius, b = root_mean_square(bird.state(), 1) / radius;
        largest = std::max(largest, a);
        if (t > 1. / omega && a - b <= 0.)
          {
            const double half = t - dt * (b - a) / (b - a + before);
            return {2. * half, largest, 2. * bird.energies().dissipated / kinetic};
          }
        before = a - b;
      }
    ADD_FAILURE() << "it does not come back";
    return {0., 0., 0.};
  }
} // namespace

// Monaghan and Rafiee (2013): axes a' = s a, b' = -s b with s' = (s^2 + W^2)(b^2 - a^2)/(a^2 + b^2). The benchmark asks
// for 1 % of the period. With 17 particles across the radius the standard one is 1.2 % short at W = A, with 22 1.0 %:
// 2 % are given here, 3 % of the axis, which dissipation shortens.
TEST(Flow, ADropInACentralFieldOscillates)
{
  struct Case
  {
    double strain, period, axis; ///< over W, times W, over R
  };
  for (const char *formulation : {"riemann", "standard"})
    for (const Case &c : {Case{0.5, 4.56737, 1.414214}, Case{1., 4.82734, 1.931852}})
      {
        const double      omega = 50.;
        const Oscillation found = oscillate(omega, c.strain * omega, formulation);
        const std::string name  = std::string(formulation) + " " + (c.strain < 1. ? "0.5" : "1");
        record(name + " period", found.period * omega);
        record(name + " axis", found.largest_axis);
        record(name + " loss", found.loss);
        EXPECT_NEAR(found.period * omega / c.period, 1., 0.02) << name;
        EXPECT_NEAR(found.largest_axis / c.axis, 1., 0.03) << name;
      }
}

// A square that spins is in tension (p = -0.147 rho w^2 L^2 in the middle, Colagrossi 2005): with pressures that end at
// zero it flies apart, every particle on its straight line, so that mean squares of distances grow by 1 + w^2 t^2. No
// pair approaches, nothing may act: round-off of a thousand steps.
TEST(Flow, ASpinningSquareFliesApart)
{
  constexpr double dx = 0.05, omega = 100.;
  for (const char *formulation : {"riemann", "standard"})
    {
      BirdParameters parameters = plane_flow(dx, formulation);
      parameters.shape          = BirdShape::slab;
      parameters.slab_lengths   = {1., 1., 6. * dx};
      ThreadPool pool(2);
      Bird       bird(parameters, liquid(1000.), pool);
      bird.set_state([&](Point3 &x, Point3 &v, double &) { v = Point3(-omega * x[1], omega * x[0], 0.); });
      const double radius = root_mean_square(bird.state(), 0), spin = bird.momenta().angular_momentum[2];
      const double kinetic = bird.energies().kinetic;
      advance(bird, 2. / omega);
      const double grown = root_mean_square(bird.state(), 0) / radius;
      record(std::string(formulation) + " size", grown);
      record(std::string(formulation) + " angular momentum", std::abs(bird.momenta().angular_momentum[2] / spin - 1.));
      EXPECT_NEAR(grown, std::sqrt(5.), 1e-9) << formulation;
      EXPECT_NEAR(bird.momenta().angular_momentum[2] / spin, 1., 1e-12) << formulation;
      EXPECT_NEAR(bird.energies().kinetic / kinetic, 1., 1e-12) << formulation;
    }
}

// Gresho and Chan (1990): a stationary vortex, u = 5 r up to r = 0.2, 2 - 5 r up to 0.4, under a pressure that holds
// it. Particles lose its corner first: published SPH has L1 errors of 0.1 to 0.2 at t = 1 with some 30 particles
// across, and with much viscosity nothing of it is left; so this test only asks that most of it is.
TEST(Flow, GreshosVortexStands)
{
  constexpr int    n  = 20;
  constexpr double dx = 1. / n, sound_speed = 30.;
  const auto       speed    = [](const double r) { return r < 0.2 ? 5. * r : std::max(0., 2. - 5. * r); };
  const auto       pressure = [](const double r) {
    if (r < 0.2)
      return 5. + 12.5 * r * r;
    return r < 0.4 ? 9. + 12.5 * r * r - 20. * r + 4. * std::log(5. * r) : 3. + 4. * std::log(2.);
  };
  for (const auto &[formulation, least] : {std::pair("riemann", 0.6), {"linear", 0.8}, {"standard", 0.15}})
    {
      const bool     is_linear  = std::string(formulation) == "linear";
      BirdParameters parameters = plane_flow(dx, is_linear ? "riemann" : formulation);
      parameters.shape          = BirdShape::slab;
      parameters.slab_lengths   = {1., 1., 6. * dx};
      parameters.is_periodic    = {{true, true, true}};
      parameters.reconstruction = is_linear ? Reconstruction::linear : Reconstruction::none;
      ThreadPool pool(2);
      Bird       bird(parameters, liquid(sound_speed), pool);
      bird.set_state([&](Point3 &x, Point3 &v, double &mu) {
        const double r = std::hypot(x[0], x[1]), u = r > 0. ? speed(r) / r : 0.;
        v  = Point3(-u * x[1], u * x[0], 0.);
        mu = pressure(r) / (sound_speed * sound_speed); // over a density of one
      });
      const double kinetic = bird.energies().kinetic;
      advance(bird, 1.);
      const Particles &state = bird.state();
      double           error = 0., size = 0.;
      for (std::size_t k = 0; k < state.size(); ++k)
        {
          const double x = state.x[0][k] - std::round(state.x[0][k]), y = state.x[1][k] - std::round(state.x[1][k]);
          const double r = std::hypot(x, y), u = (x * state.v[1][k] - y * state.v[0][k]) / r;
          error += std::abs(u - speed(r));
          size += speed(r);
        }
      record(std::string(formulation) + " L1", error / size);
      record(std::string(formulation) + " kinetic", bird.energies().kinetic / kinetic);
      std::printf("  %-8s L1 %.3f, kinetic energy left %.3f\n", formulation, error / size,
                  bird.energies().kinetic / kinetic);
      EXPECT_LT(bird.energies().kinetic, kinetic) << formulation;
      EXPECT_GT(bird.energies().kinetic, least * kinetic) << formulation;
    }
}
