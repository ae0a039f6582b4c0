#include "shell_harness.h"

#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace shell_harness;

namespace
{
  const double pi = std::acos(-1.);

  Mesh warped_mesh(const unsigned int nx, const unsigned int ny)
  {
    return make_grid(nx, ny, [](const double x, const double y) {
      return Point3(x + 0.1 * y * y, y + 0.07 * std::sin(3. * x), 0.3 * x * y + 0.1 * x * x);
    });
  }

  ShellSection titanium(const HardeningLaw law, const double hardening = 0.,
                        const ShellFormulation formulation = ShellFormulation::one_point_physical)
  {
    ShellSection section;
    section.formulation                = formulation;
    section.material.hardening.law     = law;
    section.material.hardening.modulus = hardening;
    return section;
  }

  Eigen::VectorXd some_motion(const Model &model, const double size, const unsigned int seed)
  {
    Eigen::VectorXd u(model.n_dofs());
    for (Eigen::Index d = 0; d < u.size(); ++d)
      u[d] = size * std::sin(1. + 1.7 * d * (1 + seed) + seed);
    return u;
  }

  /// Moment over M_p = s_y t^2/4 of the perfectly plastic section of the blade plate at a curvature (1/m), nu = 0; the
  /// lateral curvature is the given share of it: -1/2 keeps the plastic state uniaxial, 0 the elastic one.
  double plastic_moment(const ThicknessRule rule, const unsigned int n_points, const double curvature,
                        const double           lateral     = 0.,
                        const ShellFormulation formulation = ShellFormulation::one_point_physical)
  {
    ShellSection section                = titanium(HardeningLaw::perfect, 0., formulation);
    section.rule                        = rule;
    section.n_points                    = n_points;
    section.material.elasticity.poisson = 0.; // uniaxial: lateral stress stays zero
    section.has_thinning                = false;
    const double    t                   = 4.27e-3;
    Model           model(make_grid(1, 1, [](const double x, const double y) { return Point3(x, y, 0.); }), t, section);
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

TEST(ShellElements, RigidMotionMakesNoForce)
{
  for (const auto formulation : covariant_formulations)
    {
      SCOPED_TRACE(name_of(formulation));
      // a small rotation, so that it is a rigid velocity field; warped and curved mesh, both about any axis and any
      // point
      const Model reference(warped_mesh(3, 3), 0.02, make_section(1., 0.3, formulation));
      for (int axis = 0; axis < 6; ++axis)
        {
          Model           model(reference.mesh, 0.02, reference.section);
          Eigen::VectorXd u = Eigen::VectorXd::Zero(model.n_dofs());
          for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
            if (axis < 3)
              {
                const Point3 w          = 1e-12 * Point3::Unit(axis);
                u.segment<3>(6 * n)     = w.cross(model.mesh.nodes[n]);
                u.segment<3>(6 * n + 3) = w;
              }
            else
              u[6 * n + axis - 3] = 1e-12;
          // 1e-12 E t of the largest strain would be 2e-26; what remains is round-off of the increments
          EXPECT_LT(model.move(u).cwiseAbs().maxCoeff(), 1e-12 * 0.02 * 1e-12) << "mode " << axis;
        }
    }
}

TEST(ShellElements, AFiniteRotationMakesForceOfThirdOrderAroundAnyNode)
{
  for (const auto formulation : covariant_formulations)
    {
      SCOPED_TRACE(name_of(formulation));
      // five elements around a node: its normal is no cross product of diagonals; the rim has nodes of one and two
      // elements
      Mesh mesh;
      mesh.nodes.push_back(Point3(0., 0., 0.2));
      for (int k = 0; k < 10; ++k)
        mesh.nodes.push_back((k % 2 ? 1.3 : 1.) *
                             Point3(std::cos(0.2 * pi * k), std::sin(0.2 * pi * k), 0.1 * std::sin(2. * k)));
      for (std::uint32_t k = 0; k < 5; ++k)
        mesh.cells.push_back({0, 2 * k + 1, 2 * k + 2, (2 * k + 2) % 10 + 1});
      const auto force = [&](const double angle) {
        Model                   model(mesh, 0.05, make_section(1., 0.3, formulation));
        const Point3            axis = Point3(1., 2., -0.5).normalized();
        const Eigen::AngleAxisd turn(angle, axis);
        Eigen::VectorXd         u(model.n_dofs());
        double                  largest = 0.;
        for (int step = 0; step < 2; ++step)
          {
            for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
              {
                const Point3 x(&model.position[3 * n]);
                u.segment<3>(6 * n)     = turn * x - x;
                u.segment<3>(6 * n + 3) = angle * axis;
              }
            largest = std::max(largest, model.move(u).cwiseAbs().maxCoeff());
          }
        return largest;
      };
      // E t = 0.05; an old normal in the place of the mean leaves first order
      EXPECT_LT(force(1e-3), 1e-9);
      EXPECT_NEAR(force(2e-3) / force(1e-3), 8., 0.1);
    }
}

TEST(ShellElements, HasSixRigidModesAndDrillingOnly)
{
  for (const auto formulation : covariant_formulations)
    {
      SCOPED_TRACE(name_of(formulation));
      for (const bool warped : {false, true})
        {
          const Mesh flat =
            make_grid(1, 1, [](const double x, const double y) { return Point3(x + .2 * y, y - .1 * x * y, 0.); });
          Model                 model(warped ? warped_mesh(1, 1) : flat, 0.05, make_section(1., 0.3, formulation));
          const Eigen::MatrixXd K = model.compute_stiffness();
          EXPECT_LT((K - K.transpose()).cwiseAbs().maxCoeff(), 1e-9 * K.cwiseAbs().maxCoeff());
          const Eigen::VectorXd values =
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (K + K.transpose())).eigenvalues();
          EXPECT_LT(std::abs(values[9]), 1e-10 * values[23]) << "6 rigid modes and 4 drilling rotations";
          EXPECT_GT(values[10], 1e-6 * values[23]);
        }
    }
}

TEST(ShellElements, BelytschkoTsayWithoutHourglassControlHasItsKnownModes)
{
  ShellSection section          = make_section(1., 0.3, ShellFormulation::belytschko_tsay);
  section.hourglass_coefficient = 0.;
  const Mesh square             = make_grid(1, 1, [](const double x, const double y) { return Point3(x, y, 0.); });
  Model      bare(square, 0.05, section);
  const auto count = [](Model &model) {
    const Eigen::MatrixXd K = model.compute_stiffness();
    const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (K + K.transpose())).eigenvalues();
    int n = 0;
    for (Eigen::Index i = 0; i < values.size(); ++i)
      n += std::abs(values[i]) < 1e-10 * values[23];
    return n;
  };
  // 20 degrees of freedom without drilling, 8 strains: 12, of which 6 rigid, 5 hourglass, 1 in-plane twist
  EXPECT_EQ(count(bare), 16);
  section.hourglass_coefficient = 0.05;
  Model controlled(square, 0.05, section);
  EXPECT_EQ(count(controlled), 11) << "the in-plane twist stays; a mesh does not have it";
}

