#include "solid_harness.h"

#include <gtest/gtest.h>

namespace solid_bending_test
{
  using namespace solid_harness;

  namespace
  {
    constexpr double young = 113.8e9, poisson = 0.342, density = 4430.;
    constexpr double length = 0.3112, chord = 0.0889, thickness = 4.27e-3;

    std::vector<double> plate_frequencies(const std::array<unsigned int, 3> &n, const SolidFormulation formulation,
                                          const int n_modes)
    {
      SolidSection section     = make_section(young, poisson, formulation);
      section.material.density = density;
      Model             model(make_box(n, Point3(length, chord, thickness)), section);
      std::vector<bool> held(model.n_dofs(), false);
      for (std::size_t d = 0; d < held.size(); ++d)
        held[d] = model.mesh.nodes[d / 3][0] < 1e-9;
      return model.compute_frequencies(held, n_modes);
    }

    /// Tip deflection over that of beam theory of a cantilever with a tip force.
    double cantilever(const std::array<unsigned int, 3> &n, const Point3 &size, const double nu,
                      const SolidFormulation formulation)
    {
      Model             model(make_box(n, size), make_section(1e9, nu, formulation));
      std::vector<bool> held(model.n_dofs(), false);
      Eigen::VectorXd   load  = Eigen::VectorXd::Zero(model.n_dofs());
      double            tip   = 0.;
      std::size_t       n_tip = (n[1] + 1) * (n[2] + 1);
      for (std::size_t k = 0; k < model.mesh.nodes.size(); ++k)
        {
          const Point3 &x = model.mesh.nodes[k];
          if (x[0] < 1e-9)
            {
              held[3 * k]     = true; // free to contract
              held[3 * k + 1] = x[1] < 1e-9;
              held[3 * k + 2] = x[2] < 1e-9;
            }
          if (x[0] > size[0] - 1e-9)
            load[3 * k + 2] = 1. / double(n_tip);
        }
      const Eigen::VectorXd u = model.solve(load, held);
      for (std::size_t k = 0; k < model.mesh.nodes.size(); ++k)
        if (model.mesh.nodes[k][0] > size[0] - 1e-9)
          tip += u[3 * k + 2] / double(n_tip);
      const double inertia = size[1] * std::pow(size[2], 3) / 12.;
      return tip / (std::pow(size[0], 3) / (3e9 * inertia));
    }
  } // namespace

  // Beam theory has no shear deflection and none of the 20 elements is curved: 0.5 %. The reference implementation of
  // the benchmarks, one point with hourglass control by a coefficient, has no bending stiffness with one layer but
  // that.
  TEST(SolidBending, OneLayerOfOnePointBricksBendsAsABeamWhateverTheAspectAndNu)
  {
    for (const double nu : {0., 0.3, 0.499})
      for (const double aspect : {1., 2., 10., 20.})
        {
          const double shear = 0.5 * (1. + nu) * std::pow(0.05 / aspect, 2); // E h^2/(4 G L^2)
          const Point3 size(20. * aspect, 1., 1.);
          EXPECT_NEAR(cantilever({20, 1, 1}, size, nu, SolidFormulation::one_point), 1. + shear, 5e-3)
            << "nu " << nu << ", aspect " << aspect;
        }
    for (const unsigned int n_layers : {2u, 3u, 4u})
      EXPECT_NEAR(cantilever({20, 1, n_layers}, Point3(100., 1., 1.), 0.3, SolidFormulation::one_point), 1., 5e-3)
        << n_layers;
  }

  // Why it is no element for thin blades with few layers: a hundred times too stiff at an aspect of 15.
  TEST(SolidBending, BBarLocksInShearAsItsTextSays)
  {
    for (const double nu : {0., 0.3})
      for (const double aspect : {5., 10., 20.})
        {
          const double stiffness = (2. / 3. + 0.5 * aspect * aspect) / (1. + nu);
          EXPECT_NEAR(cantilever({20, 1, 1}, Point3(20. * aspect, 1., 1.), nu, SolidFormulation::b_bar) * stiffness, 1.,
                      0.02)
            << "nu " << nu << ", aspect " << aspect;
        }
  }

