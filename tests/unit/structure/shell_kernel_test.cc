#include "structure/elements/shell/belytschko_tsay.h"
#include "structure/elements/shell/full_integration.h"
#include "structure/elements/shell/section.h"
#include "structure/elements/shell/step_bound.h"

#include <gtest/gtest.h>

namespace shell_kernel_test
{
  using namespace birdstrike;

  namespace
  {
    /// A warped element with tilted normals, moved by something; a little different in every lane.
    template <class Number>
    struct Sample
    {
      Vector3<Number> corner[4], normal[4], displacement[4], rotation[4];

      template <class Make>
      explicit Sample(const Make &make)
      {
        const double x[4] = {0., 1., 1.1, 0.1}, y[4] = {0., 0.1, 1.2, 0.9};
        for (int i = 0; i < 4; ++i)
          {
            const int seed = 12 * i;
            corner[i] << make(x[i], 0.1, seed), make(y[i], 0.1, seed + 1), make(0., 0.2, seed + 2);
            normal[i] << make(0., 0.1, seed + 3), make(0., 0.1, seed + 4), make(1., 0., seed + 5);
            displacement[i] << make(0., 1e-3, seed + 6), make(0., 1e-3, seed + 7), make(0., 1e-3, seed + 8);
            rotation[i] << make(0., 1e-3, seed + 9), make(0., 1e-3, seed + 10), make(0., 1e-3, seed + 11);
            normal[i] *= Number(1.) / sqrt(normal[i].dot(normal[i]));
          }
      }
    };

    double value(const double mean, const double scatter, const int seed, const std::size_t k)
    {
      return mean + scatter * std::sin(1.3 * seed + 0.7 * k);
    }

    template <class Number>
    std::array<Number, 14> strains(const Sample<Number> &s, const bool physical)
    {
      const auto          g = ShellGeometry<Number>::of_corners(s.corner, s.normal);
      ShellVector<Number> e;
      if (physical)
        {
          Vector3<Number> director[4];
          for (int i = 0; i < 4; ++i)
            director[i] = s.rotation[i].cross(g.director[i]);
          e = physical_shell::compute_strains(g, ShellModes<Number>::of_corners(s.displacement),
                                              ShellModes<Number>::of_corners(director));
        }
      else
        e = BelytschkoTsay<Number>(g, Number(0.1), 0.05).compute_strains(s.displacement, s.rotation, s.normal);
      return {e.membrane[0],
              e.membrane[1],
              e.membrane[2],
              e.curvature[0],
              e.curvature[1],
              e.curvature[2],
              e.shear[0],
              e.shear[1],
              e.linear_membrane[0],
              e.linear_membrane[1],
              e.linear_curvature[0],
              e.linear_curvature[1],
              e.linear_shear[0],
              e.linear_shear[1]};
    }

    /// Geometry, plane and strains at the points of full integration.
    template <class Number>
    struct Points
    {
      ShellGeometry<Number>                   g;
      full_integration::PlaneGeometry<Number> plane;
      SectionVector<Number>                   strain[4];

      explicit Points(const Sample<Number> &s) : g(ShellGeometry<Number>::of_corners(s.corner, s.normal)), plane(g, 0.3)
      {
        Vector3<Number> director[4];
        for (int i = 0; i < 4; ++i)
          director[i] = s.rotation[i].cross(g.director[i]);
        const auto amplitudes = full_integration::compute_strains(g, ShellModes<Number>::of_corners(s.displacement),
                                                                  ShellModes<Number>::of_corners(director));
        full_integration::compute_point_strains(plane, full_integration::DirectorGradient<Number>(g), amplitudes,
                                                strain);
      }

      std::array<Number, 8> strains(const int k) const
      {
        const auto &e = strain[k];
        return {e.membrane[0],  e.membrane[1],  e.membrane[2], e.curvature[0],
                e.curvature[1], e.curvature[2], e.shear[0],    e.shear[1]};
      }
    };
  } // namespace

