#include "matrices.h"
#include "shell_harness.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/core/numerical_failure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace shell_elements_test
{
  using namespace shell_harness;

  namespace
  {
    const double pi = std::acos(-1.);
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
            const Eigen::VectorXd values = test::symmetric_eigenvalues(test::symmetric_part(K));
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
      const Eigen::MatrixXd K      = model.compute_stiffness();
      const Eigen::VectorXd values = test::symmetric_eigenvalues(test::symmetric_part(K));
      int                   n      = 0;
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
        const Eigen::VectorXd f     = model.move(some_motion(model.n_dofs(), 1e-2, 3));
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
        const Eigen::VectorXd f        = model.move(some_motion(model.n_dofs(), 1e-12, 5));
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
        const int       n    = 20; // parts of a motion that would bring the points past yield in one step
        for (unsigned int step = 0; step < 20 * n; ++step)
          {
            const Eigen::VectorXd u = some_motion(model.n_dofs(), 2e-3, step / n) / n;
            const Eigen::VectorXd f = model.move(u, 1e-6);
            work -= 0.5 * (f + old).dot(u);
            old = f;
          }
        const auto  &e   = model.elements;
        const double sum = e.elastic_energy() + e.plastic_work() + e.hourglass_energy();
        EXPECT_NEAR(e.work() / work, 1., 1e-12);
        EXPECT_NEAR(sum / work, 1., 0.02) << "strains of 2 % and trapezoids across the corner of yielding";
        EXPECT_GT(e.plastic_work(), 0.1 * work);
        EXPECT_GT(e.n_promoted(), 0u);
        EXPECT_EQ(e.hourglass_energy() == 0., formulation == ShellFormulation::fully_integrated);
      }
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
            f = model.move(some_motion(model.n_dofs(), 3e-4, step), 1e-6);
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
            f = model.move(some_motion(model.n_dofs(), 3e-5, step), 1e-6);
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
    // a corner of the middle one of nine beyond its opposite: the area, of a normal of its own, is positive
    const Mesh nine = make_grid(3, 3, [](const double x, const double y) { return Point3(x, y, 0.); });
    for (const auto formulation : all_formulations)
      {
        Model           turned(nine, 0.01, make_section(1., 0.3, formulation));
        Eigen::VectorXd u = Eigen::VectorXd::Zero(6 * 16);
        u[6 * 5] = u[6 * 5 + 1] = 0.5;
        try
          {
            turned.move(u);
            ADD_FAILURE() << name_of(formulation);
          }
        catch (const NumericalFailure &failure)
          {
            EXPECT_NE(std::string(failure.what()).find("turned inside out"), std::string::npos) << failure.what();
            const bool sees_arrows = formulation == ShellFormulation::fully_integrated; // beside it
            EXPECT_TRUE(sees_arrows || failure.facts().where.id == 4u) << failure.what();
          }
      }
    Model           folded(square, 0.1, whole);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(24);
    u[0] = u[1] = 0.85;
    EXPECT_THROW(folded.move(u), NumericalFailure) << "the arrow of above";
  }
} // namespace shell_elements_test
