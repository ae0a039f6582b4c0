#include "matrices.h"
#include "solid_harness.h"

#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <random>

namespace mass_scaling_bound_test
{
  using namespace solid_harness;

  namespace
  {
    /// v.M v of scaled elements, one component, as SolidElements::scale_masses says.
    Eigen::MatrixXd compute_scaled_mass(const Model &model, const std::vector<MassScale> &scale)
    {
      Eigen::MatrixXd M = Eigen::MatrixXd::Zero(model.mesh.nodes.size(), model.mesh.nodes.size());
      for (std::size_t e = 0; e < scale.size(); ++e)
        for (unsigned int a = 0; a < 8; ++a)
          if ((a >> scale[e].axis & 1) == 0)
            {
              const double m = model.elements.edge_mass(e), k = 0.5 * m * (scale[e].factor - 1.);
              const auto   i = model.mesh.cells[e][a], j = model.mesh.cells[e][a | 1u << scale[e].axis];
              M(i, i) += m + k;
              M(j, j) += m + k;
              M(i, j) -= k;
              M(j, i) -= k;
            }
      return M;
    }

    struct Steps
    {
      double exact, bound;
    };
    /// 2/omega_max by a dense eigenvalue solver, and the bound.
    Steps compute_steps(const Mesh &mesh, const SolidSection &section, const std::vector<MassScale> &scale)
    {
      Model model(mesh, section);
      model.elements.scale_masses(scale);
      const Eigen::MatrixXd K = model.compute_stiffness(), M = compute_scaled_mass(model, scale);
      Eigen::MatrixXd       M3 = Eigen::MatrixXd::Zero(K.rows(), K.cols());
      for (Eigen::Index i = 0; i < M.rows(); ++i)
        for (Eigen::Index j = 0; j < M.cols(); ++j)
          M3.block<3, 3>(3 * i, 3 * j) = M(i, j) * Eigen::Matrix3d::Identity();
      const Eigen::VectorXd values = test::symmetric_eigenvalues(test::symmetric_part(K), M3);
      return {2. / std::sqrt(values.maxCoeff()), model.elements.largest_stable_step()};
    }

    const auto all_formulations = {SolidFormulation::one_point, SolidFormulation::b_bar};
  } // namespace

  // A brick of a cube's mass whose inertia through the thickness is that of a cube has a cube's step: for
  // parallelepipeds the bound is proven, and for these it is exact.
  TEST(MassScalingBound, ThinBricksReachTheCubesStep)
  {
    // the cells of solid-shells are turned, the axes of factors are not
    for (const auto formulation : {SolidFormulation::one_point, SolidFormulation::b_bar, SolidFormulation::solid_shell})
      for (const double nu : {0., 0.3, 0.45})
        for (const double height : {1., 0.5, 0.1, 0.02})
          for (unsigned int axis = 0; axis < 3; ++axis)
            {
              Point3 size(1., 1., 1.);
              size[axis]          = height;
              const auto  section = make_section(1., nu, formulation);
              const Steps cube    = compute_steps(make_box({1, 1, 1}, Point3(1., 1., 1.)), section, {{axis, 1.}});
              const Steps thin    = compute_steps(make_box({1, 1, 1}, size), section, {{axis, 1. / (height * height)}});
              EXPECT_LE(thin.bound, thin.exact * (1. + 1e-9));
              if (formulation != SolidFormulation::b_bar)
                {
                  EXPECT_NEAR(thin.exact / cube.exact, 1., 1e-7) << "height " << height << ", nu " << nu;
                  EXPECT_NEAR(thin.bound / cube.bound, 1., 1e-7); // a root of what cancels for a cube
                }
            }
  }