TEST(ShellElements, ForcesBalance)
{
  for (const auto formulation : all_formulations)
    {
      Model                 model(warped_mesh(3, 2), 0.05, make_section(1., 0.3, formulation));
      const Eigen::VectorXd f     = model.move(some_motion(model, 1e-2, 3));
      Point3                force = Point3::Zero(), moment = Point3::Zero();
      for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
        {
          const Point3 x(&model.position[3 * n]);
          force += f.segment<3>(6 * n);
          moment += x.cross(f.segment<3>(6 * n)) + Point3(f.segment<3>(6 * n + 3));
        }
      EXPECT_LT(force.norm(), 1e-14 * f.norm());
      // of plain Belytschko-Tsay only while the element is plane
      if (formulation != ShellFormulation::belytschko_tsay)
        {
          EXPECT_LT(moment.norm(), 1e-13 * f.norm());
        }
    }
}

TEST(ShellElements, TheMomentHasNoPartAlongTheNodalNormal)
{
  for (const auto formulation : covariant_formulations)
    {
      SCOPED_TRACE(name_of(formulation));
      Model                 model(warped_mesh(2, 2), 0.05, make_section(1., 0.3, formulation));
      const Eigen::VectorXd f        = model.move(some_motion(model, 1e-12, 5));
      Eigen::VectorXd       drilling = Eigen::VectorXd::Zero(model.n_dofs());
      const Point3          normal =
        Point3(model.mesh.nodes[5] - model.mesh.nodes[3]).cross(model.mesh.nodes[7] - model.mesh.nodes[1]);
      EXPECT_LT(std::abs(normal.normalized().dot(f.segment<3>(6 * 4 + 3))), 2e-2 * f.segment<3>(6 * 4 + 3).norm());
    }
}

