#include "shell_harness.h"

#include "structure/elements/shell/failure.h"
#include <birdstrike/core/numerical_failure.h>

#include <gtest/gtest.h>

namespace shell_failure_test
{
  using namespace shell_harness;

  namespace
  {
    ShellSection failing_titanium(const double strain, const double share = 1.,
                                  const ShellFormulation formulation = ShellFormulation::one_point_physical)
    {
      ShellSection section;
      section.formulation                     = formulation;
      section.material.hardening.law          = HardeningLaw::linear;
      section.material.hardening.modulus      = 1e9;
      section.material.failure.law            = FailureLaw::plastic_strain;
      section.material.failure.plastic_strain = strain;
      section.material.failure.failed_share   = share;
      return section;
    }

    Mesh plate(const unsigned int nx, const unsigned int ny, const double side = 1., const double slope = 0.)
    {
      return make_grid(nx, ny, [=](const double x, const double y) {
        return Point3(side * nx * x, side * ny * y, slope * side * nx * x);
      });
    }

    /// u_x = strain x + z-part of a curvature about y, per step
    Eigen::VectorXd stretch(const Model &model, const double strain, const double curvature = 0.)
    {
      Eigen::VectorXd u = Eigen::VectorXd::Zero(model.n_dofs());
      for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
        {
          u[6 * n]     = strain * model.mesh.nodes[n][0];
          u[6 * n + 4] = curvature * model.mesh.nodes[n][0];
        }
      return u;
    }

    /// Moves the last node, which only the last element has, until that element has failed.
    void tear_off_last_element(Model &model)
    {
      Eigen::VectorXd u                               = Eigen::VectorXd::Zero(model.n_dofs());
      u.segment<3>(6 * (model.mesh.nodes.size() - 1)) = Point3(1e-3, 1e-3, 0.);
      for (int step = 0; step < 1000 && model.elements.n_failed() == 0; ++step)
        model.move(u, 1e-6);
      ASSERT_TRUE(model.elements.is_failed(model.mesh.cells.size() - 1));
      ASSERT_EQ(model.elements.n_failed(), 1u);
    }
  } // namespace

  TEST(ShellFailure, PointsToFailAreAShareRoundedUp)
  {
    Failure failure;
    EXPECT_EQ(n_points_to_fail(failure.failed_share, 5), 5u);
    failure.failed_share = 0.8;
    EXPECT_EQ(n_points_to_fail(failure.failed_share, 5), 4u);
    failure.failed_share = 0.7;
    EXPECT_EQ(n_points_to_fail(failure.failed_share, 5), 4u);
    failure.failed_share = 1e-3;
    EXPECT_EQ(n_points_to_fail(failure.failed_share, 5), 1u);
  }

  // A strip pulled apart in plane strain. Elastic energy is the work of the forces less what is booked elsewhere: only
  // if what failure books is right does nothing of it stay behind. 0.2 % is what second-order terms of steps of 1e-4
  // leave.
  TEST(ShellFailure, AStripPulledApartGivesItsEnergyToTheLedger)
  {
    for (const auto formulation : all_formulations)
      {
        Model       model(plate(5, 2), 0.05, failing_titanium(0.05, 1., formulation));
        const auto &e    = model.elements;
        const auto  u    = stretch(model, 1e-4);
        double      peak = 0., before = 0.;
        int         step = 0;
        for (; e.n_failed() == 0; ++step)
          {
            ASSERT_LT(step, 1000);
            EXPECT_EQ(e.eroded_energy(), 0.);
            before = e.elastic_energy();
            peak   = std::max(peak, model.move(u, 1e-6).cwiseAbs().maxCoeff());
          }
        // all points strain alike: everything fails at once
        EXPECT_EQ(e.n_failed(), 10u);
        EXPECT_NEAR(e.failed_mass(), 10. * 0.05 * 4430., 1e-9);
        EXPECT_NEAR(e.eroded_energy() / before, 1., 0.02) << "less half a step's work";
        EXPECT_NEAR(e.elastic_energy(), 0., 5e-3 * before);
        EXPECT_GT(e.plastic_work(), 5. * before) << "plastic work stays where it is";
        EXPECT_GT(peak, 880e6 * 0.05 * 0.5);
        const double plastic = e.plastic_work(), elastic = e.elastic_energy();
        EXPECT_EQ(model.move(u, 1e-6).cwiseAbs().maxCoeff(), 0.) << "nothing pulls any more";
        EXPECT_EQ(e.plastic_work(), plastic);
        EXPECT_NEAR(e.elastic_energy(), elastic, 1e-12 * plastic);
        for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
          EXPECT_TRUE(e.is_free(n));
        EXPECT_EQ(e.largest_stable_step(), std::numeric_limits<double>::infinity()) << "and nothing limits the step";
        EXPECT_EQ(e.compute_nodal_masses()[0], 0.25 * 0.05 * 4430.) << "masses stay";
      }
  }