  TEST(ShellKernel, LanesAgreeWithDoubles)
  {
    const Sample<Lanes> lanes([](const double mean, const double scatter, const int seed) {
      return Lanes([&](const auto k) { return value(mean, scatter, seed, k); });
    });
    for (const bool physical : {true, false})
      {
        const auto batch = strains(lanes, physical);
        for (std::size_t k = 0; k < n_lanes; ++k)
          {
            const Sample<double> one(
              [k](const double mean, const double scatter, const int seed) { return value(mean, scatter, seed, k); });
            const auto single = strains(one, physical);
            for (int c = 0; c < 14; ++c)
              EXPECT_NEAR(batch[c][k], single[c], 1e-16) << "component " << c << ": round-off of strains of 1e-3";
          }
      }
  }

  TEST(ShellKernel, ForcesAreTheTransposeOfStrains)
  {
    // sum f.u + m.theta = A (N.e + M.k + Q.g + a third of the linear parts) for independent resultants and motions
    const Sample<double> s(
      [](const double mean, const double scatter, const int seed) { return value(mean, scatter, seed, 3); });
    const auto g = ShellGeometry<double>::of_corners(s.corner, s.normal);
    for (const bool physical : {true, false})
      {
        ShellVector<double> r{{{1., 2., -3.}, {0.5, -1.5, 0.7}, {2.5, -0.4}}, {1.1, -2.1}, {0.9, 0.3}, {-0.8, 1.7}};
        Vector3<double>     force[4], moment[4], director_force[4];
        if (physical)
          {
            ShellModes<double> f, fd;
            physical_shell::compute_mode_forces(g, r, f, fd);
            f.sum_at_corners(force);
            fd.sum_at_corners(director_force);
            for (int i = 0; i < 4; ++i)
              moment[i] = g.director[i].cross(director_force[i]);
          }
        else
          BelytschkoTsay<double>(g, 0.1, 0.05).compute_corner_forces(r, s.normal, force, moment);
        double nodal = 0.;
        for (int i = 0; i < 4; ++i)
          nodal += force[i].dot(s.displacement[i]) + moment[i].dot(s.rotation[i]);
        const auto   e = strains(s, physical);
        const double w = r.membrane[0] * e[0] + r.membrane[1] * e[1] + r.membrane[2] * e[2] + r.curvature[0] * e[3] +
                         r.curvature[1] * e[4] + r.curvature[2] * e[5] + r.shear[0] * e[6] + r.shear[1] * e[7];
        const double linear = r.linear_membrane[0] * e[8] + r.linear_membrane[1] * e[9] +
                              r.linear_curvature[0] * e[10] + r.linear_curvature[1] * e[11] +
                              r.linear_shear[0] * e[12] + r.linear_shear[1] * e[13];
        EXPECT_NEAR(nodal, g.area * (w + linear / 3.), 1e-16) << "physical " << physical;
      }
  }

  TEST(ShellKernel, WarpedElementsTurnWithoutStrain)
  {
    // a rotation of the whole about the origin: no strain, no hourglass; so the forces, its transpose, have no moment
    Sample<double> s(
      [](const double mean, const double scatter, const int seed) { return value(mean, scatter, seed, 3); });
    const Vector3<double> turn(3e-3, -5e-3, 2e-3);
    for (int i = 0; i < 4; ++i)
      {
        s.displacement[i] = turn.cross(s.corner[i]);
        s.rotation[i]     = turn;
      }
    for (const bool physical : {true, false})
      {
        const auto e = strains(s, physical);
        for (int c = 0; c < 14; ++c)
          EXPECT_NEAR(e[c], 0., 1e-16) << "component " << c << ", physical " << physical;
      }
  }

