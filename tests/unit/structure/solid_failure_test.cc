#include "solid_harness.h"

#include <birdstrike/core/numerical_failure.h>

#include <gtest/gtest.h>

namespace solid_failure_test
{
  using namespace solid_harness;

  namespace
  {
    constexpr std::array<SolidFormulation, 2> both{{SolidFormulation::one_point, SolidFormulation::b_bar}};

    SolidSection failing_titanium(const SolidFormulation formulation, const double strain, const double share = 1.)
    {
      SolidSection section;
      section.formulation                     = formulation;
      section.material.hardening.law          = HardeningLaw::linear;
      section.material.hardening.modulus      = 1e9;
      section.material.failure.law            = FailureLaw::plastic_strain;
      section.material.failure.plastic_strain = strain;
      section.material.failure.failed_share   = share;
      return section;
    }

    /// u_x = strain x per step, with about the lateral contraction of plastic flow.
    Eigen::VectorXd stretch(const Model &model, const double strain)
    {
      Eigen::VectorXd u(model.n_dofs());
      for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
        u.segment<3>(3 * n) = strain * model.mesh.nodes[n].cwiseProduct(Point3(1., -0.49, -0.49));
      return u;
    }

    /// Moves the last node, which only the last element has, until that element has failed.
    void tear_off_last_element(Model &model)
    {
      Eigen::VectorXd u = Eigen::VectorXd::Zero(model.n_dofs());
      u.tail<3>()       = Point3(1e-3, 1e-3, 1e-3);
      for (int step = 0; step < 3000 && model.elements.n_failed() == 0; ++step)
        model.move(u, 1e-5);
      ASSERT_EQ(model.elements.n_failed(), 1u);
      ASSERT_TRUE(model.elements.is_failed(model.mesh.cells.size() - 1));
    }
  } // namespace

  // A bar pulled apart. Elastic energy is the work of the forces less what is booked elsewhere, and what fails gives
  // all that it holds: of a bar that has failed altogether round-off is left. What it held is the energy of its stress,
  // within the 1 % by which the volume and the linear strains differ.
  TEST(SolidFailure, ABarPulledApartGivesItsEnergyToTheLedger)
  {
    for (const auto formulation : both)
      {
        Model       model(make_box({5, 2, 1}, Point3(5., 2., 1.)), failing_titanium(formulation, 0.05));
        const auto &e      = model.elements;
        const auto  u      = stretch(model, 1e-4);
        double      before = 0.;
        for (int step = 0; e.n_failed() == 0; ++step)
          {
            ASSERT_LT(step, 1000);
            EXPECT_EQ(e.eroded_energy(), 0.);
            before = e.elastic_energy() + e.hourglass_energy();
            model.move(u, 1e-5);
          }
        EXPECT_EQ(e.n_failed(), 10u);
        EXPECT_EQ(e.n_collapsed(), 0u);
        EXPECT_NEAR(e.failed_mass(), 10. * 4430., 1e-6);
        EXPECT_NEAR(e.eroded_energy() / before, 1., 0.03) << "less half a step's work";
        // the flow stress at 0.05, the mean stress of a volume that grows by 0.02 of the strain
        const Elasticity elasticity = model.section.material.elasticity;
        const double     flow = 880e6 + 0.05 * 1e9, strain = 0.05 + flow / (3. * elasticity.shear_modulus());
        const double     energy = flow * flow / (6. * elasticity.shear_modulus()) +
                              0.5 * elasticity.bulk_modulus() * std::pow(0.02 * strain, 2);
        EXPECT_NEAR(e.eroded_energy() / (10. * energy), 1., 0.03);
        EXPECT_NEAR(e.elastic_energy(), 0., 1e-9 * before);
        EXPECT_NEAR(e.hourglass_energy(), 0., 1e-9 * before);
        EXPECT_GT(e.plastic_work(), 5. * before);
        const double plastic = e.plastic_work(), elastic = e.elastic_energy();
        EXPECT_EQ(model.move(u, 1e-5).cwiseAbs().maxCoeff(), 0.) << "nothing pulls any more";
        EXPECT_EQ(e.plastic_work(), plastic);
        EXPECT_NEAR(e.elastic_energy(), elastic, 1e-12 * plastic);
        for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
          EXPECT_TRUE(e.is_free(n));
        EXPECT_EQ(e.largest_stable_step(), std::numeric_limits<double>::infinity());
        EXPECT_EQ(e.state(0).stress, (std::array<double, 6>{}));
        EXPECT_GT(e.max_plastic_strains().front().value, 0.05 - 1e-12) << "of failed elements too";
        EXPECT_EQ(e.compute_nodal_masses()[0], 0.125 * 4430.) << "masses stay";
      }
  }