  // Bent and pulled: points fail one by one from the stretched face. A failed point carries nothing while others do;
  // the element goes when three of five have failed.
  TEST(ShellFailure, PointsFailBeforeTheElement)
  {
    for (const auto &[formulation, share] :
         {std::pair(covariant_formulations[0], 0.6), std::pair(covariant_formulations[0], 1.),
          std::pair(covariant_formulations[1], 0.6), std::pair(covariant_formulations[1], 1.)})
      {
        Model       model(plate(1, 1, 1e-3), 0.05, failing_titanium(0.05, share, formulation)); // directors hardly turn
        const auto &e     = model.elements;
        const auto  u     = stretch(model, 1e-4, 2e-3); // strains from 0.5e-4 to 1.5e-4
        int         first = 0, last = 0;
        double      least = 0., before = 0.;
        for (int step = 1; e.n_failed() == 0; ++step)
          {
            ASSERT_LT(step, 2000);
            before = e.elastic_energy();
            model.move(u, 1e-6);
            least = std::min(least, e.elastic_energy() / std::max(before, 1.));
            if (first == 0 && e.damage(0) >= 1.)
              {
                first = step;
                EXPECT_EQ(e.n_failed(), 0u);
                EXPECT_EQ(e.layer_stress(0, ShellLayer::top)[0], 0.) << "stretched most";
                EXPECT_GT(e.layer_stress(0, ShellLayer::middle)[0], 880e6);
                EXPECT_GT(e.state(0).membrane_force[0], 0.);
                EXPECT_LT(e.eroded_energy(), 0.3 * before) << "one point has an eighth of the thickness";
              }
            last = step;
          }
        EXPECT_GT(least, -1e-3) << "elastic energy never falls below zero";
        // in plane strain plastic strain 0.05 takes 0.05 sqrt(3)/2 of stretch, and 2/sqrt(3) s_y (1 - nu/2)/E are
        // elastic; Gauss points at 0, +-0.538, +-0.906 of t/2; lengths grow by 5 %, and with them the steps needed
        const double needed = (0.05 * std::sqrt(3.) / 2. + 2. / std::sqrt(3.) * 880e6 * 0.829 / 113.8e9) / 1e-4;
        EXPECT_NEAR(first, needed / (1. + 0.5 * 0.906), 0.06 * first);
        EXPECT_NEAR(last, needed / (share < 1. ? 1. : 1. - 0.5 * 0.906), 0.06 * last);
        EXPECT_NEAR(e.elastic_energy(), 0., 5e-3 * e.eroded_energy());
      }
  }

  // A strip of elements of two sizes, 1 x 0.25 and 1 x 1 m (roots of the area 0.5 and 1), all stretched alike: those
  // of 0.5 m fail at twice the plastic strain.
  TEST(ShellFailure, TheFailureStrainFollowsTheSize)
  {
    for (const auto formulation : all_formulations)
      {
        auto section                          = failing_titanium(0.02, 1., formulation);
        section.material.failure.size_factors = {{{{0.5, 2.}, {1., 1.}}}, 2};
        const Mesh mesh                       = make_grid(2, 9, [](const double x, const double y) {
          return Point3(2. * x, 9. * y <= 5. ? 0.25 * 9. * y : 1.25 + 9. * y - 5., 0.);
        });
        Model      model(mesh, 0.05, section);
        const auto u        = stretch(model, 1e-4);
        const auto is_large = [&](const std::size_t e) {
          return std::abs(model.mesh.nodes[model.mesh.cells[e][2]][1] - model.mesh.nodes[model.mesh.cells[e][0]][1]) >
                 0.5;
        };
        const auto strain   = [&] { return model.elements.max_plastic_strains().front().value; };
        bool       is_first = true;
        for (int step = 1; model.elements.n_failed() < 18; ++step)
          {
            ASSERT_LT(step, 2000);
            model.move(u, 1e-6);
            if (is_first && model.elements.n_failed() > 0)
              {
                is_first = false;
                EXPECT_NEAR(strain(), 0.02, 1.2e-4) << "2/sqrt(3) of the stretch of a step";
                EXPECT_EQ(model.elements.n_failed(), 8u);
                for (std::size_t e = 0; e < 18; ++e)
                  EXPECT_EQ(model.elements.is_failed(e), is_large(e)) << e;
              }
          }
        EXPECT_NEAR(strain(), 0.04, 1.2e-4);
        SizeCensus sizes{0};
        model.elements.add_sizes(0, sizes);
        EXPECT_NEAR(sizes.smallest, 0.5, 1e-12);
        EXPECT_NEAR(sizes.largest, 1., 1e-12);
        EXPECT_NEAR(sizes.lowest, 1., 1e-12);
        EXPECT_NEAR(sizes.highest, 2., 1e-12);
        EXPECT_EQ(sizes.n_beyond, 0u);
      }
  }

