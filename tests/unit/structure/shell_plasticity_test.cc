#include "shell_harness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shell_plasticity_test
{
  using namespace shell_harness;

  namespace
  {
    /// Moment over M_p = s_y t^2/4 of the perfectly plastic section of the blade plate at a curvature (1/m), nu = 0;
    /// the lateral curvature is the given share of it: -1/2 keeps the plastic state uniaxial, 0 the elastic one. The
    /// element is so small that directors turn by less than 4e-4 even at 1e8 times the curvature of first yield.
    double plastic_moment(const ThicknessRule rule, const unsigned int n_points, const double curvature,
                          const double           lateral     = 0.,
                          const ShellFormulation formulation = ShellFormulation::one_point_physical)
    {
      ShellSection section                = titanium(HardeningLaw::perfect, 0., formulation);
      section.rule                        = rule;
      section.n_points                    = n_points;
      section.material.elasticity.poisson = 0.; // uniaxial: lateral stress stays zero
      section.has_thinning                = false;
      const double t = 4.27e-3, side = 1e-12;
      Model model(make_grid(1, 1, [=](const double x, const double y) { return Point3(side * x, side * y, 0.); }), t,
                  section);
      const double    k = curvature;
      Eigen::VectorXd u = Eigen::VectorXd::Zero(model.n_dofs());
      for (std::size_t n = 0; n < 4; ++n) // director d = (x k, 0, 1): rotation about y
        {
          u[6 * n + 4] = k * model.mesh.nodes[n][0];
          u[6 * n + 3] = -lateral * k * model.mesh.nodes[n][1];
        }
      model.move(u);
      return model.elements.state(0).moment[0] / (section.material.hardening.yield * t * t / 4.);
    }
  } // namespace

  TEST(ShellPlasticity, ThroughThicknessIntegrationOfThePlasticMoment)
  {
    for (const auto formulation : covariant_formulations)
      {
        SCOPED_TRACE(name_of(formulation));
        // sum of w |z| for Gauss, tabulated; the moment at a curvature 1e8 times that of first yield
        const double k_y = 2. * 880e6 / 113.8e9 / 4.27e-3;
        EXPECT_NEAR(k_y, 3.62195, 1e-5);
        EXPECT_NEAR(plastic_moment(ThicknessRule::gauss, 3, 1e8 * k_y, -0.5, formulation), 0.860663, 1e-6);
        EXPECT_NEAR(plastic_moment(ThicknessRule::gauss, 5, 1e8 * k_y, -0.5, formulation), 0.944850, 1e-6);
        EXPECT_NEAR(plastic_moment(ThicknessRule::gauss, 7, 1e8 * k_y, -0.5, formulation), 0.9705387, 1e-6);
        // M_e/M_p = 2/3; first yield of the points is late by 1/|z_max|: still elastic just below it
        for (const auto &[n, late] : {std::pair(3u, 1.290994), std::pair(5u, 1.103534), std::pair(7u, 1.053612)})
          {
            EXPECT_NEAR(plastic_moment(ThicknessRule::gauss, n, 0.9999 * late * k_y, 0., formulation) /
                          (2. / 3. * 0.9999 * late),
                        1., 1e-12);
            EXPECT_LT(plastic_moment(ThicknessRule::gauss, n, 1.01 * late * k_y, 0., formulation) /
                        (2. / 3. * 1.01 * late),
                      1. - 1e-4);
          }
        // 2/21 + ... of the Lobatto weights; no lateral curvature: plane strain, 2/sqrt(3)
        EXPECT_NEAR(plastic_moment(ThicknessRule::lobatto, 7, 1e8 * k_y, -0.5, formulation), 0.959742, 1e-5);
        EXPECT_NEAR(plastic_moment(ThicknessRule::gauss, 5, 1e8 * k_y, 0., formulation), 0.944850 * 2. / std::sqrt(3.),
                    1e-6);
      }
  }

  TEST(ShellPlasticity, PointsAppearWithTheStressThatThereWas)
  {
    for (const auto formulation : covariant_formulations)
      {
        SCOPED_TRACE(name_of(formulation));
        // the same history with points from the start (one element yields first) and without
        ShellSection section = titanium(HardeningLaw::linear, 1e9, formulation);
        Model        late(warped_mesh(1, 1), 0.05, section);
        const auto   motion = [&](const Model &m, const int step) { return some_motion(m.n_dofs(), 8e-3, step); };
        section.material.hardening.law = HardeningLaw::elastic;
        Model elastic(warped_mesh(1, 1), 0.05, section);
        for (int step = 0; step < 12; ++step)
          {
            const Eigen::VectorXd a = late.move(motion(late, step), 1e-6),
                                  b = elastic.move(motion(elastic, step), 1e-6);
            if (late.elements.n_promoted() > 0)
              break;
            EXPECT_EQ((a - b).norm(), 0.) << "an elastic law and an element that has not yielded do the same";
          }
        EXPECT_GT(late.elements.n_promoted(), 0u);
      }
  }

  TEST(ShellPlasticity, PointsCarryWhatTheClosedFormDid)
  {
    // beside an element that yields, in its register, one that does not: it gets points, and forces as without them
    for (const auto formulation : covariant_formulations)
      {
        SCOPED_TRACE(name_of(formulation));
        const ShellSection section = titanium(HardeningLaw::linear, 1e9, formulation);
        Mesh               both    = warped_mesh(1, 1);
        for (std::size_t n = 0; n < 4; ++n)
          both.nodes.push_back(both.nodes[n] + Point3(10., 0., 0.));
        both.cells.push_back({4, 5, 7, 6});
        Model together(both, 0.05, section), alone(warped_mesh(1, 1), 0.05, section);
        for (int step = 0; step < 12; ++step)
          {
            const Eigen::VectorXd small = some_motion(24, 2e-4, step);
            Eigen::VectorXd       u(48);
            u << small, some_motion(24, 8e-3, step);
            const Eigen::VectorXd f = alone.move(small, 1e-6);
            EXPECT_LT((together.move(u, 1e-6).head(24) - f).norm(), 1e-11 * f.norm()) << step;
          }
        EXPECT_EQ(alone.elements.n_promoted(), 0u);
        EXPECT_GT(together.elements.n_promoted(), 0u);
      }
  }

  TEST(ShellPlasticity, PriceOfAStepHangsOnNoOrderOfElements)
  {
    for (const auto formulation : covariant_formulations)
      {
        SCOPED_TRACE(name_of(formulation));
        // one end of a strip yields: neighbours in one register, or each in another
        const auto strip = make_grid(64, 1, [](const double x, const double y) { return Point3(64. * x, y, 0.); });
        auto       mixed = strip;
        for (std::size_t k = 0; k < strip.cells.size(); ++k)
          mixed.cells[k] = strip.cells[13 * k % strip.cells.size()];
        const ShellSection section = titanium(HardeningLaw::linear, 1e9, formulation);
        Model              a(strip, 0.05, section), b(mixed, 0.05, section);
        const double       elastic = a.elements.prices().of_step;
        Eigen::VectorXd    stretch = Eigen::VectorXd::Zero(a.n_dofs());
        for (std::size_t n = 0; n < strip.nodes.size(); ++n)
          stretch[6 * n] = 0.02 * std::max(0., strip.nodes[n][0] - 61.);
        for (Model *model : {&a, &b})
          model->move(stretch);
        EXPECT_LT(a.elements.n_promoted(), b.elements.n_promoted());
        EXPECT_EQ(a.elements.prices().of_step, b.elements.prices().of_step);
        EXPECT_GT(a.elements.prices().of_step, elastic);
      }
  }

  TEST(ShellPlasticity, ThatHaveNeverYieldedHoldNoPoints)
  {
    for (const auto formulation : covariant_formulations)
      {
        SCOPED_TRACE(name_of(formulation));
        // a strip of 64 elements, one end of which is stretched beyond yield
        Model model(make_grid(64, 1, [](const double x, const double y) { return Point3(64. * x, y, 0.); }), 0.05,
                    titanium(HardeningLaw::linear, 1e9, formulation));
        const std::size_t before  = model.elements.bytes();
        Eigen::VectorXd   stretch = Eigen::VectorXd::Zero(model.n_dofs());
        model.move(stretch);
        EXPECT_EQ(model.elements.n_promoted(), 0u);
        EXPECT_EQ(model.elements.bytes(), before);
        for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
          stretch[6 * n] = 0.02 * std::max(0., model.mesh.nodes[n][0] - 62.);
        model.move(stretch);
        // the two stretched elements, and those that share their register: five points of six numbers each
        const std::size_t n_sections = formulation == ShellFormulation::fully_integrated ? 4 : 1;
        EXPECT_EQ(model.elements.n_promoted(), n_lanes);
        EXPECT_EQ(model.elements.bytes(), before + n_sections * n_lanes * 5 * 6 * sizeof(double));
      }
  }

  TEST(ShellPlasticity, FullyIntegratedYieldPointByPoint)
  {
    // one corner of a unit square turns: director (k x y, 0, 1), curvature k_xx = k y and 2 k_xy = k x, nu = 0: von
    // Mises stress E t/2 k sqrt(y^2 + 3/4 x^2), largest at the point x = y = 0.789, 0.78 of that at the next one
    ShellSection section                = titanium(HardeningLaw::perfect, 0., ShellFormulation::fully_integrated);
    section.material.elasticity.poisson = 0.;
    section.has_thinning                = false;
    const double t = 0.01, yield = section.material.hardening.yield, young = section.material.elasticity.young;
    const double first = 2. * yield / young / t / ((0.5 + 0.5 / std::sqrt(3.)) * std::sqrt(1.75));
    Model        model(make_grid(1, 1, [](const double x, const double y) { return Point3(x, y, 0.); }), t, section);
    const auto  &e    = model.elements;
    const auto   bend = [&](const double curvature) {
      Eigen::VectorXd u = Eigen::VectorXd::Zero(24);
      u[6 * 3 + 4]      = curvature; // about y, of the corner x = y = 1
      model.move(u);
    };
    const std::size_t before = e.bytes();
    bend(0.99 * first);
    EXPECT_EQ(e.n_promoted(), 0u);
    EXPECT_NEAR(e.state(0).moment[0] / (0.5 * 0.99 * first * young * t * t * t / 12.), 1., 1e-12) << "mean of k y";
    // the outermost Gauss point is at 0.906 of the face
    bend(0.17 * first);
    EXPECT_EQ(e.n_promoted(), 1u);
    EXPECT_EQ(e.bytes(), before + n_lanes * 5 * 6 * sizeof(double)) << "one section holds five points";
    EXPECT_GT(e.max_plastic_strains().front().value, 1e-4);
    EXPECT_EQ(e.layer_plastic_strain(0, ShellLayer::top), e.max_plastic_strains().front().value);
    EXPECT_EQ(e.state(0).max_plastic_strain, e.max_plastic_strains().front().value);
    EXPECT_EQ(e.layer_plastic_strain(0, ShellLayer::middle), 0.);
  }

  TEST(ShellPlasticity, StressIsThatOfTheOutermostPointBeforeItIsKept)
  {
    // A square that is bent, E t/2 k at the face and x times this at the outermost point, with nu = 0: once the face
    // meets the yield stress points are made, and none of them flows yet. The stress goes on in proportion, to
    // round-off.
    for (const auto formulation : all_formulations)
      for (const unsigned int n_points : {3u, 5u, 7u})
        {
          ShellSection section                = titanium(HardeningLaw::perfect, 0., formulation);
          section.material.elasticity.poisson = 0.;
          section.has_thinning                = false;
          section.n_points                    = n_points;
          const double t = 0.01, yield = section.material.hardening.yield, young = section.material.elasticity.young;
          Model model(make_grid(1, 1, [](const double x, const double y) { return Point3(x, y, 0.); }), t, section);
          const auto     &e    = model.elements;
          const double    x    = e.thickness_points(0).position[n_points - 1];
          Eigen::VectorXd bend = Eigen::VectorXd::Zero(24);
          for (const unsigned int corner : {1u, 3u})
            bend[6 * corner + 4] = 0.99 * 2. * yield / young / t; // about y
          model.move(bend);
          EXPECT_EQ(e.n_promoted(), 0u);
          EXPECT_NEAR(std::abs(e.layer_stress(0, ShellLayer::top)[0]) / (0.99 * x * yield), 1., 1e-9);
          EXPECT_EQ(e.layer_stress(0, ShellLayer::top)[0], e.point_state(0, x).stress[0]);
          model.move(bend * (0.02 / 0.99));
          EXPECT_EQ(e.n_promoted(), 1u);
          EXPECT_EQ(e.max_plastic_strains().front().value, 0.);
          EXPECT_NEAR(std::abs(e.layer_stress(0, ShellLayer::top)[0]) / (1.01 * x * yield), 1., 1e-9);
          EXPECT_NEAR(e.layer_stress(0, ShellLayer::bottom)[0] / e.layer_stress(0, ShellLayer::top)[0], -1., 1e-9);
        }
  }

  TEST(ShellPlasticity, StabilisationOfAPlasticElementIsCapped)
  {
    // membrane hourglass mode on an element that is stretched far beyond yield: the force stays near that of yield
    // stress
    const double    t = 0.01;
    Model           model(make_grid(1, 1, [](const double x, const double y) { return Point3(x, y, 0.); }), t,
                          titanium(HardeningLaw::perfect));
    Eigen::VectorXd stretch = Eigen::VectorXd::Zero(24), hourglass = Eigen::VectorXd::Zero(24);
    for (std::size_t n = 0; n < 4; ++n)
      {
        stretch[6 * n]   = 1e-3 * model.mesh.nodes[n][0];
        hourglass[6 * n] = 1e-3 * (n == 0 || n == 3 ? 1. : -1.);
      }
    for (int i = 0; i < 20; ++i)
      model.move(stretch);
    for (int i = 0; i < 100; ++i)
      model.move(hourglass);
    const auto &e = model.elements;
    EXPECT_GT(e.plastic_work(), 0.);
    EXPECT_GT(e.hourglass_energy(), 0.);
    const Eigen::VectorXd f = model.move(Eigen::VectorXd::Zero(24));
    EXPECT_LT(f.cwiseAbs().maxCoeff(), 880e6 * 1.16 * t);
  }

  // Round-off decides the sign of a stabilisation stress that nothing has driven yet. The first step of its mode on a
  // plastic element is the same from either side of zero: it loads at the modulus of flow, however little it unloads
  // before.
  TEST(ShellPlasticity, TheSignOfAStabilisationStressOfRoundOffDoesNotMatter)
  {
    const auto force_after = [](const bool bends, const double before, const double drive) {
      Model           model(make_grid(1, 1, [](const double x, const double y) { return Point3(x, y, 0.); }), 0.01,
                            titanium(HardeningLaw::perfect));
      Eigen::VectorXd stretch = Eigen::VectorXd::Zero(24), hourglass = Eigen::VectorXd::Zero(24);
      for (std::size_t n = 0; n < 4; ++n)
        {
          stretch[6 * n]                     = 1e-3 * model.mesh.nodes[n][0];
          hourglass[6 * n + (bends ? 4 : 0)] = n == 0 || n == 3 ? 1. : -1.;
        }
      for (int i = 0; i < 20; ++i)
        model.move(stretch);
      model.move(stretch + before * hourglass);
      return Eigen::VectorXd(model.move(stretch + drive * hourglass));
    };
    for (const bool bends : {false, true})
      {
        const Eigen::VectorXd up = force_after(bends, 1e-15, 1e-6), down = force_after(bends, -1e-15, 1e-6);
        const double          driven = (up - force_after(bends, 1e-15, 0.)).norm();
        EXPECT_GT(driven, 0.);
        EXPECT_LT((up - down).norm(), 1e-6 * driven) << bends;
      }
  }
} // namespace shell_plasticity_test