  // Bricks of 0.125 and 1 m^3 (cube roots 0.5 and 1 m) stretched alike: the smaller ones fail at twice the plastic
  // strain.
  TEST(SolidFailure, TheFailureStrainFollowsTheSize)
  {
    for (const auto formulation : both)
      for (const double side : {0.5, 1.})
        {
          auto section                          = failing_titanium(formulation, 0.02);
          section.material.failure.size_factors = {{{{0.5, 2.}, {1., 1.}}}, 2};
          Model      model(make_box({5, 2, 1}, side * Point3(5., 2., 1.)), section);
          const auto u = stretch(model, 1e-4);
          for (int step = 0; model.elements.n_failed() == 0; ++step)
            {
              ASSERT_LT(step, 2000);
              model.move(u, 1e-5);
            }
          EXPECT_EQ(model.elements.n_failed(), 10u);
          EXPECT_NEAR(model.elements.max_plastic_strains().front().value, side < 1. ? 0.04 : 0.02, 1.1e-4);
          SizeCensus sizes{0};
          model.elements.add_sizes(0, sizes);
          EXPECT_NEAR(sizes.smallest, side, 1e-12);
          EXPECT_EQ(sizes.n_beyond, 0u);
        }
  }

  // Bent, twisted and pulled elements, of which some fail: what is left is the energy of the others, as an equal mesh
  // of which nothing can fail would have it. The stress of a shared element tells it apart from the ledger.
  TEST(SolidFailure, WhatIsLeftIsTheEnergyOfTheOthers)
  {
    for (const auto formulation : both)
      {
        Model           model(make_box({4, 1, 1}, Point3(4., 1., 1.)), failing_titanium(formulation, 0.02, 0.125));
        auto           &e = model.elements;
        Eigen::VectorXd u = Eigen::VectorXd::Zero(model.n_dofs());
        for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
          if (const Point3 &x = model.mesh.nodes[n]; x[0] == 4.) // the last element: pulled, bent and twisted
            u.segment<3>(3 * n) = 1e-4 * Point3(1. + 0.4 * x[2], 0.4 * (x[2] - 0.5), -0.4 * (x[1] - 0.5));
        for (int step = 0; step < 2000 && e.n_failed() == 0; ++step)
          model.move(u, 1e-5);
        ASSERT_EQ(e.n_failed(), 1u);
        const double held = e.eroded_energy();
        EXPECT_GT(held, 0.);
        EXPECT_NEAR(e.elastic_energy() + e.hourglass_energy(), 0., 1e-9 * held) << "the others have not moved";
        EXPECT_NEAR(e.hourglass_energy(), 0., 1e-9 * held);
      }
  }

  // The fully integrated brick, bent: points at the stretched face fail first.
  TEST(SolidFailure, PointsFailBeforeTheElement)
  {
    for (const double share : {0.5, 1.})
      {
        Model model(make_box({1, 1, 1}, Point3(1., 1., 1.)), failing_titanium(SolidFormulation::b_bar, 0.05, share));
        const auto     &e = model.elements;
        Eigen::VectorXd u = stretch(model, 1e-4);
        for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
          u[3 * n] = 1e-4 * (model.mesh.nodes[n][0] - 0.5) * (0.5 + model.mesh.nodes[n][2]); // by 0.5e-4 to 1.5e-4
        double least = 0., before = 0., at_first = 0.;
        int    first = 0, last = 0;
        for (int step = 1; e.n_failed() == 0; ++step)
          {
            ASSERT_LT(step, 3000);
            if (first == 0)
              before = e.elastic_energy();
            model.move(u, 1e-5);
            least = std::min(least, e.elastic_energy() / std::max(1., e.plastic_work()));
            if (first == 0 && e.damage(0) >= 1.)
              {
                first    = step;
                at_first = e.eroded_energy();
              }
            last = step;
          }
        ASSERT_GT(first, 0);
        EXPECT_EQ(last == first, share == 0.5) << "four of eight points fail together";
        EXPECT_NEAR(at_first / before, share == 1. ? 0.5 : 1., 0.1) << "that of four points, or all";
        EXPECT_GT(least, -1e-3);
        EXPECT_NEAR(e.elastic_energy(), 0., 1e-9 * e.eroded_energy());
      }
  }