  // The element that has gone leaves no trace: same forces, same normals, same step as if it had never been.
  TEST(ShellFailure, AMeshGoesOnAsIfTheFailedElementHadNeverBeen)
  {
    for (const auto formulation : all_formulations)
      for (const unsigned int nx : {3u, 8u}) // one batch; batches beside each other
        {
          // of a fully integrated element pulled at one corner not all points strain
          const double share   = formulation == ShellFormulation::fully_integrated ? 0.25 : 1.;
          const auto   section = failing_titanium(0.05, share, formulation);
          Model        torn(plate(nx, 3), 0.05, section);
          torn.elements.use_nodal_masses(torn.elements.compute_nodal_masses());
          tear_off_last_element(torn);
          Mesh rest = torn.mesh;
          rest.cells.pop_back();
          Model never(rest, 0.05, section);
          never.elements.use_nodal_masses(torn.elements.compute_nodal_masses());
          const std::size_t n_last = torn.n_dofs() - 6;
          for (int step = 0; step < 5; ++step)
            {
              Eigen::VectorXd u = some_motion(torn.n_dofs(), 1e-4, step);
              if (step == 2) // onto its neighbour: the failed element has no area
                u.segment<3>(n_last) =
                  Point3(&torn.position[3 * (nx + 1) * 3 - 3]) - Point3(&torn.position[n_last / 2]);
              const Eigen::VectorXd f = torn.move(u, 1e-6), g = never.move(u, 1e-6);
              EXPECT_LT((f - g).cwiseAbs().maxCoeff(), 1e-9 * g.cwiseAbs().maxCoeff()) << "step " << step;
              EXPECT_EQ(f.segment<6>(n_last).norm(), 0.);
              EXPECT_NEAR(torn.elements.largest_stable_step() / never.elements.largest_stable_step(), 1., 1e-9);
            }
          EXPECT_EQ(torn.elements.step_limit().value, torn.elements.largest_stable_step());
          EXPECT_TRUE(torn.elements.is_free(torn.mesh.nodes.size() - 1));
          EXPECT_FALSE(torn.elements.is_free(torn.mesh.nodes.size() - 2));
          EXPECT_EQ(torn.elements.global_layer_stress(torn.mesh.cells.size() - 1, ShellLayer::top),
                    (std::array<double, 6>{}));
        }
  }

  // Elements on a plane of symmetry keep their normals in it when a neighbour fails.
  TEST(ShellFailure, DirectorsStandInThePlaneOfSymmetry)
  {
    // A plate that falls towards the plane x = 3, its mirror image behind it, bent across the fold: a moment has no
    // component along the director of its node, which on the fold is z where the plane is known, else the plate's
    // normal.
    const auto twist_over_bend = [](const bool has_plane) {
      Model half(plate(3, 3, 1., -1e-3), 0.05, failing_titanium(0.05));
      if (has_plane)
        half.elements.add_symmetry_plane(std::vector<std::uint32_t>{3, 7, 11, 15}, Point3::UnitX());
      Eigen::VectorXd bend = Eigen::VectorXd::Zero(half.n_dofs());
      for (std::size_t n = 0; n < half.mesh.nodes.size(); ++n)
        bend[6 * n + 3] = 1e-8 * half.mesh.nodes[n][1];
      const Eigen::VectorXd f = half.move(bend, 1e-6);
      return std::abs(f[6 * 11 + 5] / f[6 * 11 + 3]);
    };
    EXPECT_LT(twist_over_bend(true), 1e-9);
    EXPECT_GT(twist_over_bend(false), 1e-4);
  }

