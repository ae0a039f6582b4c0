#include "solid_harness.h"

#include "structure/elements/solid/modes.h"
#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

namespace solid_shell_test
{
  using namespace solid_harness;

  namespace
  {
    constexpr double young = 113.8e9, t = 4.27e-3;
    constexpr double yield = 8.8e-3; ///< Pa, so low that nothing of second order in the strains is left
    constexpr double k_y   = 2. * yield / young / t;

    SolidSection make_plastic(const unsigned int n_points, const ThicknessRule rule, const double poisson,
                              const double flow_stress = yield)
    {
      SolidSection section             = make_section(young, poisson, SolidFormulation::solid_shell);
      section.material.hardening.law   = HardeningLaw::perfect;
      section.material.hardening.yield = flow_stress;
      section.rule                     = rule;
      section.n_points                 = n_points;
      return section;
    }

    /// A plate of 20 mm by 20 mm by t, one element, whose thickness is the given axis of the cell; x, y in its plane.
    Mesh make_plate(const unsigned int thickness_axis)
    {
      Mesh mesh         = make_box({1, 1, 1}, Point3(0.02, 0.02, t));
      const auto [i, j] = following(int(thickness_axis));
      const auto cell   = mesh.cells[0];
      for (unsigned int c = 0; c < 8; ++c)
        mesh.cells[0][(c & 1) << i | (c >> 1 & 1) << j | (c >> 2) << thickness_axis] = cell[c];
      return mesh;
    }

    struct Plate
    {
      Model           model;
      Eigen::VectorXd force;

      explicit Plate(const SolidSection &section, const unsigned int thickness_axis = 2)
        : model(make_plate(thickness_axis), section)
      {
      }

      /// Increments: strains and curvatures (1/m) along x and y, strain along z.
      void move(const double strain, const double curvature, const double lateral, const double lateral_curvature,
                const double across)
      {
        Eigen::VectorXd u = Eigen::VectorXd::Zero(24);
        for (std::size_t k = 0; k < 8; ++k)
          {
            const Point3 x = model.mesh.nodes[k] - Point3(0.01, 0.01, 0.5 * t);
            u[3 * k]       = (strain + curvature * x[2]) * x[0];
            u[3 * k + 1]   = (lateral + lateral_curvature * x[2]) * x[1];
            u[3 * k + 2]   = across * x[2];
          }
        force = model.move(u);
      }
      /// Uniaxial along x where nu = 1/2, elastic or plastic.
      void move(const double strain, const double curvature)
      {
        move(strain, curvature, -0.5 * strain, -0.5 * curvature, -0.5 * strain);
      }

      /// On the face x = 20 mm, over N_p and M_p.
      double stretching() const
      {
        return sum([](const Point3 &) { return 1.; }) / (yield * t);
      }
      double moment() const
      {
        return sum([](const Point3 &x) { return x[2] - 0.5 * t; }) / (yield * t * t / 4.);
      }
      double sum(const std::function<double(const Point3 &)> &arm) const
      {
        double total = 0.;
        for (std::size_t k = 0; k < 8; ++k)
          if (model.mesh.nodes[k][0] > 0.01)
            total -= force[3 * k] * arm(model.mesh.nodes[k]) / 0.02;
        return total;
      }
    };
  } // namespace

  // Benchmark A12: sum of w |z|; first yield is late by 1/|z_max|; without lateral curvature plane strain, 2/sqrt(3).
  TEST(SolidShell, PlasticMomentIsThatOfTheIntegration)
  {
    const auto bend = [](Plate &plate, const double curvature, const double lateral, const int n_steps) {
      for (int i = 0; i < n_steps; ++i)
        plate.move(0., curvature / n_steps, 0., lateral * curvature / n_steps, 0.);
      return plate.moment();
    };
    for (const auto &[n, exact, late] :
         {std::tuple(3u, .860663, 1.290994), std::tuple(5u, .944850, 1.103534), std::tuple(7u, .9705387, 1.053612)})
      {
        Plate plate(make_plastic(n, ThicknessRule::gauss, 0.));
        EXPECT_NEAR(bend(plate, 200. * k_y, -0.5, 200), exact, 1e-6);
        Plate early(make_plastic(n, ThicknessRule::gauss, 0.));
        EXPECT_NEAR(bend(early, 0.9999 * late * k_y, 0., 10) / (2. / 3. * 0.9999 * late), 1., 1e-6);
        EXPECT_EQ(early.model.elements.plastic_work(), 0.);
        EXPECT_LT(bend(early, 0.01 * late * k_y, 0., 1) / (2. / 3. * 1.0099 * late), 1. - 1e-4);
      }
    Plate lobatto(make_plastic(7, ThicknessRule::lobatto, 0.)), wide(make_plastic(5, ThicknessRule::gauss, 0.));
    EXPECT_NEAR(bend(lobatto, 200. * k_y, -0.5, 200), .959742, 1e-5);
    EXPECT_NEAR(bend(wide, 200. * k_y, 0., 200), .944850 * 2. / std::sqrt(3.), 1e-6);
  }