  // Of which a lane of another element is next to the failed one: same forces and step as if it had never been, even
  // when its nodes turn it inside out.
  TEST(SolidFailure, AMeshGoesOnAsIfTheFailedElementHadNeverBeen)
  {
    for (const auto formulation : both)
      {
        const auto section = failing_titanium(formulation, 0.05, formulation == SolidFormulation::b_bar ? 0.125 : 1.);
        Model      torn(make_box({3, 3, 2}, Point3(3., 3., 2.)), section);
        torn.elements.use_nodal_masses(torn.elements.compute_nodal_masses());
        tear_off_last_element(torn);
        Mesh rest = torn.mesh;
        rest.cells.pop_back();
        Model never(rest, section);
        never.elements.use_nodal_masses(torn.elements.compute_nodal_masses());
        const std::size_t n_last = torn.n_dofs() - 3;
        for (unsigned int step = 0; step < 5; ++step)
          {
            Eigen::VectorXd u = some_motion(torn.n_dofs(), 1e-4, step);
            if (step == 2) // inside out
              u.segment<3>(n_last) = Point3(-2., -2., -2.);
            const Eigen::VectorXd f = torn.move(u, 1e-5), g = never.move(u, 1e-5);
            // the torn mesh has the stresses of what its other nodes were pulled by: none, they stood still
            EXPECT_LT((f - g).cwiseAbs().maxCoeff(), 1e-9 * g.cwiseAbs().maxCoeff()) << "step " << step;
            EXPECT_EQ(f.tail<3>().norm(), 0.);
            EXPECT_NEAR(torn.elements.largest_stable_step() / never.elements.largest_stable_step(), 1., 1e-9);
          }
        EXPECT_EQ(torn.elements.step_limit().value, torn.elements.largest_stable_step());
        EXPECT_TRUE(torn.elements.is_free(torn.mesh.nodes.size() - 1));
        EXPECT_FALSE(torn.elements.is_free(torn.mesh.nodes.size() - 2));
      }
  }

  // Johnson and Cook's law with D2 and D3 alone, e_f = D2 exp(D3 s*), and perfect plasticity. In shear s* = 0: the
  // plastic strain at failure is D2. Stretched without contraction s* = K e/s_y grows with the strain e, up to the
  // law's bound of 1.5, and dp = 2/3 de from e = s_y/2G on.
  TEST(SolidFailure, DamageFollowsTheTriaxialityOfThreeDimensions)
  {
    const Point3 shear(0., 1., 0.), stretched(1., 0., 0.);
    for (const auto formulation : both)
      for (const Point3 &gradient : {shear, stretched}) // of u_x
        {
          SolidSection section           = failing_titanium(formulation, 1.);
          section.material.hardening.law = HardeningLaw::perfect;
          section.material.failure.law   = FailureLaw::johnson_cook;
          section.material.failure.d     = {{0., 0.1, -1.5, 0., 0.}};
          Model           model(make_box({1, 1, 1}, Point3(1., 1., 1.)), section);
          Eigen::VectorXd u       = Eigen::VectorXd::Zero(model.n_dofs());
          int             n_steps = 0;
          for (; n_steps < 4000 && model.elements.n_failed() == 0; ++n_steps)
            {
              for (int n = 0; n < 8; ++n)
                u[3 * n] = 1e-4 * gradient.dot(Point3(&model.position[3 * n]));
              model.move(u, 1e-5);
            }
          ASSERT_EQ(model.elements.n_failed(), 1u);
          double expected = 0.1;
          if (gradient == stretched)
            {
              const Elasticity elasticity = section.material.elasticity;
              const double     yield      = section.material.hardening.yield;
              double           strain = yield / (2. * elasticity.shear_modulus()), damage = 0.;
              expected = 0.;
              for (; damage < 1.; strain += 1e-6, expected += 2. / 3. * 1e-6)
                damage +=
                  2. / 3. * 1e-6 / (0.1 * std::exp(-1.5 * std::min(1.5, elasticity.bulk_modulus() * strain / yield)));
              EXPECT_LT(expected, 0.02);
            }
          // a step of 1e-4 may go beyond
          EXPECT_NEAR(model.elements.max_plastic_strains().front().value, expected, 1e-4 + 0.002 * expected);
        }
  }

  // One layer of one-point bricks: its mean stress is zero between the stretched face and the compressed one.
  TEST(SolidFailure, AOnePointBrickThatBendsIsAtNoTriaxiality)
  {
    SolidSection section           = failing_titanium(SolidFormulation::one_point, 1.);
    section.material.hardening.law = HardeningLaw::perfect;
    section.material.failure.law   = FailureLaw::johnson_cook;
    section.material.failure.d     = {{0., 0.1, -1.5, 0., 0.}};
    Model           model(make_box({1, 1, 1}, Point3(1., 1., 1.)), section);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(model.n_dofs());
    for (int n = 0; n < 8; ++n)
      u[3 * n] = 2e-4 * (model.mesh.nodes[n][0] - 0.5) * (model.mesh.nodes[n][2] - 0.5);
    for (int step = 0; step < 4000 && model.elements.n_failed() == 0; ++step)
      model.move(u, 1e-5);
    ASSERT_EQ(model.elements.n_failed(), 1u);
    EXPECT_NEAR(model.elements.max_plastic_strains().front().value, 0.1, 1e-3);
  }