TEST(ShellElements, EnergiesSumToTheWorkOfTheForces)
{
  for (const auto formulation : covariant_formulations)
    {
      SCOPED_TRACE(name_of(formulation));
      Model           model(warped_mesh(3, 3), 0.05, titanium(HardeningLaw::linear, 1e9, formulation));
      Eigen::VectorXd old  = Eigen::VectorXd::Zero(model.n_dofs());
      double          work = 0.;
      for (unsigned int step = 0; step < 20; ++step)
        {
          const Eigen::VectorXd u = some_motion(model, 2e-3, step);
          const Eigen::VectorXd f = model.move(u, 1e-6);
          work -= 0.5 * (f + old).dot(u);
          old = f;
        }
      const auto  &e   = model.elements;
      const double sum = e.elastic_energy() + e.plastic_work() + e.hourglass_energy();
      EXPECT_NEAR(sum / work, 1., 1e-12);
      EXPECT_GT(e.plastic_work(), 0.1 * work);
      EXPECT_GT(e.n_promoted(), 0u);
      EXPECT_EQ(e.hourglass_energy() == 0., formulation == ShellFormulation::fully_integrated);
    }
}

TEST(ShellElements, ThroughThicknessIntegrationOfThePlasticMoment)
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

TEST(ShellElements, PointsAppearWithTheStressThatThereWas)
{
  for (const auto formulation : covariant_formulations)
    {
      SCOPED_TRACE(name_of(formulation));
      // the same history with points from the start (one element yields first) and without
      ShellSection section = titanium(HardeningLaw::linear, 1e9, formulation);
      Model        late(warped_mesh(1, 1), 0.05, section);
      const auto   motion            = [&](const Model &m, const int step) { return some_motion(m, 8e-3, step); };
      section.material.hardening.law = HardeningLaw::elastic;
      Model elastic(warped_mesh(1, 1), 0.05, section);
      int   first = -1;
      for (int step = 0; step < 12; ++step)
        {
          const Eigen::VectorXd a = late.move(motion(late, step), 1e-6), b = elastic.move(motion(elastic, step), 1e-6);
          if (late.elements.n_promoted() == 0)
            EXPECT_EQ((a - b).norm(), 0.) << "an elastic law and an element that has not yielded do the same";
          else if (first < 0)
            {
              first = step;
              EXPECT_NEAR((a - b).norm() / b.norm(), 0., 0.9);
            }
        }
      EXPECT_GE(first, 0);
    }
}

TEST(ShellElements, ThatHaveNeverYieldedHoldNoPoints)
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

TEST(ShellElements, FullyIntegratedYieldPointByPoint)
{
  // one corner of a unit square turns: director (k x y, 0, 1), curvature k_xx = k y and 2 k_xy = k x, nu = 0: von Mises
  // stress E t/2 k sqrt(y^2 + 3/4 x^2), largest at the point x = y = 0.789, 0.78 of that at the next one
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
  EXPECT_GT(e.max_plastic_strain().value, 1e-4);
  EXPECT_EQ(e.layer_plastic_strain(0, ShellLayer::top), e.max_plastic_strain().value);
  EXPECT_EQ(e.state(0).max_plastic_strain, e.max_plastic_strain().value);
  EXPECT_EQ(e.layer_plastic_strain(0, ShellLayer::middle), 0.);
}