  // Mindlin plate, clamped: 36.863, 230.15, 254.00 (torsion), 645.67 Hz, in plane, 791.08 (torsion), 1268.3.
  TEST(SolidBending, OneLayerHasTheFrequenciesOfTheBladePlate)
  {
    const auto coarse = plate_frequencies({14, 4, 1}, SolidFormulation::one_point, 7);
    EXPECT_NEAR(coarse[0] / 36.863, 1., 1e-3);
    EXPECT_NEAR(coarse[1] / 230.15, 1., 1e-3);
    EXPECT_NEAR(coarse[3] / 645.67, 1., 1e-2);
    const auto fine = plate_frequencies({28, 8, 1}, SolidFormulation::one_point, 7);
    EXPECT_NEAR(fine[0] / 36.863, 1., 1e-3);
    EXPECT_NEAR(fine[1] / 230.15, 1., 1e-3);
    EXPECT_NEAR(fine[2] / 254.00, 1., 1e-2) << "first torsion";
    EXPECT_NEAR(fine[3] / 645.67, 1., 1e-2);
    EXPECT_NEAR(fine[5] / 791.08, 1., 1e-2) << "second torsion";
    EXPECT_NEAR(fine[6] / 1268.3, 1., 1e-2);
    EXPECT_NEAR(std::log2((254.00 - coarse[2]) / (254.00 - fine[2])), 2., 0.8) << "order 2";
  }

  TEST(SolidBending, TheStressAtTheFacesIsThatOfTheBeam)
  {
    // tip force 1 N on 100 x 1 x 1 m, 20 bricks: M c/I at the middle of the tenth, far from the clamp
    const Point3      size(100., 1., 1.);
    Model             model(make_box({20, 1, 1}, size), make_section(1e9, 0.3));
    std::vector<bool> held(model.n_dofs(), false);
    Eigen::VectorXd   load = Eigen::VectorXd::Zero(model.n_dofs());
    for (std::size_t k = 0; k < model.mesh.nodes.size(); ++k)
      {
        const Point3 &x = model.mesh.nodes[k];
        for (int c = 0; c < 3; ++c)
          held[3 * k + c] = x[0] == 0. && (c == 0 || x[c] == 0.);
        if (x[0] > 99.9)
          load[3 * k + 2] = 0.25;
      }
    const Eigen::VectorXd u = model.solve(load, held);
    model.move(1e-6 * u);
    const double expected = 1e-6 * (100. - 47.5) * 0.5 * 12.;
    for (unsigned int corner = 0; corner < 8; ++corner)
      {
        const auto stress = model.elements.corner_stress(9, corner);
        EXPECT_NEAR(stress[0] / expected, corner < 4 ? 1. : -1., 0.005) << "corner " << corner;
        for (int c = 1; c < 3; ++c)
          EXPECT_NEAR(stress[c] / expected, 0., 0.02)
            << "nu times half the change of the moment along the brick, 1.4 %";
      }
  }

  TEST(SolidBending, OneBrickCarriesThePlasticMomentAndNoMore)
  {
    // a square plate bent about y with lateral curvature -1/2: uniaxial, M_p = s_y t^2/4
    const double t = 0.02;
    SolidSection section;
    section.material.hardening.law = HardeningLaw::perfect;
    section.linear_viscosity = section.quadratic_viscosity = 0.;
    Model      model(make_box({1, 1, 1}, Point3(1., 1., t)), section);
    const auto moment = [&](const double curvature) {
      Eigen::VectorXd u = Eigen::VectorXd::Zero(24);
      for (std::size_t k = 0; k < 8; ++k)
        {
          const Point3 x = model.mesh.nodes[k] - Point3(0.5, 0.5, 0.5 * t);
          u[3 * k]       = curvature * x[0] * x[2];
          u[3 * k + 1]   = -0.5 * curvature * x[1] * x[2];
        }
      const Eigen::VectorXd f   = model.move(u);
      double                sum = 0.;
      for (std::size_t k = 0; k < 8; ++k)
        if (model.mesh.nodes[k][0] == 1.)
          sum -= f[3 * k] * (model.mesh.nodes[k][2] - 0.5 * t);
      return sum;
    };
    const double yield = 880e6, elastic_limit = 2. * yield / (113.8e9 * t);
    double       last = 0.;
    for (int i = 0; i < 100; ++i)
      last = moment(0.1 * elastic_limit);
    EXPECT_NEAR(last / (yield * t * t / 4.), 1., 0.005);
    EXPECT_GT(model.elements.plastic_work(), 3. * model.elements.hourglass_energy());
    EXPECT_NEAR(model.elements.elastic_energy() / model.elements.plastic_work(), 0., 0.01) << "of the mean";
    // dissipated: moment times plastic curvature
    // elastic: a plate with lateral curvature -1/2
    const double nu = 0.342, stiffness = (1. - 0.5 * nu) / (1. - nu * nu) * 113.8e9 * t * t * t / 12.;
    EXPECT_NEAR(model.elements.plastic_work() / (last * (10. * elastic_limit - last / stiffness)), 1., 0.02);
    const double back = moment(-0.1 * elastic_limit);
    EXPECT_NEAR((last - back) / (0.1 * elastic_limit * stiffness), 1., 0.005) << "unloading is elastic";
  }
} // namespace solid_bending_test