  TEST(SolidFailure, WhatCollapsesIsTakenAway)
  {
    for (const auto formulation : both)
      for (const double smallest : {0., 0.6})
        {
          auto section                           = failing_titanium(formulation, 100.);
          section.material.failure.smallest_step = smallest;
          Model           model(make_box({3, 1, 1}, Point3(3., 1., 1.)), section);
          const auto     &e    = model.elements;
          Eigen::VectorXd u    = Eigen::VectorXd::Zero(model.n_dofs());
          const double    step = e.largest_stable_step();
          for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) // the last one is crushed
            if (model.mesh.nodes[n][0] == 3.)
              u[3 * n] = -5e-3;
          double least = step;
          int    k     = 0;
          for (; k < 180 && e.n_failed() == 0; ++k)
            {
              model.move(u, 1e-3);
              least = std::min(least, e.largest_stable_step());
            }
          if (smallest == 0.)
            {
              EXPECT_LT(least, 0.6 * step);
              EXPECT_THROW(for (; k < 220; ++k) model.move(u, 1e-3), NumericalFailure);
              continue;
            }
          EXPECT_EQ(e.n_failed(), 1u);
          EXPECT_EQ(e.n_collapsed(), 1u);
          EXPECT_TRUE(e.is_failed(2));
          EXPECT_GT(least, smallest * step) << "it has no vote even in the step in which it goes";
          EXPECT_LT(least, 1.1 * smallest * step);
          EXPECT_GT(e.eroded_energy(), 0.);
          for (; k < 300; ++k)
            EXPECT_TRUE(model.move(u, 1e-3).allFinite());
          EXPECT_EQ(e.n_failed(), 1u);
        }
  }

  // In one step, so that nothing has warned: neither energy nor forces become NaN, and its old forces' work is booked.
  TEST(SolidFailure, WhatIsTurnedInsideOutIsTakenAway)
  {
    for (const auto formulation : both)
      {
        auto section                           = failing_titanium(formulation, 100.);
        section.material.failure.smallest_step = 0.01;
        Model       model(make_box({3, 1, 1}, Point3(3., 1., 1.)), section);
        const auto &e = model.elements;
        model.move(some_motion(model.n_dofs(), 1e-3, 1), 1e-5);
        Eigen::VectorXd u = Eigen::VectorXd::Zero(model.n_dofs());
        for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
          if (model.mesh.nodes[n][0] == 3.)
            u[3 * n] = -1.5;
        EXPECT_TRUE(model.move(u, 1e-3).allFinite());
        EXPECT_EQ(e.n_collapsed(), 1u);
        EXPECT_TRUE(std::isfinite(e.eroded_energy()));
        EXPECT_TRUE(std::isfinite(e.elastic_energy()));
        EXPECT_TRUE(std::isfinite(e.plastic_work()));
        EXPECT_TRUE(model.move(u, 1e-3).allFinite());
        EXPECT_EQ(e.n_failed(), 1u);
      }
  }

  TEST(SolidFailure, IsBitwiseTheSameForOneAndTwoThreads)
  {
    for (const auto formulation : both)
      {
        std::vector<Eigen::VectorXd> forces[2];
        double                       eroded[2];
        for (const std::size_t n_threads : {1, 2})
          {
            auto section                           = failing_titanium(formulation, 0.02, 0.5);
            section.material.failure.smallest_step = 0.1;
            Model model(make_box({30, 5, 3}, Point3(30., 5., 3.)), section, n_threads);
            for (unsigned int step = 0; step < 30; ++step)
              {
                Eigen::VectorXd u = some_motion(model.n_dofs(), 1e-2, step);
                for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) // one end stays whole
                  u.segment<3>(3 * n) *= model.mesh.nodes[n][0] / 30.;
                forces[n_threads - 1].push_back(model.move(u, 1e-5));
              }
            eroded[n_threads - 1] = model.elements.eroded_energy();
            EXPECT_GT(model.elements.n_failed(), 20u);
            EXPECT_LT(model.elements.n_failed(), 450u);
          }
        EXPECT_EQ(eroded[0], eroded[1]);
        EXPECT_EQ(forces[0], forces[1]);
      }
  }
} // namespace solid_failure_test