  TEST(ShellKernel, FullIntegrationOnLanesAgreesWithDoubles)
  {
    const Points<Lanes> lanes(Sample<Lanes>([](const double mean, const double scatter, const int seed) {
      return Lanes([&](const auto k) { return value(mean, scatter, seed, k); });
    }));
    for (std::size_t k = 0; k < n_lanes; ++k)
      {
        const Points<double> one(Sample<double>(
          [k](const double mean, const double scatter, const int seed) { return value(mean, scatter, seed, k); }));
        for (int point = 0; point < 4; ++point)
          for (int c = 0; c < 8; ++c)
            EXPECT_NEAR(lanes.strains(point)[c][k], one.strains(point)[c], 1e-16) << "point " << point << ", " << c;
      }
  }

  TEST(ShellKernel, FullIntegrationOfForcesIsTheTransposeOfStrains)
  {
    // sum f.u + m.theta = sum over the points of area (N.e + M.k + Q.g), the resultants of each point at random
    const Sample<double> s(
      [](const double mean, const double scatter, const int seed) { return value(mean, scatter, seed, 3); });
    const Points<double>  points(s);
    SectionVector<double> resultants[4];
    double                power = 0., area = 0.;
    for (int k = 0; k < 4; ++k)
      {
        for (int c = 0; c < 3; ++c)
          {
            resultants[k].membrane[c]  = std::sin(1. + 3. * k + c);
            resultants[k].curvature[c] = std::cos(2. + 5. * k + c);
            power += points.plane.point[k].area * (resultants[k].membrane[c] * points.strain[k].membrane[c] +
                                                   resultants[k].curvature[c] * points.strain[k].curvature[c]);
          }
        for (int c = 0; c < 2; ++c)
          {
            resultants[k].shear[c] = std::sin(7. * k - c);
            power += points.plane.point[k].area * resultants[k].shear[c] * points.strain[k].shear[c];
          }
        area += points.plane.point[k].area;
      }
    ShellModes<double> f, fd;
    full_integration::compute_mode_forces(
      points.g,
      full_integration::integrate_resultants(points.plane, full_integration::DirectorGradient<double>(points.g),
                                             resultants),
      f, fd);
    Vector3<double> force[4], director_force[4];
    f.sum_at_corners(force);
    fd.sum_at_corners(director_force);
    double nodal = 0.;
    for (int i = 0; i < 4; ++i)
      nodal += force[i].dot(s.displacement[i]) + points.g.director[i].cross(director_force[i]).dot(s.rotation[i]);
    EXPECT_NEAR(nodal, power, 1e-16);
    EXPECT_NEAR(area, points.g.area, 1e-15) << "the points share the element's area";
  }

  TEST(ShellKernel, FullIntegrationHasTheStrainsOfAConstantStateAtEveryPoint)
  {
    // u = H x and rotations of w: a plane element with any corners; membrane, curvature and transverse shear constant
    Sample<double> s(
      [](const double mean, const double scatter, const int seed) { return value(mean, scatter, seed, 1); });
    for (int i = 0; i < 4; ++i)
      {
        s.corner[i][2] = 0.;
        s.normal[i]    = Vector3<double>(0., 0., 1.);
        const double x = s.corner[i][0], y = s.corner[i][1];
        s.displacement[i] << 1e-3 * x + 2e-3 * y, 3e-3 * x - 1e-3 * y, 4e-3 * x - 2e-3 * y;
        // the director moves by (k x + l y + shear, ...)
        s.rotation[i] << -(2e-3 * x + 1e-3 * y + 6e-3), 5e-3 * x + 3e-3 * y - 1e-3, 0.;
      }
    const Points<double>  points(s);
    const Vector3<double> e1 = points.g.compute_e1(), e2 = points.g.compute_e2();
    Matrix3<double>       membrane, curvature;
    membrane << 1e-3, 2.5e-3, 0., 2.5e-3, -1e-3, 0., 0., 0., 0.;
    curvature << 5e-3, 2.5e-3, 0., 2.5e-3, 1e-3, 0., 0., 0., 0.;
    for (int k = 0; k < 4; ++k)
      {
        const auto e = points.strains(k);
        EXPECT_NEAR(e[0], e1.dot(membrane * e1), 1e-16);
        EXPECT_NEAR(e[1], e2.dot(membrane * e2), 1e-16);
        EXPECT_NEAR(e[2], 2. * e1.dot(membrane * e2), 1e-16);
        EXPECT_NEAR(e[3], e1.dot(curvature * e1), 1e-16);
        EXPECT_NEAR(e[4], e2.dot(curvature * e2), 1e-16);
        EXPECT_NEAR(e[5], 2. * e1.dot(curvature * e2), 1e-16);
      }
  }