  // M/M_p = 1 - (k_y/k)^2/3 past first yield, back along M = E I k; bending both ways, then again (no hardening: the
  // same).
  TEST(SolidShell, BendsAndSpringsBackAsABeam)
  {
    Plate        plate(make_plastic(7, ThicknessRule::gauss, 0.4999));
    const double step = 0.02 * k_y;
    for (const double sign : {1., -1., 1.})
      {
        double k = 0., moment = 0., slope = 0.;
        for (k = 0.; k < 5. * k_y; k += step)
          plate.move(0., sign * step);
        moment = plate.moment();
        EXPECT_NEAR(sign * moment, 1. - 1. / 75., 0.03) << "of 7 points, whose plastic moment is 0.9705";
        plate.move(0., -sign * step);
        slope = sign * (moment - plate.moment()) / (2. / 3. * step / k_y);
        EXPECT_NEAR(slope, 1., 1e-3) << "elastic, nu is 0.4999";
        // to zero moment: what is left of the curvature is k - M/EI
        for (int i = 0; i < 20; ++i)
          plate.move(0., -1.5 * k_y * plate.moment());
        EXPECT_NEAR(plate.moment(), 0., 1e-3);
      }
    const auto  &e          = plate.model.elements;
    const double dissipated = e.plastic_work() / (yield * t * 4e-4); // mean plastic strain of all points
    EXPECT_GT(dissipated, 0.);
    EXPECT_NEAR(e.hourglass_energy(), 0., 1e-9 * e.plastic_work()) << "bending is no hourglass mode";
  }

  // Every point at +- s_y: N and M are those of the rule, with the neutral axis between its points. The volume is kept,
  // so the mean pressure is zero: the stress across is -1/3, that along 2/3 of N on the mean.
  TEST(SolidShell, StretchingAndBendingShareTheSection)
  {
    const auto rule = make_thickness_points(ThicknessRule::gauss, 7);
    for (const double axis : {-0.2, -0.55, 0.6, 0.85}) // zeta of the neutral axis
      {
        Plate        plate(make_plastic(7, ThicknessRule::gauss, 0.4999));
        const double step = 0.5 * k_y;
        for (int i = 0; i < 400; ++i)
          plate.move(-axis * 0.5 * t * step, step);
        double N = 0., M = 0.;
        for (unsigned int k = 0; k < rule.n; ++k)
          {
            const double sign = rule.position[k] > axis ? 0.5 : -0.5;
            N += sign * rule.weight[k];
            M += 2. * sign * rule.weight[k] * rule.position[k];
          }
        EXPECT_NEAR(plate.stretching(), 2. / 3. * N, 1e-3) << axis;
        EXPECT_NEAR(plate.moment(), M, 1e-3) << axis;
        EXPECT_NEAR(plate.moment(), 1. - N * N, 0.06) << "the exact section";
      }
  }

  TEST(SolidShell, AnyAxisOfTheCellMayBeTheThickness)
  {
    std::vector<double>                moment;
    std::vector<std::array<double, 6>> corner;
    for (unsigned int axis = 0; axis < 3; ++axis)
      {
        Plate plate(make_plastic(5, ThicknessRule::gauss, 0.3), axis);
        for (int i = 0; i < 20; ++i)
          plate.move(0., 0.2 * k_y);
        moment.push_back(plate.moment());
        const auto &cell = plate.model.mesh.cells[0];
        const auto  at   = std::find(cell.begin(), cell.end(), 7) - cell.begin(); // the node at (1, 1, 1)
        corner.push_back(plate.model.elements.corner_stress(0, unsigned(at)));
      }
    EXPECT_GT(moment[2], 0.85);
    for (int axis = 0; axis < 2; ++axis)
      {
        EXPECT_NEAR(moment[axis] / moment[2], 1., 1e-12);
        for (int c = 0; c < 6; ++c)
          EXPECT_NEAR(corner[axis][c], corner[2][c], 1e-9 * yield);
      }
    EXPECT_NEAR(corner[2][0] / yield, 1., 0.03) << "on the yield surface at the face, nearly uniaxial";
  }

