#include "../record.h"
#include "blade_case.h"
#include "laminate_case.h"

#include "structure/deformable_blade.h"
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

#include <random>

namespace laminate_step_test
{
  using namespace laminate_case;

  // The stable step of laminated shells, and steps of it.
  namespace
  {
    double bound(const Model &model)
    {
      const double dt = model.elements.step_limit().value;
      return 4. / (dt * dt);
    }

    const std::vector<std::vector<double>> stacks{{0.},        {30.},          {0., 90.},
                                                  {45., -45.}, {0., 30., 75.}, {0., 90., 90., 0.}};

    BladeParameters plate(const std::string &plies, const unsigned int n_span, const unsigned int n_chord)
    {
      BladeParameters p = test::elastic_plate(n_span, n_chord);
      p.laminate.plies  = plies;
      p.laminate.ply    = carbon();
      return p;
    }
  } // namespace

  // One element each, of any shape and thickness, with its fibres anywhere: never above the true step.
  TEST(LaminateStep, BoundHoldsForDistortedAndWarpedElements)
  {
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> number(-1., 1.);
    double                                 sum = 0., least = 1.;
    std::size_t                            n = 0;
    for (const auto formulation : all_formulations)
      for (const auto &angles : stacks)
        for (const double thickness : {0.01, 0.1, 0.5, 2.})
          for (int k = 0; k < 12; ++k)
            {
              Mesh         mesh   = make_grid(1, 1, [](const double x, const double y) { return Point3(x, y, 0.); });
              const double aspect = std::exp(1.5 * number(random));
              for (auto &x : mesh.nodes)
                {
                  x += k < 4 ? Point3(0., 0., 0.)
                             : Point3(0.3 * number(random), 0.3 * number(random), k % 2 * 0.2 * number(random));
                  x[0] *= aspect;
                }
              const double angle = number(random) * M_PI;
              Model        model(
                       mesh, thickness,
                       section_of(carbon(), equal_plies(angles), formulation, Point3(std::cos(angle), std::sin(angle), 0.)));
              const double ratio = std::sqrt(exact_eigenvalue(model) / bound(model));
              EXPECT_LE(ratio, 1. + 1e-6) << name_of(formulation) << ", sample " << k << ", t " << thickness;
              if (k < 4 && formulation != ShellFormulation::belytschko_tsay)
                {
                  sum += ratio;
                  least = std::min(least, ratio);
                  ++n;
                }
            }
    record("rectangles: step by the bound over the true one, mean", sum / n);
    record("least", least);
    EXPECT_GT(sum / n, 0.95);
    EXPECT_GT(least, 0.8);
  }

  // An assembled plate may take longer steps than its elements one by one, not by much.
  TEST(LaminateStep, BoundIsCloseOnAMesh)
  {
    for (const auto formulation : covariant_formulations)
      for (const auto &angles : stacks)
        {
          Model model(make_grid(6, 5, [](const double x, const double y) { return Point3(1.2 * x, y, 0.); }), 0.02,
                      section_of(carbon(), equal_plies(angles), formulation));
          const double ratio = std::sqrt(exact_eigenvalue(model) / bound(model));
          EXPECT_LE(ratio, 1. + 1e-9);
          EXPECT_GT(ratio, 0.8) << name_of(formulation) << angles[0];
        }
  }

  // Steps of the whole bound: the plate swings, and keeps its energy.
  TEST(LaminateStep, IsStableAtTheBound)
  {
    for (const ShellFormulation formulation : covariant_formulations)
      for (const char *plies : {"[0/90]", "[30/-50/80]", "[0_2/+-45]s"})
        {
          BladeParameters p        = plate(plies, 14, 5);
          p.element.formulation    = formulation;
          p.loads.initial_velocity = "0; 0; 30*(x/0.3112)^2 + 40*x*y";
          ThreadPool   pool;
          const auto   blade  = make_blade(p, pool);
          const double before = test::balance(*blade), dt = blade->step_limit().value;
          test::advance(*blade, dt, 2000);
          EXPECT_NEAR(test::balance(*blade) / before, 1., 3e-3) << name_of(formulation) << plies;
          EXPECT_LT(blade->energies().hourglass, 0.05 * before);
        }
  }

  // Stored energy is a function of the stresses: what moves the elements is what they store.
  TEST(LaminateStep, ThreadsGiveTheSameBits)
  {
    for (const ShellFormulation formulation : covariant_formulations)
      {
        BladeParameters p     = plate("[0/45/-30]", 14, 5);
        p.element.formulation = formulation;
        EXPECT_TRUE(test::is_bitwise_equal(test::shake<ShellBlade>(p, 1), test::shake<ShellBlade>(p, 4)));
      }
  }
} // namespace laminate_step_test