  // One strip of three, of which the last is crushed in its plane: its step falls with its length.
  TEST(ShellFailure, WhatCollapsesIsTakenAway)
  {
    for (const auto formulation : all_formulations)
      for (const double law_limit : {100., 0.02}) // plastic strain at which points fail: never, and before it collapses
        {
          auto section                           = failing_titanium(law_limit, 1., formulation);
          section.material.failure.smallest_step = 0.3;
          Model           model(plate(3, 1), 0.05, section);
          const auto     &e    = model.elements;
          Eigen::VectorXd u    = Eigen::VectorXd::Zero(model.n_dofs());
          const double    step = e.largest_stable_step();
          for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
            if (model.mesh.nodes[n][0] == 3.)
              u[6 * n] = -5e-4;
          double least = step, before = 0.;
          int    k = 0;
          for (; k < 1900 && e.n_failed() == 0; ++k)
            {
              before = e.elastic_energy() + e.hourglass_energy();
              model.move(u, 1e-4);
              least = std::min(least, e.largest_stable_step());
            }
          ASSERT_EQ(e.n_failed(), 1u) << k;
          EXPECT_EQ(e.n_collapsed(), law_limit > 1. ? 1u : 0u);
          EXPECT_TRUE(e.is_failed(2));
          EXPECT_GT(least, 0.3 * step) << "it has no vote even in the step in which it goes";
          if (law_limit > 1.)
            {
              EXPECT_LT(least, 0.33 * step);
              // all that the element had, less the work of the last step; the others hold nothing
              EXPECT_NEAR(e.elastic_energy() + e.hourglass_energy(), 0., 0.05 * before);
            }
          for (; k < 3000; ++k)
            EXPECT_EQ(model.move(u, 1e-4).cwiseAbs().maxCoeff(), 0.);
          EXPECT_EQ(e.n_failed(), 1u);
        }
  }

  // In one step and without warning: to a line, so that the area is zero and its forces are nothing finite.
  TEST(ShellFailure, WhatLosesItsAreaInOneStepIsTakenAwayOrEndsTheRun)
  {
    for (const auto formulation : all_formulations)
      for (const double smallest : {0., 0.01})
        {
          auto section                           = failing_titanium(100., 1., formulation);
          section.material.failure.smallest_step = smallest;
          Model       model(plate(3, 1), 0.05, section);
          const auto &e = model.elements;
          model.move(some_motion(model.n_dofs(), 1e-3, 1), 1e-5);
          Eigen::VectorXd u = Eigen::VectorXd::Zero(model.n_dofs());
          for (const std::size_t n : {3u, 7u}) // onto their neighbours
            u.segment<3>(6 * n) = Point3(&model.position[3 * (n - 1)]) - Point3(&model.position[3 * n]);
          if (smallest == 0.)
            {
              EXPECT_THROW(model.move(u, 1e-3), NumericalFailure);
              continue;
            }
          EXPECT_TRUE(model.move(u, 1e-3).allFinite());
          EXPECT_EQ(e.n_collapsed(), 1u);
          for (const double energy : {e.eroded_energy(), e.elastic_energy(), e.plastic_work(), e.hourglass_energy()})
            EXPECT_TRUE(std::isfinite(energy));
          EXPECT_TRUE(model.move(u, 1e-3).allFinite());
        }
  }

  TEST(ShellFailure, IsBitwiseTheSameForOneAndTwoThreads)
  {
    struct Run
    {
      std::vector<Eigen::VectorXd> forces;
      std::size_t                  n_failed;
      double                       eroded;
    };
    const auto run = [](const ShellFormulation formulation, const std::size_t n_threads) {
      // several chunks, the last batch not full
      Model model(make_grid(30, 19, [](const double x, const double y) { return Point3(30. * x, 19. * y, x * y); }),
                  0.05, failing_titanium(0.02, 0.6, formulation), n_threads);
      Run   result;
      for (int step = 0; step < 40; ++step)
        {
          Eigen::VectorXd u = some_motion(model.n_dofs(), 2e-2, step);
          for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) // one end stays whole
            u.segment<6>(6 * n) *= model.mesh.nodes[n][0] / 30.;
          result.forces.push_back(model.move(u, 1e-6));
        }
      result.n_failed = model.elements.n_failed();
      result.eroded   = model.elements.eroded_energy();
      return result;
    };
    for (const auto formulation : covariant_formulations)
      {
        const Run one = run(formulation, 1), two = run(formulation, 2);
        EXPECT_GT(one.n_failed, 20u);
        EXPECT_LT(one.n_failed, 570u);
        EXPECT_EQ(one.n_failed, two.n_failed);
        EXPECT_EQ(one.eroded, two.eroded);
        EXPECT_EQ(one.forces, two.forces);
      }
  }
} // namespace shell_failure_test