  // Random bricks, thin and thick, with any factor over any axis.
  TEST(MassScalingBound, HoldsForDistortedElements)
  {
    std::mt19937                           random(11);
    std::uniform_real_distribution<double> number(-1., 1.);
    for (const auto formulation : all_formulations)
      for (const double size : {0.02, 0.1, 0.2, 0.3})
        {
          double mean = 0.;
          for (int k = 0; k < 100; ++k)
            {
              const double       nu     = std::array{0., 0.3, 0.342, 0.45}[k % 4];
              const double       height = std::exp(1.5 * number(random) - 1.5), wide = std::exp(0.7 * number(random));
              const unsigned int axis = k % 3;
              Mesh               mesh = make_box({1, 1, 1}, Point3(1., 1., 1.));
              for (auto &x : mesh.nodes)
                {
                  x += size * Point3(number(random), number(random), number(random));
                  x[axis] *= height;
                  x[(axis + 1) % 3] *= wide;
                }
              const double factor = std::exp(3. + 3. * number(random));
              const Steps  steps  = compute_steps(mesh, make_section(1., nu, formulation), {{axis, factor}});
              EXPECT_LE(steps.bound, steps.exact * (1. + 1e-9))
                << "sample " << k << ", size " << size << ", factor " << factor << ", height " << height;
              mean += steps.bound / steps.exact / 100.;
            }
          RecordProperty("mean_bound_over_exact_" + std::to_string(size), std::to_string(mean));
          EXPECT_GT(mean, 0.95 - 1.2 * size) << "what safety costs grows with the distortion";
        }
  }

  // The wanted step is met by the least factors, at any number of layers and in a distorted mesh; the assembled one is
  // not shorter.
  TEST(MassScalingBound, FactorsGiveTheWantedStepForAnyNumberOfLayers)
  {
    for (const auto formulation : all_formulations)
      for (const double distortion : {0., 0.1})
        for (const unsigned int n_layers : {1u, 2u, 4u, 8u})
          {
            const Mesh mesh    = make_grid({3, 2, n_layers}, [=](const double x, const double y, const double z) {
              return Point3(3. * x + distortion * std::sin(9. * y), 2.2 * y + distortion * y * x,
                               0.7 * z * (1. + 2. * distortion * x) + 3. * distortion * x * x);
            });
            const auto section = make_section(1., 0.342, formulation);
            Model      model(mesh, section);
            const std::vector<unsigned int> axis(mesh.cells.size(), 2);
            const double                    reach = model.elements.compute_reachable_step(axis), target = 0.95 * reach;
            const auto                      factors = model.elements.compute_mass_factors(axis, target);
            std::vector<MassScale>          scale, less;
            for (const double factor : factors)
              {
                EXPECT_GT(factor, 1.);
                scale.push_back({2, factor});
                less.push_back({2, 0.99 * factor});
              }
            const Steps steps = compute_steps(mesh, section, scale);
            EXPECT_NEAR(steps.bound / target, 1., 1e-6);
            EXPECT_LE(steps.bound, steps.exact);
            EXPECT_GT(steps.bound, (0.8 - 2. * distortion) * steps.exact);
            model.elements.scale_masses(less);
            EXPECT_LT(model.elements.largest_stable_step(), target);
            for (const double factor : model.elements.compute_mass_factors(axis, 1e-3 * target))
              EXPECT_NEAR(factor, 1., 1e-6) << "no more than needed";
          }
  }

  TEST(MassScalingBound, RefusesImpossibleScales)
  {
    Model model(make_box({2, 1, 1}, Point3(2., 1., 1.)), make_section(1., 0.3));
    EXPECT_THROW(model.elements.scale_masses(std::vector<MassScale>{{2, 1.}}), InputError);
    EXPECT_THROW(model.elements.scale_masses(std::vector<MassScale>{{2, 1.}, {2, 0.5}}), InputError);
    EXPECT_THROW(model.elements.scale_masses(std::vector<MassScale>{{2, 1.}, {3, 2.}}), InputError);
    EXPECT_THROW(model.elements.compute_mass_factors(std::vector<unsigned int>{2}, 1.), InputError);
  }
} // namespace mass_scaling_bound_test
