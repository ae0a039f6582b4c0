#include "../record.h"
#include "shell_harness.h"

#include <gtest/gtest.h>

namespace shell_patch_test
{
  using namespace shell_harness;

  namespace
  {
    const Matrix3<double> some_rotation = (Eigen::AngleAxisd(0.7, Point3(1., 2., -1.).normalized())).toRotationMatrix();

    /// u = field(x) on the corners (held), the four inner nodes free; returns the largest error there over the largest
    /// value.
    double patch_error(const Mesh &plane, const ShellSection &section, const double thickness, const Matrix3<double> &R,
                       const Point3 &shift, const std::function<std::array<double, 6>(double, double)> &field,
                       const std::function<bool(std::size_t)> &is_held, std::unique_ptr<Model> *loaded = nullptr)
    {
      Mesh mesh = plane;
      for (auto &x : mesh.nodes)
        x = R * x + shift;
      Model             model(mesh, thickness, section);
      std::vector<bool> held(model.n_dofs(), false);
      Eigen::VectorXd   exact(model.n_dofs());
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        {
          const auto f                = field(plane.nodes[n][0], plane.nodes[n][1]);
          exact.segment<3>(6 * n)     = R * Point3(f[0], f[1], f[2]);
          exact.segment<3>(6 * n + 3) = R * Point3(f[3], f[4], f[5]);
          for (int c = 0; c < 6; ++c)
            held[6 * n + c] = is_held(n);
        }
      const Eigen::VectorXd u     = model.solve(Eigen::VectorXd::Zero(model.n_dofs()), held, exact);
      double                error = 0.;
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        {
          // in the plane's own axes; drilling has no stiffness and is left out
          const Point3 du       = R.transpose() * (u - exact).segment<3>(6 * n);
          const Point3 dr       = R.transpose() * (u - exact).segment<3>(6 * n + 3);
          const double in_plane = du.head<2>().norm(), bending = std::abs(du[2]) + thickness * dr.head<2>().norm();
          error = std::max(error, (in_plane + bending) / exact.cwiseAbs().maxCoeff());
        }
      if (loaded)
        {
          *loaded = std::make_unique<Model>(mesh, thickness, section);
          (*loaded)->move(1e-12 * exact);
        }
      return error;
    }

    bool is_corner(const std::size_t n)
    {
      return n < 4;
    }
    std::array<double, 6> stretch(const double x, const double y)
    {
      return {1e-3 * (x + y / 2.), 1e-3 * (y + x / 2.), 0., 0., 0., 0.};
    }
    std::array<double, 6> bend(const double x, const double y)
    {
      return {0., 0., 0.5e-3 * (x * x + x * y + y * y), 0.5e-3 * (x + 2. * y), -0.5e-3 * (2. * x + y), 0.};
    }
  } // namespace

  // The finite-increment tangent is exact to 1e-13 of the membrane stiffness, and bending is softer by (t/L)^2, 1e-5 at
  // worst; 1e-9 is what the benchmark asks of bending, 1e-10 of the membrane.

  TEST(ShellPatch, MembraneIsExactInAnyAttitude)
  {
    for (const auto formulation : all_formulations)
      for (const auto &[R, shift] : {std::pair<Matrix3<double>, Point3>(Matrix3<double>::Identity(), Point3::Zero()),
                                     {some_rotation, Point3::Zero()},
                                     {Matrix3<double>::Identity(), Point3(1000., -2000., 500.)}})
        {
          std::unique_ptr<Model> loaded;
          const double           error =
            patch_error(make_patch(), make_section(1e6, .25, formulation), 1e-3, R, shift, stretch, is_corner, &loaded);
          record(std::string(name_of(formulation)) + (shift.norm() > 0. ? " away" : ""), error);
          // at 2000 m a position has steps of 2.3e-13 m: 1e-9 of the displacements of 2.4e-4 m, in each of two
          // positions
          EXPECT_LT(error, shift.norm() > 0. ? 2e-9 : 1e-9);
          for (std::size_t e = 0; e < 5; ++e)
            {
              const auto      s = loaded->elements.global_layer_stress(e, ShellLayer::top);
              Matrix3<double> S;
              S << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
              const Matrix3<double> local = R.transpose() * S * R * 1e12;
              EXPECT_NEAR(local(0, 0), 4000. / 3., 1e-5) << "element " << e;
              EXPECT_NEAR(local(1, 1), 4000. / 3., 1e-5) << "element " << e;
              EXPECT_NEAR(local(0, 1), 400., 1e-5) << "element " << e;
            }
        }
  }

  TEST(ShellPatch, BendingIsExactOnIrregularMeshes)
  {
    for (const auto formulation : covariant_formulations)
      for (const double thickness : {0.001, 0.005, 0.02, 0.05})
        {
          std::unique_ptr<Model> loaded;
          const double error = patch_error(make_patch(), make_section(1e6, .25, formulation), thickness, some_rotation,
                                           Point3(1., -2., .5), bend, is_corner, &loaded);
          record(std::string(name_of(formulation)) + " " + std::to_string(thickness).substr(0, 5), error);
          EXPECT_LT(error, 1e-9) << name_of(formulation) << ", thickness " << thickness;
          for (std::size_t e = 0; e < 5; ++e)
            {
              const auto      s = loaded->elements.global_layer_stress(e, ShellLayer::top);
              Matrix3<double> S;
              S << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
              // at the outermost point through the thickness; the benchmark's numbers are those of the face
              const ThicknessPoints &rule  = loaded->elements.thickness_points(e);
              const double           scale = 1e12 * 1e-3 / thickness / rule.position[rule.n - 1];
              const Matrix3<double>  local = scale * some_rotation.transpose() * S * some_rotation;
              EXPECT_NEAR(local(0, 0), -0.66667, 1e-5);
              EXPECT_NEAR(local(1, 1), -0.66667, 1e-5);
              EXPECT_NEAR(local(0, 1), -0.2, 1e-5);
            }
        }
  }

  TEST(ShellPatch, PlainBelytschkoTsayPassesBendingOnRectanglesOnly)
  {
    const auto bt = make_section(1e6, .25, ShellFormulation::belytschko_tsay);
    for (const double shear : {0., 0.3})
      {
        const Mesh grid = make_grid(
          3, 3, [shear](const double x, const double y) { return Point3(0.24 * x + shear * 0.12 * y, 0.12 * y, 0.); });
        EXPECT_LT(patch_error(grid, bt, 1e-3, some_rotation, Point3::Zero(), bend,
                              [](const std::size_t n) { return n % 4 == 0 || n % 4 == 3 || n / 4 == 0 || n / 4 == 3; }),
                  1e-7);
      }
    const double error = patch_error(make_patch(), bt, 1e-3, some_rotation, Point3::Zero(), bend, is_corner);
    record("irregular", error);
    EXPECT_GT(error, 0.01) << "the documented failure has gone; so may this test";
  }
} // namespace shell_patch_test
