#include "free_masses.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace birdstrike;
using birdstrike::test::FreeMasses;
using birdstrike::test::without_damper;

/// Points between the leaves of one folded sheet: each leaf is met, and remembered, for itself.
namespace
{
  constexpr double clearance = 1.4e-3; // between middle surfaces of 1 mm: a point of 1 mm is held by both

  /// A sheet of 1 mm, folded about x = -10 mm, its facets a quarter of a point. The upper leaf ends at x = 0, the lower
  /// one at 1 mm.
  FreeMasses folded_sheet()
  {
    FreeMasses             scene;
    constexpr unsigned int n = 40;
    scene.add_patch(2 * n + 2, 4, 1e-3, [](const unsigned int i, const unsigned int j) {
      const double y = 2.5e-3 * j;
      if (i <= n)
        return Point3(-1e-2 * i / n, y, clearance);
      return i == n + 1 ? Point3(-1e-2 - 0.5 * clearance, y, 0.5 * clearance)
                        : Point3(-1e-2 + 1.1e-2 * (i - n - 2) / n, y, 0.);
    });
    return scene;
  }

  /// J, of contact on the point, which goes round the corners from out of touch to out of touch.
  double work_along(FreeMasses &scene, Contact &contact, const std::vector<Point3> &corner)
  {
    ThreadPool   pool;
    const double n_steps = 2000.;
    double       work    = 0.;
    Point3       before  = Point3::Zero();
    for (std::size_t n = 0; n < corner.size(); ++n)
      for (double m = 1.; m <= n_steps; ++m)
        {
          const Point3 move = (corner[(n + 1) % corner.size()] - corner[n]) / n_steps;
          scene.place(0, corner[n] + m * move);
          scene.compute_contact(contact, 1e-7, pool);
          work += 0.5 * (before + scene.force_on_point(0)).dot(move);
          before = scene.force_on_point(0);
        }
    return work;
  }
} // namespace

// Nearest and second leaf change places, and a leaf comes near that was out of reach: what the point knows of one is no
// depth in the other.
TEST(FoldedTarget, NoClosedPathBetweenTheLeavesGainsEnergy)
{
  FreeMasses scene = folded_sheet();
  scene.add_point({Point3(0.05, 0.005, 0.)});
  Contact    contact(without_damper());
  ThreadPool pool;
  scene.compute_contact(contact, 1e-7, pool);
  std::mt19937                           random(4711);
  std::uniform_real_distribution<double> between(0., 1.);
  double                                 least = 0.;
  for (unsigned int loop = 0; loop < 30; ++loop)
    {
      std::vector<Point3> corner{Point3(5e-3, 0.0047, 0.5 * clearance)};
      for (unsigned int n = 0; n < 12; ++n)
        corner.push_back(Point3(-4e-3 + 6e-3 * between(random), 0.0047, clearance * (0.35 + 0.3 * between(random))));
      const double work = work_along(scene, contact, corner);
      // a force of up to 300 N ends at once where a leaf is lost: half a step, 1.5 um, of the trapezoidal rule
      EXPECT_LT(work, 300. * 1.5e-6) << loop;
      least = std::min(least, work);
    }
  EXPECT_LT(least, 0.) << "some were in touch where they changed leaves";
}

// The wall of a notch comes to be opposed to its floor beside a point that flies along both: it was there before.
TEST(FoldedTarget, ASecondSheetGivesNoDepthThatHasNotBeenFlown)
{
  constexpr double g = 1.5e-3; // offset of a 1 mm point from a plate of 2 mm
  FreeMasses       scene;
  scene.add_patch(2, 1, 2e-3, [](const unsigned int i, const unsigned int j) {
    return i < 2 ? Point3(0.01 * i - 0.01, 0.01 * j, 0.) : Point3(0., 0.01 * j, 0.01);
  });
  scene.add_point({Point3(0.2, 0.2, 0.2), Point3(0., 1500., 0.)});
  Contact    contact(without_damper());
  ThreadPool pool;
  scene.compute_contact(contact, 1e-7, pool);
  for (const double x : {-g - 1e-4, -g + 1e-4}) // the floor alone before, whose memory is not the wall's
    {
      scene.place(0, Point3(x, 0.005, g - 1.1e-4));
      scene.compute_contact(contact, 1e-7, pool);
    }
  EXPECT_EQ(contact.report().n_touching, 1u);
  EXPECT_NEAR((scene.force_on_point(0) - Point3(0., 0., 1e6 * 1.1e-4)).norm(), 0., 1e-6);
}
