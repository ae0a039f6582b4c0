#include "../record.h"
#include "solid_harness.h"

#include <gtest/gtest.h>

namespace solid_wave_test
{
  using namespace solid_harness;

  /// Waves along a bar of bricks (benchmark B2): 0.3 m of titanium with nu = 0, where the bar, the plate and the space
  /// have the same wave speed and every section moves alone.
  namespace
  {
    constexpr double young = 113.8e9, density = 4430., length = 0.3;
    const double     wave_speed = std::sqrt(young / density); // 5068.381 m/s

    const auto formulations = {SolidFormulation::one_point, SolidFormulation::b_bar};

    SolidSection bar_section(const SolidFormulation formulation)
    {
      SolidSection section     = make_section(young, 0., formulation);
      section.material.density = density;
      return section;
    }

    /// n cubes in a row along x.
    Mesh make_bar(const unsigned int n)
    {
      return make_box({n, 1, 1}, Point3(length, length / n, length / n));
    }

    /// Lateral components, and those of the ends that are asked for: what is left is one-dimensional.
    std::vector<bool> hold_laterally(const Mesh &mesh, const bool at_start, const bool at_end)
    {
      std::vector<bool> held(3 * mesh.nodes.size(), true);
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        {
          const double x = mesh.nodes[n][0];
          held[3 * n]    = (at_start && x < 1e-9) || (at_end && x > length - 1e-9);
        }
      return held;
    }

    /// omega of lumped linear elements for a wave number k (1/m): the dispersion of the mesh alone.
    double semi_discrete_frequency(const double k, const double h)
    {
      return 2. * wave_speed / h * std::sin(0.5 * k * h);
    }
  } // namespace

  // At a Courant number of 1 lumped linear elements and central differences pass d'Alembert's solution from node to
  // node: the bar strikes, is at rest under rho c v when the wave arrives at its free end, and flies off as it came,
  // exactly. Strains of 2e-12, so that nothing is left of finite deformation: a brick that is stiffer by e leaves the
  // limit of stability by the root of e.
  TEST(SolidWave, IsExactAtACourantNumberOfOne)
  {
    for (const auto formulation : formulations)
      {
        const unsigned int n = 50;
        const double       v = 1e-8, h = length / n, dt = h / wave_speed;
        Model              model(make_bar(n), bar_section(formulation));
        Motion             motion(model);
        motion.held = hold_laterally(model.mesh, true, false);
        for (std::size_t d = 0; d < model.n_dofs(); d += 3)
          motion.velocity[d] = -v;
        EXPECT_NEAR(dt / model.elements.largest_stable_step(), 1., 1e-6) << "the bound is sharp for nu = 0";
        for (unsigned int i = 0; i < n; ++i)
          motion.step(dt);
        for (std::size_t e = 0; e < n; ++e)
          EXPECT_NEAR(model.elements.state(e).stress[0] / (density * wave_speed * v), -1., 1e-8) << "brick " << e;
        for (unsigned int i = 0; i < n; ++i)
          motion.step(dt);
        for (std::size_t e = 0; e < n; ++e)
          EXPECT_NEAR(model.elements.state(e).stress[0] / (density * wave_speed * v), 0., 1e-8) << "brick " << e;
        for (std::size_t d = 0; d < model.n_dofs(); d += 3)
          EXPECT_NEAR(motion.velocity[d] / v, motion.held[d] ? 0. : 1., 1e-8) << "node " << d / 3;
      }
  }

  // 10 m/s, 300 bricks, bulk viscosity as by default, a wall that can only push: contact lasts 2 L/c = 118.381 us (to
  // where the middle of the front is back) and the bar leaves as it came, less what the viscosity takes of the front,
  // which is some bricks wide: measured 0.9985 of the time, 0.991 of the impulse, 0.984 of the speed.
  TEST(SolidWave, ABarRebounds)
  {
    for (const auto formulation : formulations)
      {
        SolidSection section        = bar_section(formulation);
        section.linear_viscosity    = 0.06;
        section.quadratic_viscosity = 1.2;
        Model             model(make_bar(300), section);
        Motion            motion(model);
        std::vector<bool> is_wall(model.n_dofs());
        double            mass = 0.;
        for (std::size_t d = 0; d < model.n_dofs(); d += 3)
          {
            is_wall[d]         = model.mesh.nodes[d / 3][0] == 0.;
            motion.velocity[d] = -10.;
            mass += motion.mass[d / 3];
          }
        motion.held          = is_wall; // these nodes stop at once
        const double initial = motion.kinetic_energy();
        double       time = 0., contact_end = 0., impulse = 0.;
        while (time < 140e-6)
          {
            double reaction = 0.;
            for (std::size_t d = 0; d < model.n_dofs(); d += 3)
              if (is_wall[d])
                {
                  motion.held[d] = model.position[d] <= 0. && motion.force[d] <= 0.;
                  reaction -= motion.held[d] ? motion.force[d] : 0.;
                }
            if (reaction > 0.)
              contact_end = time;
            const double dt = 0.9 * model.elements.largest_stable_step();
            impulse += reaction * dt;
            motion.step(dt);
            time += dt;
          }
        double velocity = 0.;
        for (std::size_t d = 0; d < model.n_dofs(); d += 3)
          velocity += motion.velocity[d] * motion.mass[d / 3] / mass;
        record("contact " + std::to_string(int(formulation)), contact_end);
        record("rebound " + std::to_string(int(formulation)), velocity);
        EXPECT_NEAR(contact_end / 118.381e-6, 1., 0.01);
        EXPECT_NEAR(impulse / (2. * mass * 10.), 1., 0.01);
        EXPECT_NEAR(velocity / 10., 1., 0.02);
        EXPECT_NEAR(motion.total_energy() / initial, 1., 1e-4);
      }
  }

