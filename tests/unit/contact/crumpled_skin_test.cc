#include "free_masses.h"
#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/core/closest_point.h>

#include <gtest/gtest.h>

using namespace birdstrike;
using birdstrike::test::FreeMasses;
using birdstrike::test::h;
using birdstrike::test::k;

/// One-sided surfaces as soft bricks leave them: terraces of facets smaller than a point, facets that are folded.
namespace
{
  /// The force on the only point, lowered from 1.6 h to a height (m) over (x, y, 0).
  Point3 lower(FreeMasses &scene, const double x, const double y, const double height)
  {
    ContactParameters parameters;
    parameters.damping_scale = 0.;
    scene.two_sided          = false;
    scene.add_point({Point3(x, y, 1.6 * h)});
    Contact    contact(parameters);
    ThreadPool pool;
    scene.compute_contact(contact, 1e-7, pool);
    for (double z = 1.6 * h; z > height; z -= 1e-6)
      {
        scene.fly_to(0, Point3(x, y, z), 1e-7);
        scene.compute_contact(contact, 1e-7, pool);
      }
    scene.fly_to(0, Point3(x, y, height), 1e-7);
    scene.compute_contact(contact, 1e-7, pool);
    return scene.force_on_point(0);
  }
} // namespace

// A floor, a wall of 0.3 mm and what goes on at its upper edge: the plane that halves that ridge leaves the surface at
// the wall's foot, and beyond it takes nothing off the floor, 0.4 to 0.7 mm from the wall.
TEST(CrumpledSkin, AFloorBesideAWallHoldsBeyondThePlaneOfTheWallsEdge)
{
  constexpr double rise = 0.3e-3, facet = 0.2e-3;
  constexpr int    n_floor = 20;
  for (const double from_wall : {0.4e-3, 0.5e-3, 0.7e-3})
    {
      FreeMasses scene;
      scene.add_patch(2 * n_floor + 1, 20, 0., [](const unsigned int i, const unsigned int j) {
        const bool   is_floor = i <= n_floor;
        const double x        = (static_cast<int>(i) - n_floor - (is_floor ? 0 : 1)) * facet;
        return Point3(x, j * facet, is_floor ? 0. : rise);
      });
      const Point3 force = lower(scene, -from_wall, 10.3 * facet, 0.8 * h);
      EXPECT_NEAR(force[2], 0.2 * h * k, 1e-3 * h * k) << from_wall;
      EXPECT_NEAR(force[0], 0., 1e-3 * h * k) << from_wall;
    }
}

// The four nodes of a facet lie so that its mean normal looks down, and that of one triangle of its fan up.
TEST(CrumpledSkin, OverAnOverturnedTriangleOfAFacetItsOwnNormalSaysWhatIsOutside)
{
  constexpr double                                      size = 6e-3;
  static constexpr std::array<std::array<double, 3>, 4> corner{
    {{1.5, 1., 0.5}, {0., 0., 0.}, {1., 0., 0.}, {-0.5, 1., -0.5}}};
  FreeMasses scene;
  scene.add_patch(1, 1, 0., [](const unsigned int i, const unsigned int j) {
    const auto &x = corner[j == 0 ? i : 3 - i];
    return Point3(size * x[0], size * x[1], size * x[2]);
  });
  ASSERT_LT(compute_area_vector(facet_nodes(scene.facets(), 0))[2], 0.);
  EXPECT_NEAR(lower(scene, 0.5 * size, 0.22 * size, 0.8 * h)[2], 0.2 * h * k, 1e-3 * h * k);
}

// The plane at a ridge turns with both facets: unless their dampers are equal, their forces turn the surface otherwise
// than the point is turned.
TEST(CrumpledSkin, DampersAtARidgeOfUnequalFacetsKeepAngularMomentum)
{
  FreeMasses scene;
  scene.two_sided = false;
  // a wall of 2.5 mm and a top sheared to 53 degrees
  scene.add_patch(1, 2, 0., [](const unsigned int i, const unsigned int j) {
    return Point3(8e-3 * i - (j == 2 ? 6e-3 : 0.), j == 2 ? 8e-3 : 0., j == 0 ? -2.5e-3 : 0.);
  });
  for (std::size_t n = 0; n < scene.node.size(); ++n)
    scene.node[n].inverse_mass = 1e5 * double(1 + n);
  for (const double along : {2e-3, 3e-3, 5e-3})
    scene.add_point({Point3(along, 0.45e-3, 0.52e-3), Point3(0., -5., -50.)});
  const auto angular_momentum = [&scene] {
    Point3 sum(0., 0., 0.);
    for (std::size_t i = 0; i < scene.id.size(); ++i)
      sum += scene.mass[i] * scene.position(i).cross(scene.velocity(i));
    for (const FreeMasses::Node &n : scene.node)
      sum += n.position.cross(n.velocity) / n.inverse_mass;
    return sum;
  };
  const Point3 before = angular_momentum();
  Contact      contact{ContactParameters()};
  ThreadPool   pool;
  scene.compute_contact(contact, 1e-7, pool);
  for (unsigned int n = 0; n < 100; ++n)
    scene.advance(contact, 1e-7, pool);
  EXPECT_GT(contact.report().touches, 60u);
  EXPECT_LT((angular_momentum() - before).norm(), 1e-12 * before.norm());
}
