#include "shell_harness.h"

#include <gtest/gtest.h>

#include <random>

namespace shell_step_bound_test
{
  using namespace shell_harness;

  namespace
  {
    double bound(const Model &model)
    {
      const double dt = model.elements.step_limit().value;
      return 4. / (dt * dt);
    }

    Mesh unit_square(const unsigned int n)
    {
      return make_grid(n, n, [](const double x, const double y) { return Point3(x, y, 0.); });
    }
  } // namespace

  // The trap: the usual L/c is no bound for nu = 0 and thin shells, where transverse shear governs.
  TEST(ShellStepBound, IsExactForSquaresOfAnyPoissonRatio)
  {
    for (const auto formulation : covariant_formulations)
      for (const double poisson : {0., 0.3, 0.342, 0.45})
        for (const double thickness : {0.01, 0.1, 0.5})
          {
            Model model(unit_square(1), thickness, make_section(1., poisson, formulation));
            EXPECT_NEAR(bound(model) / exact_eigenvalue(model), 1., 1e-6) << poisson << " " << thickness;
          }
  }

  TEST(ShellStepBound, HoldsForDistortedAndWarpedElements)
  {
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> number(-1., 1.);
    for (const auto formulation : all_formulations)
      for (const double poisson : {0., 0.342})
        for (const double thickness : {0.01, 0.1, 0.5, 2.})
          for (int k = 0; k < 40; ++k)
            {
              Mesh         mesh   = unit_square(1);
              const double aspect = std::exp(1.5 * number(random));
              for (auto &x : mesh.nodes)
                {
                  x += Point3(0.3 * number(random), 0.3 * number(random), k % 2 * 0.2 * number(random));
                  x[0] *= aspect;
                }
              Model model(mesh, thickness, make_section(1., poisson, formulation));
              EXPECT_GE(bound(model) / exact_eigenvalue(model), 1. - 1e-6)
                << name_of(formulation) << ", sample " << k << ", nu " << poisson << ", t " << thickness;
            }
  }

  TEST(ShellStepBound, HoldsForAMeshAndIsClose)
  {
    const Mesh curved = make_grid(5, 5, [](const double x, const double y) {
      return Point3(x + 0.1 * y * y, y + 0.05 * std::sin(7. * x), 0.2 * x * y);
    });
    for (const auto formulation : covariant_formulations)
      {
        Model model(curved, 0.02, make_section(1., 0.3, formulation));
        EXPECT_GE(bound(model) / exact_eigenvalue(model), 1.);
        for (const double poisson : {0., 0.3})
          {
            Model        squares(unit_square(5), 0.02, make_section(1., poisson, formulation));
            const double ratio = bound(squares) / exact_eigenvalue(squares);
            EXPECT_GE(ratio, 1. - 1e-9);
            EXPECT_LT(ratio, 1.3)
              << "omega^2; assembly relaxes squares by 1.25 (nu = 0) and 1.27, one eighth of the step";
          }
      }
  }

  TEST(ShellStepBound, CountsTheMassesThatTheNodesCarry)
  {
    Model        model(unit_square(2), 0.1, make_section(1., 0.3));
    const double before = model.elements.step_limit().value;
    auto         mass   = model.elements.compute_nodal_masses();
    mass[4] *= 0.25;
    model.elements.use_nodal_masses(mass);
    EXPECT_NEAR(model.elements.step_limit().value, 0.5 * before, 1e-12);
  }

  // A roof, and the half of it that begins at the ridge.
  TEST(ShellStepBound, OfAHalfIsThatOfTheWhole)
  {
    for (const auto formulation : all_formulations)
      {
        const auto roof = [](const double x, const double y) { return Point3(x, y, -0.5 * std::abs(y)); };
        Model      whole(make_grid(4, 6, [&](double x, double y) { return roof(x, 2. * y - 1.); }), 0.1,
                         make_section(1., 0.3, formulation));
        Model      half(make_grid(4, 3, roof), 0.1, make_section(1., 0.3, formulation));
        EXPECT_GT(half.elements.largest_stable_step(), 1.01 * whole.elements.largest_stable_step());
        half.elements.add_symmetry_plane(std::vector<std::uint32_t>{0, 1, 2, 3, 4}, Point3::UnitY());
        EXPECT_NEAR(half.elements.largest_stable_step() / whole.elements.largest_stable_step(), 1., 1e-12);
      }
  }

  TEST(ShellStepBound, IsTheSameWithAndWithoutWords)
  {
    // a mesh of more than one chunk of batches, moved, so that the largest value is somewhere inside
    Model model(make_grid(40, 30, [](const double x, const double y) { return Point3(x, y * (1. + 0.2 * x), 0.); }),
                0.02, make_section(1., 0.3));
    EXPECT_EQ(model.elements.largest_stable_step(), model.elements.step_limit().value);
    Eigen::VectorXd u(model.n_dofs());
    for (Eigen::Index d = 0; d < u.size(); ++d)
      u[d] = 1e-3 * std::sin(1.7 * d);
    model.move(u);
    EXPECT_EQ(model.elements.largest_stable_step(), model.elements.step_limit().value);
  }
} // namespace shell_step_bound_test