  // Bricks that are higher than long, in one and in two layers: what counts is the way from skin to skin.
  TEST(SolidShell, TheThicknessIsTheShortWayThroughTheMesh)
  {
    for (const unsigned int n_layers : {1u, 2u})
      {
        const SolidSection section = make_plastic(5, ThicknessRule::gauss, 0.3);
        Mesh               mesh = make_box({12, 8, n_layers}, Point3(12., 8., 3.)), turned = mesh;
        for (auto &cell : turned.cells) // x, y, z of the mesh become the cell's third, first, second axis
          {
            const auto old = cell;
            for (unsigned int c = 0; c < 8; ++c)
              cell[c] = old[c >> 2 | (c & 1) << 1 | (c >> 1 & 1) << 2];
          }
        Model           a(mesh, section), b(turned, section);
        Eigen::VectorXd u(a.n_dofs()); // bent about y, fully plastic
        for (std::size_t k = 0; k < mesh.nodes.size(); ++k)
          {
            const Point3 x      = mesh.nodes[k] - Point3(6., 4., 1.5);
            u.segment<3>(3 * k) = 4. * yield / young * Point3(x[0] * x[2], -0.5 * x[1] * x[2], -0.5 * x[0] * x[0]);
          }
        const Eigen::VectorXd f = a.move(u);
        EXPECT_LT((f - b.move(u)).norm(), 1e-12 * f.norm());
        EXPECT_GT(a.elements.plastic_work(), 0.);
        EXPECT_NEAR(a.elements.plastic_work() / b.elements.plastic_work(), 1., 1e-12);
      }
  }

  TEST(SolidShell, PointsAppearWithTheStressThatThereWas)
  {
    SolidSection section = make_plastic(5, ThicknessRule::gauss, 0.3);
    Plate        late(section);
    section.material.hardening.law = HardeningLaw::elastic;
    Plate             elastic(section);
    const std::size_t before = late.model.elements.bytes();
    EXPECT_EQ(late.model.elements.n_promoted(), 0u);
    for (int i = 0; i < 10; ++i)
      {
        // twice the yield stress at the faces in the end; in the plane 0.2 of it, across the direction of bending
        late.move(0., 0.2 * k_y, 0.02 * yield / young, 0., 0.);
        elastic.move(0., 0.2 * k_y, 0.02 * yield / young, 0., 0.);
        const double difference = (late.force - elastic.force).norm() / elastic.force.norm();
        if (late.model.elements.plastic_work() == 0.)
          EXPECT_LT(difference, 1e-14) << "step " << i;
        else
          EXPECT_GT(difference, 1e-3);
      }
    EXPECT_GT(late.model.elements.plastic_work(), 0.);
    EXPECT_EQ(late.model.elements.n_promoted(), 1u);
    EXPECT_EQ(late.model.elements.bytes(), before + n_lanes * 5 * 8 * sizeof(double));
    EXPECT_EQ(elastic.model.elements.n_promoted(), 0u);
  }

  // A bent and stretched plastic plate is turned once by steps of ten degrees: points keep their stress, nothing flows.
  TEST(SolidShell, ATurnGivesThePointsTheirStressBack)
  {
    Plate        plate(make_plastic(5, ThicknessRule::gauss, 0.3, 880e6));
    const double first = 2. * 880e6 / young / t; // curvature of first yield
    for (int i = 0; i < 20; ++i)
      plate.move(1e-4, 0.2 * first, -2e-4, 0.1 * first, 0.);
    Model          &model  = plate.model;
    const Point3    axis   = Point3(1., 2., -0.5).normalized();
    const auto      before = model.elements.corner_stress(0, 5);
    const double    work   = model.elements.plastic_work();
    Eigen::VectorXd force, u(24);
    for (int i = 0; i < 36; ++i)
      {
        for (std::size_t k = 0; k < 8; ++k)
          {
            const Point3 x(&model.position[3 * k]);
            u.segment<3>(3 * k) = Eigen::AngleAxisd(M_PI / 18., axis) * x - x;
          }
        force = model.move(u);
      }
    for (int c = 0; c < 6; ++c)
      EXPECT_NEAR(model.elements.corner_stress(0, 5)[c], before[c], 1e-12 * young);
    EXPECT_LT((force - plate.force).norm(), 1e-10 * plate.force.norm());
    EXPECT_NEAR(model.elements.plastic_work() / work, 1., 1e-9);
  }

  TEST(SolidShell, RefusesWhatItCannot)
  {
    ThreadPool   pool(1);
    const Mesh   plate   = make_plate(2);
    SolidSection section = make_plastic(4, ThicknessRule::gauss, 0.3);
    const auto   make    = [&] { SolidElements elements(plate.nodes, plate.cells, section, pool); };
    EXPECT_THROW(make(), InputError) << "four points";
    section.n_points             = 5;
    section.material.failure.law = FailureLaw::plastic_strain;
    try
      {
        make();
        ADD_FAILURE() << "a failure law went by";
      }
    catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find("metal that fails"), std::string::npos) << error.what();
      }
  }
} // namespace solid_shell_test
