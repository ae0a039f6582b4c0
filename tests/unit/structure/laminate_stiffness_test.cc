#include "../record.h"
#include "laminate_case.h"

#include <gtest/gtest.h>

namespace laminate_stiffness_test
{
  using namespace laminate_case;

  // Section forces of laminated shells against classical lamination theory.
  namespace
  {
    const std::vector<std::vector<double>> stacks{
      {0.}, {30.}, {0., 90.}, {45., -45.}, {0., 90., 0}, {0., 30., 75.}, {0., 45., -45., 90., 90., -45., 45., 0.}};

    struct Forces
    {
      Point3                membrane, moment; ///< xx, yy, xy in global axes
      std::array<double, 2> shear;
    };

    /// A tensor of the element's axes in those that `turn` takes to x, y and z.
    Point3 in_global(const std::array<double, 3> &n, const Matrix3<double> &axes, const Matrix3<double> &turn)
    {
      Matrix3<double> local;
      local << n[0], n[2], 0., n[2], n[1], 0., 0., 0., 0.;
      const Matrix3<double> N = turn.transpose() * axes * local * axes.transpose() * turn;
      return {N(0, 0), N(1, 1), N(0, 1)};
    }

    /// Every element's forces for e + z k on the irregular patch, turned as a whole, its cells beginning at other
    /// nodes.
    std::vector<Forces> forces_of(const std::vector<PlyLayer> &plies, const double thickness,
                                  const ShellFormulation formulation, const Point3 &e, const Point3 &k,
                                  const Matrix3<double> &turn, const unsigned int first_node)
    {
      Mesh mesh = make_patch();
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        std::rotate(mesh.cells[c].begin(), mesh.cells[c].begin() + (first_node * (c + 1)) % 4, mesh.cells[c].end());
      const std::vector<Point3> flat = mesh.nodes;
      for (Point3 &x : mesh.nodes)
        x = turn * x;
      Model           model(mesh, thickness, section_of(carbon(), plies, formulation, turn * Point3(1., 0., 0.2)));
      Eigen::VectorXd u(model.n_dofs());
      for (std::size_t n = 0; n < flat.size(); ++n)
        {
          const double x = flat[n][0], y = flat[n][1];
          const Point3 displacement(e[0] * x + 0.5 * e[2] * y, e[1] * y + 0.5 * e[2] * x,
                                    -0.5 * (k[0] * x * x + k[1] * y * y + k[2] * x * y));
          const Point3 rotation(-(k[1] * y + 0.5 * k[2] * x), k[0] * x + 0.5 * k[2] * y, 0.);
          u.segment<3>(6 * n)     = turn * displacement;
          u.segment<3>(6 * n + 3) = turn * rotation;
        }
      model.move(u);
      std::vector<Forces> result;
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        {
          const ShellState s = model.elements.state(c);
          result.push_back(
            {in_global(s.membrane_force, s.axes, turn), in_global(s.moment, s.axes, turn), s.shear_force});
        }
      return result;
    }
  } // namespace

  TEST(LaminateStiffness, IsThatOfClassicalLaminationTheory)
  {
    const double    thickness = 2e-3, small = 1e-13; // nothing of second order is left
    double          worst = 0.;
    Matrix3<double> turn;
    turn = Eigen::AngleAxisd(0.7, Point3(1., 2., -0.5).normalized());
    for (const auto formulation : covariant_formulations)
      for (const auto &angles : stacks)
        for (const unsigned int first_node : {0u, 1u, 3u})
          for (int state = 0; state < 6; ++state)
            {
              Point3 e = Point3::Zero(), k = Point3::Zero();
              (state < 3 ? e : k)[state % 3] = state < 3 ? small : small / thickness;
              const ABD    theory            = lamination_theory(carbon(), equal_plies(angles), thickness);
              const Point3 N = theory.A * e + theory.B * k, M = theory.B * e + theory.D * k;
              const double size = theory.A.norm() * small;
              const auto   all  = forces_of(equal_plies(angles), thickness, formulation, e, k,
                                         first_node == 0 ? Matrix3<double>::Identity() : turn, first_node);
              for (const Forces &of : all)
                {
                  worst =
                    std::max({worst, (of.membrane - N).norm() / size, (of.moment - M).norm() / (size * thickness)});
                  EXPECT_LT((of.membrane - N).norm(), 1e-6 * size) << name_of(formulation) << state;
                  EXPECT_LT((of.moment - M).norm(), 1e-6 * size * thickness) << name_of(formulation) << state;
                  EXPECT_LT(std::hypot(of.shear[0], of.shear[1]), 1e-6 * size);
                }
            }
    record("largest error", worst);
  }

