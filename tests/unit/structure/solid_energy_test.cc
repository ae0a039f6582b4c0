#include "solid_harness.h"

#include <gtest/gtest.h>

namespace solid_energy_test
{
  // What elements book as stored and dissipated, against the stresses and strains that they report. That the parts add
  // up to the work of the nodal forces is no test of them: the elastic part is what is left of the work.

  using namespace birdstrike;
  using namespace solid_harness;

  namespace
  {
    constexpr SolidFormulation formulations[] = {SolidFormulation::one_point, SolidFormulation::b_bar,
                                                 SolidFormulation::solid_shell};

    /// V s : C^-1 : s / 2 over 2 x 2 x 2 Gauss points of an element near its reference shape, where stresses are
    /// trilinear.
    double compute_stored_energy(const Model &model)
    {
      const Elasticity &elasticity = model.section.material.elasticity;
      double            total      = 0.;
      for (std::size_t e = 0; e < model.elements.n_elements(); ++e)
        for (int p = 0; p < 8; ++p)
          {
            std::array<double, 6> s{};
            for (unsigned int corner = 0; corner < 8; ++corner)
              {
                double shape = 1.;
                for (int k = 0; k < 3; ++k)
                  shape *= 0.5 * (1. + ((int(corner) >> k & 1) == (p >> k & 1) ? 1. : -1.) / std::sqrt(3.));
                const auto at_corner = model.elements.corner_stress(e, corner);
                for (int c = 0; c < 6; ++c)
                  s[c] += shape * at_corner[c];
              }
            const double trace = s[0] + s[1] + s[2], nu = elasticity.poisson;
            double       square = 0.;
            for (int c = 0; c < 6; ++c)
              square += (c < 3 ? 1. : 2.) * s[c] * s[c];
            total += 0.125 * model.elements.state(e).volume * ((1. + nu) * square - nu * trace * trace) /
                     (2. * elasticity.young);
          }
      return total;
    }
  } // namespace

  TEST(SolidEnergy, WhatIsStoredIsThatOfTheStresses)
  {
    for (const auto formulation : formulations)
      for (const Point3 &size : {Point3(1., 1., 1.), Point3(1., 1.5, 0.2)})
        {
          Model                 model(make_box({3, 2, 2}, size), make_section(1e9, 0.3, formulation));
          const int             n = 50;
          const Eigen::VectorXd u = some_motion(model.n_dofs(), 1e-4 * size[2], 3);
          for (int i = 0; i < n; ++i)
            model.move(u / n);
          const double booked = model.elements.elastic_energy() + model.elements.hourglass_energy();
          EXPECT_GT(booked, 0.);
          EXPECT_NEAR(booked / compute_stored_energy(model), 1., 2e-3) << "strains of 1e-3, on changing geometry";
        }
  }

  TEST(SolidEnergy, PlasticWorkIsYieldStressTimesPlasticStrain)
  {
    // a block that is stretched, sheared and bent at once; perfectly plastic: s_y dp in every point. Not of
    // solid-shells: what varies in the plane is no part of their points' work, and their stress is not linear across
    for (const auto formulation : {SolidFormulation::one_point, SolidFormulation::b_bar})
      {
        SolidSection section           = make_section(113.8e9, 0.342, formulation);
        section.material.hardening.law = HardeningLaw::perfect;
        Model                 model(make_box({2, 2, 2}, Point3(1., 1., 1.)), section);
        const int             n = 400;
        const Eigen::VectorXd u = some_motion(model.n_dofs(), 0.02, 5);
        for (int i = 0; i < n; ++i)
          model.move(u / n);
        double strain = 0., volume = 0.;
        for (std::size_t e = 0; e < model.elements.n_elements(); ++e)
          {
            strain += model.elements.state(e).plastic_strain / double(model.elements.n_elements()); // volumes at rest
            volume += model.elements.state(e).volume;
          }
        EXPECT_GT(strain, 0.01);
        EXPECT_LT(volume, 0.995) << "the law is one for volumes at rest";
        EXPECT_NEAR(model.elements.plastic_work() / (section.material.hardening.yield * strain), 1.,
                    formulation == SolidFormulation::one_point ? 1e-10 : 1e-3)
          << "an element's mean is one over present volumes of its points";
        EXPECT_NEAR((model.elements.elastic_energy() + model.elements.hourglass_energy()) /
                      compute_stored_energy(model),
                    1., 0.02);
      }
  }

  TEST(SolidEnergy, BulkViscosityTakesItsPressureTimesTheStrain)
  {
    // a cube of 0.5 m, compressed along x at a rate r: q = rho l (b1 c r + b2^2 l r^2), from zero within the first step
    for (const auto formulation : formulations)
      {
        SolidSection section        = make_section(1e9, 0.3, formulation);
        section.material.density    = 2000.;
        section.linear_viscosity    = 0.06;
        section.quadratic_viscosity = 1.2;
        const double    l = 0.5, strain = 1e-6, dt = 1e-8, rate = strain / dt;
        const double    c = std::sqrt(1e9 * 0.7 / (1.3 * 0.4) / 2000.), linear = 2000. * l * 0.06 * c * rate;
        const double    q = linear + 2000. * l * l * 1.44 * rate * rate;
        Model           model(make_box({1, 1, 1}, Point3(l, l, l)), section);
        Eigen::VectorXd u = Eigen::VectorXd::Zero(24);
        for (std::size_t k = 0; k < 8; ++k)
          u[3 * k] = -strain * model.mesh.nodes[k][0];
        model.move(u, dt);
        EXPECT_NEAR(model.elements.viscous_energy() / (0.5 * q * strain * l * l * l), 1., 1e-5);
        model.move(-u, dt);
        EXPECT_NEAR(model.elements.viscous_energy() / (0.5 * linear * strain * l * l * l), 1., 1e-5)
          << "trapezoids in time: (0 + q)/2 on the way there, (q - linear)/2 on the way back, where the square does "
             "not "
             "act";
      }
  }
} // namespace solid_energy_test
