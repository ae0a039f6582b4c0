#include "shell_harness.h"
#include "solid_harness.h"

#include <birdstrike/material/elasticity.h>

#include <gtest/gtest.h>

namespace stored_energy_test
{
  // Stored and plastic energies of uniform states against closed forms, shells and bricks alike.

  using namespace birdstrike;

  namespace
  {
    constexpr double E = 113.8e9, nu = 0.342, strain = 1e-4;

    constexpr SolidFormulation solids[] = {SolidFormulation::one_point, SolidFormulation::b_bar,
                                           SolidFormulation::solid_shell};

    shell_harness::Mesh sheet()
    {
      return shell_harness::make_grid(3, 2,
                                      [](const double x, const double y) { return Point3(0.3 * x, 0.1 * y, 0.); });
    }
  } // namespace

  TEST(StoredEnergy, OfAStretchedShellIsThatOfPlaneStress)
  {
    const double t = 0.004, volume = 0.3 * 0.1 * t;
    for (const auto formulation : shell_harness::all_formulations)
      {
        shell_harness::Model model(sheet(), t, shell_harness::make_section(E, nu, formulation));
        Eigen::VectorXd      u = Eigen::VectorXd::Zero(model.n_dofs());
        for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
          u[6 * n] = strain * model.mesh.nodes[n][0]; // no strain across
        model.move(u);
        const double exact = 0.5 * E / (1. - nu * nu) * strain * strain * volume;
        EXPECT_NEAR(model.elements.elastic_energy() / exact, 1., 3. * strain) << "the volume has grown";
        EXPECT_NEAR(model.elements.work() / exact, 1., 3. * strain);
      }
  }

  TEST(StoredEnergy, OfABentShellIsThatOfItsCurvature)
  {
    const double t = 0.004, curvature = 1e-3, volume = 0.3 * 0.1 * t;
    for (const auto formulation : shell_harness::all_formulations)
      {
        shell_harness::Model model(sheet(), t, shell_harness::make_section(E, nu, formulation));
        Eigen::VectorXd      u = Eigen::VectorXd::Zero(model.n_dofs());
        for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
          {
            const double x = model.mesh.nodes[n][0];
            u[6 * n + 2]   = -0.5 * curvature * x * x;
            u[6 * n + 4]   = curvature * x;
          }
        for (int i = 0; i < 10; ++i)
          model.move(0.1 * u);
        const double exact = 0.5 * E / (1. - nu * nu) * curvature * curvature * t * t / 12. * volume;
        EXPECT_NEAR((model.elements.elastic_energy() + model.elements.hourglass_energy()) / exact, 1., 1e-3)
          << "deflections of a hundredth of the thickness stretch the sheet a little";
      }
  }

  TEST(StoredEnergy, OfABrickIsThatOfItsStress)
  {
    for (const auto formulation : solids)
      {
        solid_harness::Model model(solid_harness::make_box({2, 2, 1}, Point3(0.2, 0.1, 0.05)),
                                   solid_harness::make_section(E, nu, formulation));
        Eigen::VectorXd      u = Eigen::VectorXd::Zero(model.n_dofs());
        for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
          {
            const Point3 &x = model.mesh.nodes[n];
            u[3 * n]        = strain * x[0];
            u[3 * n + 1]    = 2. * strain * x[2]; // shear as well
          }
        model.move(u);
        const double lambda = E * nu / ((1. + nu) * (1. - 2. * nu)), G = E / (2. * (1. + nu));
        const double exact = (0.5 * (lambda + 2. * G) + 0.5 * G * 4.) * strain * strain * 0.2 * 0.1 * 0.05;
        EXPECT_NEAR(model.elements.elastic_energy() / exact, 1., 5. * strain);
        EXPECT_NEAR(model.elements.hourglass_energy() / exact, 0., 1e-12) << "a linear field moves no mode";
      }
  }

  // Stretched to five times the yield strain, held across, nu = 0: plane flow ends at s_x = 2/sqrt(3) s, s_y = s_x/2,
  // which stores (s_x^2 + s_y^2)/(2 E) = 5/3 s^2/(2 E); all other work is plastic.
  TEST(StoredEnergy, OfAShellThatFlowsIsThatOfPlaneFlow)
  {
    const double yield = 500e6, t = 0.004, end = 5. * yield / E, volume = 0.3 * 0.1 * t;
    for (const auto formulation : shell_harness::all_formulations)
      {
        ShellSection section = shell_harness::make_section(E, 0., formulation); // uniaxial without contraction
        section.material.hardening.law   = HardeningLaw::perfect;
        section.material.hardening.yield = yield;
        shell_harness::Model model(sheet(), t, section);
        const auto           stretch = [&](const double by, const int n) {
          for (int i = 0; i < n; ++i)
            {
              Eigen::VectorXd u = Eigen::VectorXd::Zero(model.n_dofs());
              for (std::size_t k = 0; k < model.mesh.nodes.size(); ++k)
                u[6 * k] = by / n * model.mesh.nodes[k][0];
              model.move(u);
            }
        };
        stretch(end, 200);
        EXPECT_GT(model.elements.plastic_work(), 0.);
        const double full = model.elements.elastic_energy();
        EXPECT_NEAR(full / (5. / 6. * yield * yield / E * volume), 1., 0.02) << "reached to 0.3 %, and 2 % of stretch";
        const double work = model.elements.work();
        EXPECT_NEAR((full + model.elements.plastic_work()) / work, 1., 2e-3)
          << "trapezoids of the corner, 1/200 of the way";
        EXPECT_LE(model.elements.hourglass_energy(), 1e-12 * work);
      }
  }

  // Rubber pulled to twice its length, sheared and let go in part: what its stress stores is the work done, on every
  // path (with a density by the present volume instead, of the order of its strain: a fifth).
  TEST(StoredEnergy, OfRubberIsTheWorkDoneOnIt)
  {
    constexpr int n_steps = 400;
    for (const auto formulation : shell_harness::all_formulations)
      for (const double poisson : {0., 0.3, 0.45})
        {
          shell_harness::Model model(sheet(), 0.004, shell_harness::make_section(1e7, poisson, formulation));
          for (int i = 0; i < 2 * n_steps; ++i)
            {
              const double    stretch = i < n_steps ? 0.7 / n_steps : -0.2 / n_steps, shear = 0.5 / n_steps;
              Eigen::VectorXd u = Eigen::VectorXd::Zero(model.n_dofs());
              for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
                {
                  const Point3 x(&model.position[3 * n]);
                  u[6 * n]     = stretch * x[0] + (i < n_steps ? shear : 0.) * x[1];
                  u[6 * n + 1] = 0.5 * stretch * x[1];
                }
              model.move(u);
            }
          const double stored = model.elements.elastic_energy() + model.elements.hourglass_energy();
          EXPECT_NEAR(stored / model.elements.work(), 1., 3e-3) << int(formulation) << " " << poisson;
        }
  }
} // namespace stored_energy_test
