#include "solid_harness.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace solid_cycle_test
{
  using namespace solid_harness;

  // Elastic bricks at strains of some per cent neither make energy nor lose it: closed cycles of strain, undamped
  // motion.
  namespace
  {
    constexpr SolidFormulation formulations[] = {SolidFormulation::one_point, SolidFormulation::b_bar,
                                                 SolidFormulation::solid_shell};

    /// Displacement of a point of the unit cube, times an amplitude.
    using Field = std::function<Point3(const Point3 &)>;

    Point3 stretch(const Point3 &x)
    {
      return {x[0], 0., 0.};
    }
    Point3 shear(const Point3 &x)
    {
      return {x[1], 0., 0.};
    }
    Point3 bend(const Point3 &x)
    {
      return {(x[0] - 0.5) * (x[2] - 0.5), 0., 0.};
    }
    Point3 twist(const Point3 &x)
    {
      return {0., (x[0] - 0.5) * (x[2] - 0.5), (0.5 - x[0]) * (x[1] - 0.5)};
    }

    struct Cycle
    {
      double work, largest; ///< of the nodal forces in all, and the most that was stored on the way (J)
    };
    /// Around a square: a to its amplitude, b to its own, a back, b back.
    Cycle run_cycle(const SolidFormulation formulation, const Field &a, const Field &b, const double amplitude)
    {
      Model     model(make_box({1, 1, 1}, Point3(1., 1., 1.)), make_section(70e9, 0.3, formulation));
      const int n = 400;
      Cycle     result{0., 0.};
      for (const auto &[field, sign] : std::vector<std::pair<Field, double>>{{a, 1.}, {b, 1.}, {a, -1.}, {b, -1.}})
        for (int i = 0; i < n; ++i)
          {
            Eigen::VectorXd u(24);
            for (Eigen::Index k = 0; k < 8; ++k)
              u.segment<3>(3 * k) = sign * amplitude / n * field(model.mesh.nodes[std::size_t(k)]);
            model.move(u);
            result.largest =
              std::max(result.largest, model.elements.elastic_energy() + model.elements.hourglass_energy());
          }
      result.work = model.elements.work();
      return result;
    }
  } // namespace

  // What is left in the brick is the energy of the stress that Jaumann's rate leaves behind: of order strain^6 for what
  // has a gradient at every point, strain^4 for the stabilisation; never a gain, for the power is the rate of that
  // energy. At 5 and 10 % measured over the most stored: 7e-7 and 1e-5; 1.8e-4 and 7.2e-4. Cauchy's stress with the
  // same rate and moduli made or lost up to 1.1e-2 and 2.2e-2.
  TEST(SolidCycle, AClosedCycleDoesNoNetWork)
  {
    for (const auto formulation : formulations)
      for (const auto &[a, b] : std::vector<std::pair<Field, Field>>{
             {stretch, shear}, {stretch, bend}, {shear, bend}, {shear, twist}, {stretch, twist}, {bend, twist}})
        for (const double amplitude : {0.05, 0.1})
          for (const bool reversed : {false, true})
            {
              const Cycle cycle =
                reversed ? run_cycle(formulation, b, a, amplitude) : run_cycle(formulation, a, b, amplitude);
              EXPECT_GT(cycle.work / cycle.largest, -1e-8) << "made by a rule of second order in the step";
              EXPECT_LT(cycle.work / cycle.largest, formulation == SolidFormulation::b_bar
                                                      ? 0.15 * std::pow(amplitude, 4)
                                                      : 0.09 * std::pow(amplitude, 2));
            }
  }

  // Large bending and torsion of a cantilever, fifteen periods of its first mode. The error, 9e-4 and 4e-3 at these
  // steps, is that of kinetic energy at whole steps, a quarter with half the step. With Cauchy's stress energy grows
  // until steps collapse.
  TEST(SolidCycle, UndampedMotionKeepsItsEnergy)
  {
    constexpr int most_steps = 1000000; // where elements collapse, so does the step
    for (const auto formulation : formulations)
      for (const double scale : {0.3, 0.6})
        {
          Model  model(make_box({8, 2, 1}, Point3(8., 2., 1.)), make_section(1., 0.3, formulation));
          Motion motion(model);
          for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
            {
              const Point3 &x = model.mesh.nodes[n];
              for (std::size_t c = 0; c < 3; ++c)
                motion.held[3 * n + c] = x[0] == 0.;
              motion.velocity[Eigen::Index(3 * n + 2)] = 0.1 * std::pow(x[0] / 8., 2) * (1. + 0.5 * (x[1] - 1.));
            }
          const double initial = motion.kinetic_energy();
          double       time = 0., error = 0.;
          for (int i = 1; time < 6000. && error < 0.1 && i < most_steps; ++i)
            {
              const double dt = scale * model.elements.largest_stable_step();
              motion.step(dt);
              time += dt;
              if (const double now = std::abs(motion.total_energy() / initial - 1.); i % 200 == 0 && !(now <= error))
                error = now; // no number is no bound either
            }
          EXPECT_LT(error, 0.02 * scale * scale) << "scale " << scale << ", at " << time;
          EXPECT_GE(time, 6000.) << "scale " << scale;
        }
  }
} // namespace solid_cycle_test
