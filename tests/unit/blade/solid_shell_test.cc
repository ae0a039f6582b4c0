#include "solid_harness.h"

#include <birdstrike/blade/solid_layers.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/material/radial_return.h>

#include <gtest/gtest.h>

using namespace solid_harness;

namespace
{
  constexpr double young = 113.8e9, yield = 880e3, t = 4.27e-3; // so soft that the geometry stays what it is

  SolidSection make_plastic(const unsigned int n_points, const ThicknessRule rule, const double poisson,
                            const HardeningLaw law = HardeningLaw::perfect)
  {
    SolidSection section             = make_section(young, poisson, SolidFormulation::solid_shell);
    section.material.hardening.law   = law;
    section.material.hardening.yield = yield;
    section.rule                     = rule;
    section.n_points                 = n_points;
    return section;
  }

  /// A square of one element, 20 mm by 20 mm by t, that is stretched and bent about y; y and z adjust as asked.
  struct Strip
  {
    Model model;

    explicit Strip(const SolidSection &section) : model(make_box({1, 1, 1}, Point3(0.02, 0.02, t)), section)
    {
    }

    /// Increments of strain and curvature (1/m) along x, of curvature and strain along y and of the strain along z.
    Eigen::VectorXd move(const double strain, const double curvature, const double lateral_curvature = 0.,
                         const double lateral = 0., const double across = 0.)
    {
      Eigen::VectorXd u = Eigen::VectorXd::Zero(24);
      for (std::size_t k = 0; k < 8; ++k)
        {
          const Point3 x = model.mesh.nodes[k] - Point3(0.01, 0.01, 0.5 * t);
          u[3 * k]       = (strain + curvature * x[2]) * x[0];
          u[3 * k + 1]   = (lateral + lateral_curvature * x[2]) * x[1];
          u[3 * k + 2]   = across * x[2];
        }
      return model.move(u);
    }

    /// Moment per width (N) of the forces on the face x = 20 mm.
    double moment(const Eigen::VectorXd &f) const
    {
      double sum = 0.;
      for (std::size_t k = 0; k < 8; ++k)
        if (model.mesh.nodes[k][0] > 0.01)
          sum -= f[3 * k] * (model.mesh.nodes[k][2] - 0.5 * t);
      return sum / 0.02;
    }
  };

  double plastic_moment(const ThicknessRule rule, const unsigned int n, const double curvature, const double lateral)
  {
    Strip strip(make_plastic(n, rule, 0.));
    // the geometry must not bend: a small element is enough
    return strip.moment(strip.move(0., curvature, lateral * curvature)) / (yield * t * t / 4.);
  }
} // namespace

// Benchmark A12: sum of w |z|; first yield is late by 1/|z_max|; without lateral curvature plane strain, 2/sqrt(3).
TEST(SolidShell, PlasticMomentIsThatOfTheIntegration)
{
  const double k_y = 2. * yield / young / t;
  for (const auto &[n, exact, late] :
       {std::tuple(3u, .860663, 1.290994), std::tuple(5u, .944850, 1.103534), std::tuple(7u, .9705387, 1.053612)})
    {
      Strip  strip(make_plastic(n, ThicknessRule::gauss, 0.));
      double last = 0.;
      for (int i = 0; i < 400; ++i)
        last = strip.moment(strip.move(0., 0.5 * k_y, -0.25 * k_y)) / (yield * t * t / 4.);
      std::printf("%u: %.7f (%.7f)\n", n, last, exact);
      std::printf("  first: %.9f %.9f\n",
                  plastic_moment(ThicknessRule::gauss, n, 0.9999 * late * k_y, 0.) / (2. / 3. * 0.9999 * late),
                  plastic_moment(ThicknessRule::gauss, n, 1.01 * late * k_y, 0.) / (2. / 3. * 1.01 * late));
    }
}
