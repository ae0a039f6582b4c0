#include "../record.h"
#include "solid_round_meshes.h"
#include "solid_statics.h"

#include <gtest/gtest.h>

namespace solid_sphere_test
{
  using namespace solid_harness;

  /// Thick sphere under internal pressure, an octant (benchmark B4): a = 0.1 m, b = 0.2 m, E = 200 GPa, nu = 0.3,
  /// 7850 kg/m^3, yield at 250 MPa. Elastic: Lame (1852); elastic-plastic: Hill (1950), p = 2 s_y ln(c/a) + 2/3 s_y (1
  /// - c^3/b^3) and u(b) = s_y (1 - nu) c^3/(E b^2) where the plastic zone ends at c.
  namespace
  {
    constexpr double inner = 0.1, outer = 0.2, young = 200e9, poisson = 0.3, density = 7850.;

    const auto formulations = {SolidFormulation::one_point, SolidFormulation::b_bar};

    SolidSection make_steel(const SolidFormulation formulation)
    {
      SolidSection section     = make_section(young, poisson, formulation);
      section.material.density = density;
      return section;
    }

    std::vector<bool> hold_planes(const Mesh &mesh)
    {
      std::vector<bool> held(3 * mesh.nodes.size());
      for (std::size_t d = 0; d < held.size(); ++d)
        held[d] = std::abs(mesh.nodes[d / 3][d % 3]) < 1e-9;
      return held;
    }

    bool is_at(const Point3 &x, const double radius)
    {
      return std::abs(x.norm() - radius) < 1e-9;
    }

    /// Of a pressure of 1 Pa on the inner facets.
    Eigen::VectorXd make_load(const Mesh &mesh)
    {
      Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * mesh.nodes.size());
      for (const auto &cell : mesh.cells)
        if (is_at(mesh.nodes[cell[0]], inner))
          {
            const auto   x    = [&](const int c) { return mesh.nodes[cell[c]]; };
            const Point3 area = 0.5 * (x(3) - x(0)).cross(x(2) - x(1)); // outwards: along the third direction
            for (int c = 0; c < 4; ++c)
              load.segment<3>(3 * cell[c]) += 0.25 * area;
          }
      return load;
    }

    /// Mean radial displacement of a face.
    double radial_displacement(const Mesh &mesh, const Eigen::VectorXd &u, const double radius)
    {
      double      sum = 0.;
      std::size_t n   = 0;
      for (std::size_t k = 0; k < mesh.nodes.size(); ++k)
        if (is_at(mesh.nodes[k], radius))
          {
            sum += u.segment<3>(3 * k).dot(mesh.nodes[k]) / radius;
            ++n;
          }
      return sum / double(n);
    }