TEST(ShellElements, StabilisationOfAPlasticElementIsCapped)
{
  // membrane hourglass mode on an element that is stretched far beyond yield: the force stays near that of yield stress
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

TEST(ShellElements, ThreadsDoNotChangeABit)
{
  for (const auto formulation : covariant_formulations)
    {
      SCOPED_TRACE(name_of(formulation));
      const auto run = [formulation](const std::size_t n_threads) {
        Model           model(warped_mesh(35, 31), 0.01, titanium(HardeningLaw::linear, 1e9, formulation), n_threads);
        Eigen::VectorXd f;
        for (unsigned int step = 0; step < 5; ++step)
          f = model.move(some_motion(model, 3e-4, step), 1e-6);
        return std::pair(f, model.elements.plastic_work());
      };
      const auto one = run(1), two = run(2), three = run(3);
      EXPECT_GT(one.second, 0.);
      EXPECT_TRUE(one.first == two.first && one.first == three.first);
      EXPECT_EQ(one.second, two.second);
    }
}

TEST(ShellElements, AnyOrderOfCellsGivesTheSameForces)
{
  for (const auto formulation : covariant_formulations)
    {
      SCOPED_TRACE(name_of(formulation));
      // more than one block of elements; shuffled, nodes enter in one block and leave in any other
      const Mesh ordered  = warped_mesh(130, 90);
      Mesh       shuffled = ordered;
      std::shuffle(shuffled.cells.begin(), shuffled.cells.end(), std::mt19937(11));
      const auto run = [formulation](const Mesh &mesh, const std::size_t n_threads) {
        Model           model(mesh, 0.01, titanium(HardeningLaw::linear, 1e9, formulation), n_threads);
        Eigen::VectorXd f;
        for (unsigned int step = 0; step < 3; ++step)
          f = model.move(some_motion(model, 3e-5, step), 1e-6);
        return std::pair(f, model.elements.elastic_energy());
      };
      const auto a = run(ordered, 1), b = run(shuffled, 1), c = run(shuffled, 2);
      EXPECT_GT(a.second, 0.);
      EXPECT_LT((a.first - b.first).cwiseAbs().maxCoeff(), 1e-11 * a.first.cwiseAbs().maxCoeff());
      EXPECT_NEAR(b.second / a.second, 1., 1e-12);
      EXPECT_TRUE(b.first == c.first);
      EXPECT_EQ(b.second, c.second);
    }
}

TEST(ShellElements, RefusesWhatCannotBe)
{
  ThreadPool   pool(1);
  const Mesh   square  = make_grid(1, 1, [](const double x, const double y) { return Point3(x, y, 0.); });
  ShellSection section = make_section(1., 0.3);
  EXPECT_THROW(ShellElements(square.nodes, square.cells, {-1.}, section, pool), InputError);
  EXPECT_THROW(ShellElements(square.nodes, {{0, 1, 1, 0}}, {1.}, section, pool), InputError);
  // an arrow: its Jacobian is negative at a point of the full integration, and area and edges are sound
  Mesh arrow         = square;
  arrow.nodes[0]     = {0.85, 0.85, 0.};
  ShellSection whole = make_section(1., 0.3, ShellFormulation::fully_integrated);
  EXPECT_NO_THROW(ShellElements(arrow.nodes, arrow.cells, {1.}, section, pool));
  EXPECT_THROW(ShellElements(arrow.nodes, arrow.cells, {1.}, whole, pool), InputError);
  section.n_points = 4;
  EXPECT_THROW(ShellElements(square.nodes, square.cells, {1.}, section, pool), InputError);
  for (const auto formulation : all_formulations)
    {
      Model           model(square, 0.1, make_section(1., 0.3, formulation));
      Eigen::VectorXd u = Eigen::VectorXd::Zero(24);
      u[7]              = std::nan("");
      EXPECT_THROW(model.move(u), NumericalFailure) << name_of(formulation);
    }
  Model           folded(square, 0.1, whole);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(24);
  u[0] = u[1] = 0.85;
  EXPECT_THROW(folded.move(u), NumericalFailure) << "the arrow of above";
}
