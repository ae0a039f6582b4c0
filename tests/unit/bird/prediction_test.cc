#include "bird_case.h"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

using namespace birdstrike;
using namespace birdstrike::test;

namespace
{
  constexpr double speed = 100.; // m/s

  struct Outcome
  {
    double        made;     ///< energy stored and dissipated beyond the work done, over what the bird brought
    double        expected; ///< by the sum of the errors of prediction, over the same
    unsigned long n_second;
    int           n_steps;
  };

  /// Ten layers at 100 m/s meet a wall of their own impedance: rho c v on the foremost layer from the first step on,
  /// for the time that the shock needs through three quarters of the column.
  Outcome strike_wall(const std::string &law, const double closing_speed)
  {
    EosParameters eos_parameters;
    eos_parameters.type       = eos_types().at(law);
    BirdParameters parameters = column(10, 8e-3);
    parameters.velocity       = {0., 0., speed};
    ThreadPool            pool(2);
    const EquationOfState eos(eos_parameters, parameters.density);
    Bird                  bird(parameters, eos_parameters, pool);
    bird.set_closing_speed(closing_speed);

    const double      energy = bird.energies().total(), t_end = 0.75 * 10. * 8e-3 / eos.reference_sound_speed();
    const double      front = *std::max_element(bird.state().x[2].begin(), bird.state().x[2].end());
    const double      area = parameters.spacing * parameters.spacing, dt = bird.shocked_step(speed);
    std::vector<char> is_foremost(bird.state().size());
    for (std::size_t p = 0; p < is_foremost.size(); ++p)
      is_foremost[bird.state().id[p]] = bird.state().x[2][p] > front - 0.5 * parameters.spacing;

    Outcome outcome{0., 0., 0, 0};
    for (double t = 0.; t < t_end; t += dt, ++outcome.n_steps)
      {
        bird.kick(0.5 * dt, HalfKick::first);
        bird.drift(dt);
        bird.update_neighbor_list();
        const PointForces forces = bird.clear_contact_forces();
        const PointsView  view   = bird.points();
        for (std::size_t p = 0; p < view.n; ++p)
          if (is_foremost[view.id[p]])
            forces.component[2][p] = -parameters.density * eos.reference_sound_speed() * view.velocity[2][p] * area;
        bird.compute_rates();
        bird.kick(0.5 * dt, HalfKick::second);
        const auto &error = bird.state().prediction_error;
        outcome.expected += std::accumulate(error.begin(), error.end(), 0.) / energy;
      }
    const Particles &state = bird.state();
    for (std::size_t p = 0; p < state.size(); ++p) // and what later steps would give back
      {
        const double f = std::hypot(state.force[0][p], state.force[1][p], state.force[2][p]);
        const double r = state.sound_speed[p] * state.compression_rate[p];
        outcome.expected += 0.25 * dt * dt * (f * f / state.mass + state.mass * r * r) / energy;
      }
    const EnergyReport report = bird.energies();
    outcome.made              = (report.elastic + report.dissipated - report.internal) / energy;
    outcome.n_second          = bird.n_second_evaluations();
    return outcome;
  }
} // namespace

// A bird that closes in with no speed has no measure for its errors and predicts once. What the predictions make is
// then what the bird makes: to a tenth where p is linear in mu, to a fifth where it is curved.
TEST(Prediction, IsWhatMakesEnergyInAShock)
{
  for (const auto &[law, tolerance] : {std::pair{"linear", 0.1}, {"murnaghan", 0.2}})
    {
      const Outcome once = strike_wall(law, 0.);
      std::printf("  %s: made %.4f, expected %.4f\n", law, once.made, once.expected);
      EXPECT_EQ(once.n_second, 0u);
      EXPECT_GT(once.made, 4e-3) << law;
      EXPECT_NEAR(once.expected / once.made, 1., tolerance) << law;
    }
}

TEST(Prediction, IsRepeatedInAShock)
{
  for (const char *law : {"linear", "murnaghan"})
    {
      const Outcome again = strike_wall(law, speed);
      std::printf("  %s: made %.4f in %d steps, %lu of them evaluated twice\n", law, again.made, again.n_steps,
                  again.n_second);
      EXPECT_LT(std::abs(again.made), 3e-3) << law;
      EXPECT_GT(again.n_second, 0u);
    }
}

// An acoustic wave of 2 m/s in a bird that meets a blade at 100 m/s: no step needs to be evaluated twice.
TEST(Prediction, IsNotRepeatedInSmoothMotion)
{
  const double spacing = 1e-3, length = 60. * spacing;
  ThreadPool   pool(2);
  Bird         bird(column(60, spacing), EosParameters(), pool);
  bird.set_closing_speed(speed);
  bird.set_state([&](Point3 &x, Point3 &v, double &) { v = Point3(0., 0., 2. * std::sin(6.2832 * x[2] / length)); });
  EXPECT_GT(advance(bird, 30e-6), 50);
  EXPECT_EQ(bird.n_second_evaluations(), 0u);
}