  // Fixed-free: 4223.65, 12670.95, 21118.26 Hz. The modes of the mesh are those of a chain of masses, to round-off;
  // with 40 bricks their sines are within 0.2 % of the continuum's lines in the fifth quarter wave.
  TEST(SolidWave, AFixedBarHasTheFrequenciesOfAChain)
  {
    const double exact[3] = {4223.65, 12670.95, 21118.26};
    for (const auto formulation : formulations)
      {
        const unsigned int n = 40;
        Model              model(make_bar(n), bar_section(formulation));
        const auto         found = model.compute_frequencies(hold_laterally(model.mesh, true, false), 12);
        // the four chains of a section swing together, or against one another, stiffened by shear
        for (unsigned int k = 0; k < 3; ++k)
          {
            const double number = (k + 0.5) * M_PI / length;
            const double chain  = semi_discrete_frequency(number, length / n) / (2. * M_PI);
            const auto   near   = *std::min_element(found.begin(), found.end(), [&](const double a, const double b) {
              return std::abs(a - chain) < std::abs(b - chain);
            });
            EXPECT_NEAR(near / chain, 1., 1e-9);
            EXPECT_NEAR(near / exact[k], 1., 2e-3);
          }
      }
  }

  // Phase speed over c of lumped linear elements and central differences, sin(w dt/2) = C sin(k h/2), at k h/pi = .1,
  // .2, .3, .5: standing waves between two fixed ends, cos(w dt) from three displacements in a row.
  TEST(SolidWave, HasTheDispersionOfTheScheme)
  {
    struct Case
    {
      double courant, ratio[4];
    };
    for (const Case &c : {Case{0.9, {.99921, .99678, .99244, .97589}}, Case{0.5, {.99691, .98759, .97187, .92021}}})
      for (const auto formulation : formulations)
        for (const int i : {0, 1, 2, 3})
          {
            const unsigned int n = 10, half_waves = std::array{1, 2, 3, 5}[i];
            const double       number = half_waves * M_PI / length, dt = c.courant * length / n / wave_speed;
            Model              model(make_bar(n), bar_section(formulation));
            Motion             motion(model);
            motion.held = hold_laterally(model.mesh, true, true);
            Eigen::VectorXd shape(model.n_dofs());
            for (std::size_t d = 0; d < model.n_dofs(); ++d)
              shape[d] = motion.held[d] ? 0. : std::sin(number * model.mesh.nodes[d / 3][0]);
            motion.velocity     = 1e-6 * shape;
            double amplitude[3] = {}, products = 0., squares = 0.;
            for (int step = 0; step < 100; ++step)
              {
                motion.step(dt);
                amplitude[0] = amplitude[1];
                amplitude[1] = amplitude[2];
                amplitude[2] += motion.increment.dot(shape);
                products += amplitude[1] * (amplitude[0] + amplitude[2]);
                squares += 2. * amplitude[1] * amplitude[1];
              }
            const double frequency = std::acos(products / squares) / dt;
            EXPECT_NEAR(frequency / (number * wave_speed), c.ratio[i], 1e-5) << "C " << c.courant << ", mode " << i;
          }
  }

  // A load that appears at once: the free end goes twice as far as at rest, u_max = 2 p L/E after 2 L/c, and is back
  // after 4 L/c; exactly so at a Courant number of 1. At one half dispersion takes 0.6 % off the tip of the triangle.
  TEST(SolidWave, ASuddenLoadDoublesTheDeflection)
  {
    for (const auto formulation : formulations)
      for (const auto &[courant, tolerance] : {std::pair(1., 1e-6), {0.5, 0.01}})
        {
          const unsigned int n    = 100;
          const double       area = std::pow(length / n, 2), pressure = 1e3, dt = courant * length / n / wave_speed;
          Model              model(make_bar(n), bar_section(formulation));
          Motion             motion(model);
          motion.held          = hold_laterally(model.mesh, true, false);
          Eigen::VectorXd load = Eigen::VectorXd::Zero(model.n_dofs());
          for (std::size_t k = 0; k < model.mesh.nodes.size(); ++k)
            if (model.mesh.nodes[k][0] > length - 1e-9)
              load[3 * k] = 0.25 * pressure * area;
          double largest = 0., end = 0.;
          int    step_of_largest = 0;
          motion.force           = load;
          const int n_steps      = int(std::lround(4. * n / courant));
          for (int step = 1; step <= n_steps; ++step)
            {
              motion.step(dt);
              motion.force += load;
              end += motion.increment[3 * n];
              if (end > largest)
                {
                  largest         = end;
                  step_of_largest = step;
                }
            }
          EXPECT_NEAR(largest / (2. * pressure * length / young), 1., tolerance);
          EXPECT_NEAR(2. * step_of_largest / n_steps, 1., tolerance);
          EXPECT_NEAR(end / largest, 0., tolerance);
        }
  }
} // namespace solid_wave_test
