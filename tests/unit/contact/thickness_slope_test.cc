#include "free_masses.h"

#include "contact/touch/thickness_slope.h"
#include <birdstrike/core/closest_point.h>

#include <gtest/gtest.h>

#include <random>

using namespace birdstrike;
using birdstrike::test::FreeMasses;
using birdstrike::test::without_damper;

namespace
{
  double thickness_at(const Point3 &p, const std::array<Point3, 4> &x, const std::array<double, 4> &t)
  {
    const auto q   = compute_closest_point(p, x);
    double     sum = 0.;
    for (unsigned int k = 0; k < 4; ++k)
      sum += q.weights[k] * t[k];
    return sum;
  }

  /// 40 by 20 mm, 2 mm thick at x = 0 and 6 mm at the other end: each face 1 : 20 to the middle surface.
  FreeMasses wedge()
  {
    FreeMasses scene;
    scene.add_plate(8, 4, 5e-3, 2e-3);
    for (std::size_t f = 0; f < scene.facet.size(); ++f)
      scene.half_thickness[f] = 1e-3 + 0.05 * (2.5e-3 + 5e-3 * static_cast<double>(f % 8));
    return scene;
  }
} // namespace

// Against differences of the half thickness at the closest point: warped facets and triangles, points over and beside
// them, whose closest points lie in faces, on creases, edges and corners.
TEST(ThicknessSlope, IsTheGradientOfWhatThePointSees)
{
  std::mt19937                           random(5);
  std::uniform_real_distribution<double> any(-1., 1.);
  constexpr double                       h         = 1e-6;
  unsigned int                           n_sloping = 0, n_level = 0;
  for (unsigned int n = 0; n < 1000; ++n)
    {
      std::array<Point3, 4> x{Point3(0., 0., 0.), Point3(1., 0., 0.), Point3(1., 1., 0.), Point3(0., 1., 0.)};
      std::array<double, 4> t{};
      for (unsigned int k = 0; k < 4; ++k)
        {
          x[k] += 0.2 * Point3(any(random), any(random), any(random));
          t[k] = 0.02 * any(random);
        }
      if (n % 4 == 0)
        {
          x[3] = x[2];
          t[3] = t[2];
        }
      const Point3 p(0.5 + any(random), 0.5 + any(random), any(random));
      const double here = thickness_at(p, x, t);
      Point3       difference;
      bool         is_smooth = true; // within h: not where the closest point passes to another feature
      for (unsigned int d = 0; d < 3; ++d)
        {
          const double ahead  = thickness_at(p + h * Point3::Unit(d), x, t),
                       behind = thickness_at(p - h * Point3::Unit(d), x, t);
          difference[d]       = (ahead - behind) / (2. * h);
          is_smooth           = is_smooth && std::abs(ahead - 2. * here + behind) < 1e-4 * h;
        }
      if (!is_smooth)
        continue;
      const Point3 slope = compute_thickness_slope(x, t, compute_closest_point(p, x).weights);
      EXPECT_NEAR((difference - slope).norm(), 0., 2e-4) << n; // what is_smooth lets pass, and round-off over h
      ++(slope.norm() > 0. ? n_sloping : n_level);
    }
  EXPECT_GT(n_sloping, 500u);
  EXPECT_GT(n_level, 50u); // corners
}

// Points come down on a wedge at an angle and slide up its slope or down: nothing takes energy here, momentum
// stays. A force along the normal of the middle surface leaves or takes 5 % of the impulse times the slip.
TEST(ThicknessSlope, PointsThatSlideAlongAWedgeKeepTheirEnergy)
{
  for (const double along : {300., -300.})
    {
      FreeMasses scene = wedge();
      for (auto &node : scene.node)
        node.inverse_mass = 1e3;
      for (unsigned int n = 0; n < 40; ++n)
        scene.add_point({Point3(0.02 - 2e-5 * along + 2.3e-4 * n, 2e-3 + 4e-4 * n, 4.6e-3), Point3(along, 10., -60.)});
      Contact      contact(without_damper());
      ThreadPool   pool;
      const double step = 1e-8, before = 40. * 0.5e-6 * (along * along + 100. + 3600.);
      scene.compute_contact(contact, step, pool);
      const Point3 momentum = scene.momentum();
      double       most     = 0.;
      for (unsigned int n = 0; n < 8000; ++n)
        {
          scene.advance(contact, step, pool);
          most = std::max(most, contact.report().stored_energy);
        }
      EXPECT_GT(most, 0.05 * 40. * 0.5e-6 * 3600.) << "some were in touch";
      EXPECT_EQ(contact.report().n_touching, 0u);
      // facets turn and steps are finite; 0.03 to 0.05 along the normal of the middle
      EXPECT_NEAR(scene.contact_work / before, 0., 2e-4);
      EXPECT_NEAR((scene.momentum() - momentum).norm() / momentum.norm(), 0., 1e-12);
    }
}