    /// Largest hoop stress error of an element's mean, over the exact one where its middle is, and the hoop stress of
    /// the inner face: the straight line through the first two layers.
    struct HoopStress
    {
      double error, inner;
    };
    HoopStress hoop_stress(const Model &model, const double pressure, const unsigned int n_radius)
    {
      const double scale  = pressure * std::pow(inner, 3) / (std::pow(outer, 3) - std::pow(inner, 3));
      const double height = (outer - inner) / n_radius;
      HoopStress   result{0., 0.};
      double       layer[2] = {0., 0.};
      const double n_layer  = double(model.mesh.cells.size()) / n_radius;
      for (std::size_t e = 0; e < model.mesh.cells.size(); ++e)
        {
          Point3 x      = Point3::Zero();
          double radius = 0.;
          for (const auto k : model.mesh.cells[e])
            {
              x += 0.125 * model.mesh.nodes[k];
              radius += 0.125 * model.mesh.nodes[k].norm();
            }
          const auto            s = model.elements.state(e).stress;
          const Point3          r = x / x.norm();
          const Matrix3<double> S =
            (Matrix3<double>() << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2]).finished();
          const double hoop  = 0.5 * (S.trace() - r.dot(S * r)),
                       exact = scale * (1. + 0.5 * std::pow(outer / radius, 3));
          result.error       = std::max(result.error, std::abs(hoop / exact - 1.));
          if (radius < inner + 2. * height)
            layer[radius < inner + height ? 0 : 1] += hoop / n_layer;
        }
      result.inner = 1.5 * layer[0] - 0.5 * layer[1];
      return result;
    }

    /// Errors at 100 MPa: of the displacements at both faces, of the hoop stress of elements and of the inner face.
    std::array<double, 4> press(const unsigned int n_angle, const unsigned int n_radius,
                                const SolidFormulation formulation)
    {
      const Mesh            mesh    = make_octant(n_angle, n_radius, inner, outer);
      const SolidSection    section = make_steel(formulation);
      const Eigen::VectorXd u       = solve_by_gradients(mesh, section, 100e6 * make_load(mesh), hold_planes(mesh));
      Model                 model(mesh, section);
      model.move(1e-6 * u);
      const HoopStress stress = hoop_stress(model, 100., n_radius);
      return {std::abs(radial_displacement(mesh, u, inner) / 4e-5 - 1.),
              std::abs(radial_displacement(mesh, u, outer) / 1.5e-5 - 1.), stress.error,
              std::abs(stress.inner / 71.42857 - 1.)};
    }

    /// Displacements (m) of the outer face after slow rises to pressures (Pa), each held until the sphere is at rest,
    /// in perfect plasticity at 250 MPa. All of it a thousandth, for Hill's solution is of small strains: half a
    /// percent of stretch inside would be four percent of displacement near the limit.
    std::vector<double> yield_under(const std::vector<double> &pressures, const unsigned int n_angle,
                                    const unsigned int n_radius, const SolidFormulation formulation)
    {
      SolidSection section             = make_steel(formulation);
      section.material.hardening.law   = HardeningLaw::perfect;
      section.material.hardening.yield = 250e3;
      const Mesh            mesh       = make_octant(n_angle, n_radius, inner, outer);
      Model                 model(mesh, section);
      Motion                motion(model);
      const Eigen::VectorXd load = make_load(mesh);
      Eigen::VectorXd       mass(model.n_dofs()), u = Eigen::VectorXd::Zero(model.n_dofs());
      for (std::size_t d = 0; d < model.n_dofs(); ++d)
        mass[d] = motion.mass[d / 3];
      motion.held                = hold_planes(mesh);
      const double        period = 1. / 9417.05, damping = 2. * M_PI / period; // half critical for the breathing
      std::vector<double> result;
      double              last = 0.;
      for (const double pressure : pressures)
        {
          const double rise = 3. * period;
          for (double t = 0.;
               t < rise || motion.velocity.cwiseAbs().maxCoeff() * period > 1e-4 * u.cwiseAbs().maxCoeff();)
            {
              const double dt = 0.9 * model.elements.largest_stable_step();
              t += dt;
              motion.force += 1e-3 * (last + std::min(1., t / rise) * (pressure - last)) * load -
                              damping * mass.cwiseProduct(motion.velocity);
              motion.step(dt);
              u += motion.increment;
            }
          last = pressure;
          result.push_back(1e3 * radial_displacement(mesh, u, outer));
        }
      return result;
    }

    /// Frequency (Hz) of the motion that starts in a mode, u_r = A j_1(k r) + B y_1(k r), of the continuum.
    double breathing_frequency(const double exact, const unsigned int n_angle, const unsigned int n_radius,
                               const SolidFormulation formulation)
    {
      const double lambda = young * poisson / ((1. + poisson) * (1. - 2. * poisson)),
                   shear  = young / (2. * (1. + poisson));
      const double k      = 2. * M_PI * exact / std::sqrt((lambda + 2. * shear) / density);
      const auto   j1     = [](const double x) { return std::sin(x) / x / x - std::cos(x) / x; };
      const auto   y1     = [](const double x) { return -std::cos(x) / x / x - std::sin(x) / x; };
      // f' = (x f_0 - 2 f_1)/x with f_0 = sin x/x and -cos x/x; the radial stress at the inner face
      const double x = k * inner, weight = (lambda + 2. * shear) * k, hoop = 2. * lambda / inner;
      const double of_j = weight * (std::sin(x) / x - 2. * j1(x) / x) + hoop * j1(x);
      const double of_y = weight * (-std::cos(x) / x - 2. * y1(x) / x) + hoop * y1(x);

      const Mesh      mesh = make_octant(n_angle, n_radius, inner, outer);
      Model           model(mesh, make_steel(formulation));
      Motion          motion(model);
      Eigen::VectorXd shape(model.n_dofs()), weighted(model.n_dofs());
      motion.held = hold_planes(mesh);
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        {
          const double r             = mesh.nodes[n].norm();
          shape.segment<3>(3 * n)    = (of_y * j1(k * r) - of_j * y1(k * r)) * mesh.nodes[n] / r;
          weighted.segment<3>(3 * n) = motion.mass[n] * shape.segment<3>(3 * n);
        }
      motion.velocity      = 1e-9 / shape.cwiseAbs().maxCoeff() * shape;
      const double dt      = 0.5 * model.elements.largest_stable_step();
      double       last[3] = {}, products = 0., squares = 0.;
      for (int step = 0; step < 100; ++step)
        {
          motion.step(dt);
          last[0] = last[1];
          last[1] = last[2];
          last[2] += motion.increment.dot(weighted);
          products += last[1] * (last[0] + last[2]);
          squares += 2. * last[1] * last[1];
        }
      return 2. / dt * std::sin(0.5 * std::acos(products / squares)) / (2. * M_PI);
    }
  } // namespace

  // Displacements of both faces, and the hoop stress of the inner face from the first two layers; the stress of any
  // element where its middle is (first order beside the axis on which three blocks meet). 1 % with 20 layers is asked.
  TEST(SolidSphere, ElasticConvergesAtOrderTwo)
  {
    for (const auto formulation : formulations)
      {
        const auto coarse = press(5, 10, formulation), fine = press(10, 20, formulation);
        for (int i = 0; i < 4; ++i)
          {
            record("error " + std::to_string(i) + " of " + std::to_string(int(formulation)), fine[i]);
            EXPECT_LT(fine[i], 0.01) << i;
            EXPECT_NEAR(std::log2(coarse[i] / fine[i]), i == 2 ? 1. : 2., 0.3) << i;
          }
      }
  }

  // 1 % with 20 layers is asked; measured there +0.31, -0.33, -0.66 % (either brick), with the 10 of this test -1.0,
  // -1.3, -2.9 %: twice to four times the 1 %, the last at 97 % of the limit load, where the displacement is 14 times
  // as sensitive to the pressure as at first.
  TEST(SolidSphere, YieldsAsHillsSphere)
  {
    const std::vector<double> pressures = {237.548e6, 299.087e6, 334.821e6}; // c/a = 1.25, 1.5, 1.75
    const double              exact[3] = {4.27246e-5, 7.38281e-5, 1.172363e-4}, tolerance[3] = {0.02, 0.02, 0.04};
    for (const auto formulation : formulations)
      {
        const auto u = yield_under(pressures, 5, 10, formulation);
        for (int i = 0; i < 3; ++i)
          {
            record("u " + std::to_string(i) + " of " + std::to_string(int(formulation)), u[i]);
            EXPECT_NEAR(u[i] / exact[i], 1., tolerance[i]) << i;
          }
      }
  }

  // 1 % with 20 layers, order 2: measured 1e-4, 0.18 %, 0.49 %, and four times that with 10.
  TEST(SolidSphere, BreathesAtItsFrequencies)
  {
    for (const auto formulation : formulations)
      for (const auto &[exact, tolerance] : {std::pair(9417.05, 0.001), {31061.3, 0.0075}, {59424.6, 0.02}})
        {
          const double coarse = std::abs(breathing_frequency(exact, 5, 10, formulation) / exact - 1.);
          EXPECT_LT(coarse, tolerance);
          const double fine = std::abs(breathing_frequency(exact, 10, 20, formulation) / exact - 1.);
          record(std::to_string(int(exact)) + " Hz of " + std::to_string(int(formulation)), fine);
          EXPECT_LT(fine, 0.3 * tolerance);
          EXPECT_NEAR(std::log2(coarse / fine), 2., 0.2);
        }
  }
} // namespace solid_sphere_test