  TEST(ShellKernel, FullIntegrationHasTheShearOfAConstantStateAtEveryPoint)
  {
    // rigid directors tilted against a rotated plane of any corners
    Sample<double> s(
      [](const double mean, const double scatter, const int seed) { return value(mean, scatter, seed, 2); });
    for (int i = 0; i < 4; ++i)
      {
        s.corner[i][2] = 0.;
        s.normal[i]    = Vector3<double>(0., 0., 1.);
        s.displacement[i] << 0., 0., 4e-3 * s.corner[i][0] - 2e-3 * s.corner[i][1];
        s.rotation[i] << 6e-3, -1e-3, 0.; // director: (-1e-3, -6e-3, 0)
      }
    const Points<double>  points(s);
    const Vector3<double> e1 = points.g.compute_e1(), e2 = points.g.compute_e2(), shear(3e-3, -8e-3, 0.);
    for (int k = 0; k < 4; ++k)
      {
        EXPECT_NEAR(points.strain[k].shear[0], e1.dot(shear), 1e-16);
        EXPECT_NEAR(points.strain[k].shear[1], e2.dot(shear), 1e-16);
      }
  }

  TEST(ShellKernel, BendingStrainIsTheChangeOfTheDirectorsGradient)
  {
    // a plane element of any corners is strained in its plane, its tilted directors stay: the trace of b, which needs
    // no frame, before and after; k alone, without the strain of the middle, is wrong by 2 e : b
    Sample<double> s(
      [](const double mean, const double scatter, const int seed) { return value(mean, scatter, seed, 1); });
    for (int i = 0; i < 4; ++i)
      {
        s.corner[i][2] = 0.;
        const double x = s.corner[i][0], y = s.corner[i][1];
        s.normal[i]       = Vector3<double>(0.1 * x - 0.05 * y, 0.03 * x + 0.08 * y, 1.).normalized();
        s.displacement[i] = Vector3<double>(1e-3 * x + 2e-3 * y, 3e-3 * x - 2e-3 * y, 0.);
        s.rotation[i]     = Vector3<double>::Zero();
      }
    const auto moved = [&](const double share) {
      Sample<double> result = s;
      for (int i = 0; i < 4; ++i)
        result.corner[i] += share * s.displacement[i];
      return Points<double>(result);
    };
    constexpr double small  = 1e-4;
    const auto       before = moved(-small), after = moved(small), at = moved(0.);
    const auto       trace = [](const physical_shell::Shifter<double> &shifter) { return shifter.b[0] + shifter.b[1]; };
    using Shifter          = physical_shell::Shifter<double>;
    const double change    = (trace(Shifter::at_centre(after.g)) - trace(Shifter::at_centre(before.g))) / (2. * small);
    const auto   e         = strains(s, true);
    EXPECT_GT(std::abs(change), 1e-5);
    EXPECT_NEAR(e[3] + e[4], change, 1e-6 * std::abs(change));
    for (int k = 0; k < 4; ++k)
      {
        const auto of = [&](const Points<double> &points) {
          return trace(full_integration::DirectorGradient<double>(points.g).at(points.plane, k));
        };
        const double of_point = (of(after) - of(before)) / (2. * small);
        EXPECT_NEAR(at.strains(k)[3] + at.strains(k)[4], of_point, 1e-6 * std::abs(of_point)) << "point " << k;
      }
  }
} // namespace shell_kernel_test