  // Plies of other thicknesses: shares of the whole.
  TEST(LaminateStiffness, TakesPliesOfUnequalThickness)
  {
    const std::vector<PlyLayer> plies{{0., 0.1}, {60., 0.55}, {-20., 0.35}};
    const ABD                   theory = lamination_theory(carbon(), plies, 1.);
    const Laminate              laminate(carbon(), plies, Point3::UnitX()), split(carbon(), plies, Point3::UnitX(), 3);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (const Laminate &of : {laminate, split})
          {
            EXPECT_NEAR(of.stiffness[i][j], theory.A(i, j), 1e-12 * theory.A.norm());
            EXPECT_NEAR(of.stiffness[i][j + 3], 2. * theory.B(i, j), 1e-12 * theory.A.norm());
            EXPECT_NEAR(of.stiffness[i + 3][j + 3], 4. * theory.D(i, j), 1e-12 * theory.A.norm());
          }
    EXPECT_EQ(split.layers.size(), 9u);
  }

  // Whitney (1973): 5/6 of one ply; of a sandwich its core alone yields. Factors of [0/90] by hand, of quadratic shear
  // stresses either side of the neutral plane.
  TEST(LaminateStiffness, ShearIsThatOfEquilibrium)
  {
    const Laminate one(carbon(), equal_plies({0.}), Point3::UnitX()),
      many(carbon(), equal_plies({0., 0., 0., 0., 0.}), Point3::UnitX());
    for (const Laminate &of : {one, many})
      {
        EXPECT_NEAR(of.shear[0], 5. / 6. * 6.9e9, 1.);
        EXPECT_NEAR(of.shear[1], 5. / 6. * 3.4e9, 1.);
        EXPECT_NEAR(of.shear[2], 0., 1.);
      }
    // without Poisson's ratio a strip of two materials: f by integrals of E (z - neutral plane)
    Ply ply                    = carbon();
    ply.poisson_12             = 0.;
    const double          E[2] = {ply.young_1, ply.young_2}, G[2] = {ply.shear_13, ply.shear_23};
    const double          middle = 0.25 * (E[1] - E[0]) / (E[0] + E[1]); // of the thickness
    double                stiff = 0., energy = 0., f = 0.;
    constexpr std::size_t n = 20000;
    std::array<double, n> first{};
    for (std::size_t i = 0; i < n; ++i)
      {
        const double z = (i + 0.5) / n - 0.5, modulus = E[z > 0.];
        stiff += modulus * (z - middle) * (z - middle) / n;
        f -= modulus * (z - middle) / n;
        first[i] = f - 0.5 * -modulus * (z - middle) / n;
      }
    for (std::size_t i = 0; i < n; ++i)
      energy += first[i] * first[i] / G[i >= n / 2] / n / (stiff * stiff);
    const Laminate cross(ply, equal_plies({0., 90.}), Point3::UnitX());
    EXPECT_NEAR(cross.shear[0] * energy, 1., 1e-6);
    EXPECT_NEAR(cross.shear[1], cross.shear[0], 1e-6 * cross.shear[0]);
  }

  TEST(LaminateStiffness, RefusesADirectionThatStandsOnTheElements)
  {
    EXPECT_THROW(
      Model(make_patch(), 1e-3,
            section_of(carbon(), equal_plies({0., 90.}), ShellFormulation::one_point_physical, Point3::UnitZ())),
      InputError);
  }

  // The whole motion is rigid: plies neither stretch nor forget their directions.
  TEST(LaminateStiffness, TurnsWithTheMaterial)
  {
    for (const auto formulation : covariant_formulations)
      {
        Model           model(warped_mesh(3, 3), 0.02,
                              section_of(carbon(), equal_plies({20., -50., 80.}), formulation, Point3(1., 0.3, 0.)));
        Eigen::VectorXd strain(model.n_dofs());
        for (Eigen::Index d = 0; d < strain.size(); ++d)
          strain[d] = 1e-5 * std::sin(1.7 * d);
        const Eigen::VectorXd before = model.move(strain);
        const double          energy = model.elements.elastic_energy();
        const int             n      = 2000;
        const Point3          axis   = Point3(1., -2., 0.5).normalized();
        Eigen::VectorXd       after;
        for (int step = 0; step < n; ++step)
          {
            const double          angle = 1.5 / n;
            const Matrix3<double> turn  = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
            Eigen::VectorXd       u(model.n_dofs());
            for (std::size_t k = 0; k < model.mesh.nodes.size(); ++k)
              {
                const Point3 x(&model.position[3 * k]);
                u.segment<3>(6 * k)     = turn * x - x;
                u.segment<3>(6 * k + 3) = angle * axis;
              }
            after = model.move(u);
          }
        const Matrix3<double> turn = Eigen::AngleAxisd(1.5, axis).toRotationMatrix();
        EXPECT_NEAR(model.elements.elastic_energy() / energy, 1., 1e-4) << name_of(formulation);
        for (std::size_t k = 0; k < model.mesh.nodes.size(); ++k)
          EXPECT_LT((after.segment<3>(6 * k) - turn * before.segment<3>(6 * k)).norm(), 1e-3 * before.norm());
      }
  }
} // namespace laminate_stiffness_test
